// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/vcd_trace.hpp"

#include "simulator/output_file.hpp"

namespace simulator {

constexpr uint64_t kTicksPerCycle = 625;  // of 100 ps, at 16 MHz

static char symbol(size_t signal) { return static_cast<char>('!' + signal); }

VcdTrace::VcdTrace(const std::string& path, const std::vector<Signal>& signals)
    : path_(path), signals_(signals) {
    openChecked(file_, path, std::ios::out);
    file_ << "$timescale 100ps $end\n$scope module board $end\n";
    for (size_t i = 0; i < signals_.size(); i++)
        file_ << "$var wire " << signals_[i].bits << ' ' << symbol(i) << ' ' << signals_[i].name
              << " $end\n";
    file_ << "$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n";
    for (size_t i = 0; i < signals_.size(); i++) write(i, 0);
    file_ << "$end\n";
    if (!file_.flush())
        throw OutputError(path, errno);  // a full disk is reported before the flight
}

void VcdTrace::close() { closeChecked(file_, path_); }

void VcdTrace::change(size_t signal, unsigned value, uint64_t cycle) {
    if (cycle != cycle_) file_ << '#' << cycle * kTicksPerCycle << '\n';
    cycle_ = cycle;
    write(signal, value);
}

void VcdTrace::write(size_t signal, unsigned value) {
    if (signals_[signal].bits == 1) {
        file_ << value << symbol(signal) << '\n';
        return;
    }
    file_ << 'b';
    for (int bit = signals_[signal].bits; bit-- > 0;) file_ << (value >> bit & 1);
    file_ << ' ' << symbol(signal) << '\n';
}

}  // namespace simulator

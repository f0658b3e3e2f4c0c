// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/servo_pulses.hpp"

namespace simulator {
namespace {

// What stays high longer was no pulse: the output was taken from its timer meanwhile.
constexpr uint64_t kLongest = 10000 * kCyclesPer_us;

}  // namespace

ServoPulses::ServoPulses(Chip& chip, const BoardWiring& wiring)
    : chip_(chip), wires_(wiring.servos) {
    for (int i = 0; i < kOutputs; i++)
        chip.onCompareOutput(wires_[i].timer, wires_[i].compare,
                             [this, i](bool high, uint64_t cycle) { changed(i, high, cycle); });
}

void ServoPulses::changed(int index, bool high, uint64_t cycle) {
    if (!chip_.isOutput(wires_[index].pin.port, wires_[index].pin.bit)) return;
    Level& level = levels_[index];
    const bool ended = level.high && !high;
    const uint64_t width = cycle - level.since;
    level = {high, cycle};
    if (on_level) on_level(index + 1, high);
    if (ended && width <= kLongest && on_pulse)
        on_pulse(index + 1, static_cast<double>(width) / kCyclesPer_us);
}

}  // namespace simulator

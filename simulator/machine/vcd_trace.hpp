// SPDX-License-Identifier: GPL-3.0-or-later
// Levels over time as a value change dump (IEEE 1364-2005, clause 18), for GTKWave and its like.
#pragma once
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace simulator {

class VcdTrace {
public:
    struct Signal {
        std::string name;
        int bits;
    };

    VcdTrace(const std::string& path, const std::vector<Signal>& signals);  // throws OutputError

    void change(size_t signal, unsigned value, uint64_t cycle);
    void close();  // throws OutputError when the file is not whole

private:
    void write(size_t signal, unsigned value);

    const std::string path_;
    std::ofstream file_;
    std::vector<Signal> signals_;
    uint64_t cycle_ = UINT64_MAX;
};

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware's variables, so that natively compiled firmware can start anew: what a program's
// start-up code does with .data and .bss. Sections of their own (.noinit) stay as they are.
#pragma once
#include <cstddef>
#include <vector>

namespace simulator {

class FirmwareMemory {
public:
    FirmwareMemory();  // before the firmware runs

    // False in a program whose firmware is not linked between the marks
    // (toolchain/cmake/host.cmake).
    bool known() const { return !parts_.empty(); }
    void startAnew();

private:
    struct Part {
        char* at;
        std::vector<char> contents;  // as the program was loaded
    };
    std::vector<Part> parts_;
};

}  // namespace simulator

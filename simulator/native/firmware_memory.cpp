// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/native/firmware_memory.hpp"

#include <algorithm>
#include <stdexcept>

// The marks, each in a source of its own: the linker puts what is linked between these sources
// between these variables.
extern char firmware_data_begin[] __attribute__((weak));
extern char firmware_data_end[] __attribute__((weak));
extern char firmware_bss_begin[] __attribute__((weak));
extern char firmware_bss_end[] __attribute__((weak));

namespace simulator {

FirmwareMemory::FirmwareMemory() {
    if (firmware_data_begin == nullptr) return;
    for (const auto& [begin, end] :
         {std::pair<char*, char*>(firmware_data_begin, firmware_data_end),
          std::pair<char*, char*>(firmware_bss_begin, firmware_bss_end)}) {
        if (begin >= end) throw std::logic_error("the firmware is not linked between its marks");
        parts_.push_back({begin, std::vector<char>(begin, end)});
    }
}

void FirmwareMemory::startAnew() {
    for (const Part& part : parts_) std::copy(part.contents.begin(), part.contents.end(), part.at);
}

}  // namespace simulator

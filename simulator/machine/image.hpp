// SPDX-License-Identifier: GPL-3.0-or-later
// What avrdude would write: the flash contents of an .elf or .hex file, checked.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulator/machine/registers.hpp"

namespace simulator {

struct Image {
    std::string path, sha256;                  // of the file it was read from
    std::vector<uint8_t> flash;                // from address 0, gaps 0xFF
    uint32_t flash_bytes = 0;                  // without the gaps
    std::optional<uint32_t> ram_static_bytes;  // .data + .bss + .noinit; a .hex does not have it

    void place(uint32_t address, const void* bytes, size_t size);  // within the flash
};

// ram_end: the last address of RAM; beyond the chip's own (datasheet 9.1) where a program has
// external memory. Throws std::runtime_error with one line that says what is wrong with the file.
Image readImage(const std::string& path, uint16_t ram_end = kRamEnd);

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// What avrdude would write: the flash contents of an .elf or .hex file, checked.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simulator {

struct Image {
    std::vector<uint8_t> flash;                // from address 0, gaps 0xFF
    uint32_t flash_bytes = 0;                  // without the gaps
    std::optional<uint32_t> ram_static_bytes;  // .data + .bss + .noinit; a .hex does not tell
};

// Throws std::runtime_error with one line that says what is wrong with the file.
Image readImage(const std::string& path);

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// An ELF file for the ATmega2560, checked from its first byte: what lies outside the file or
// outside the chip's memories is refused before anything is made of it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "simulator/machine/image.hpp"

namespace simulator {

bool looksLikeElf(const std::string& bytes);

// Throws std::runtime_error with "PATH: what is wrong".
Image readElf(const std::string& path, const std::string& bytes, uint16_t ram_end);

}  // namespace simulator

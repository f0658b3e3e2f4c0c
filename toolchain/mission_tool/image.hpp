// SPDX-License-Identifier: GPL-3.0-or-later
// The contents of an EEPROM as a file: raw (.bin), or Intel hex (.eep, .hex) as avrdude and avr-gcc
// write it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace mission_tool {

using Image = std::vector<uint8_t>;  // always hal::kEepromSize cells

Image blankImage();

bool looksLikeHex(const std::string& contents);
Image parseHex(const std::string& text, const std::string& name);  // throws WrongInput
std::string hexOf(const Image& image);
std::string rawOf(const Image& image);

// By the name's end: .eep and .hex are Intel hex, .bin is raw; throws WrongInput for others.
std::string encodedFor(const std::string& path, const Image& image);

}  // namespace mission_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// EEPROMs that ArduPlane has written: recognised and read. Those of 2.x boards are written, too:
// their records are the APM 2.0 set's with 15 bytes, parameter 2 having 32 bits.
#pragma once
#include "toolchain/mission_tool/document.hpp"
#include "toolchain/mission_tool/image.hpp"

namespace mission_tool {

// A message for the user; empty: not ArduPlane's.
std::string arduPlaneIn(const Image& image);

// count: the board's CMD_TOTAL + 1 (home), of 3.x MIS_TOTAL; 0: up to the first record that was
// never written. The firmware must have been started (board.hpp).
Document readMissionOf3(const Image& image, const std::string& name, size_t count);
Document readRecords15(const Image& image, const std::string& name, size_t count);
Image writeRecords15(const Document& document, const Image& onto);

}  // namespace mission_tool

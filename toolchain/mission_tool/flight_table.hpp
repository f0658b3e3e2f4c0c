// SPDX-License-Identifier: GPL-3.0-or-later
// The flight of a mission in words: each NAV in its turn, with what accompanies it, and the sums.
#pragma once
#include <string>

#include "toolchain/mission_tool/estimate.hpp"

namespace mission_tool {

std::string flightTableOf(const Document& document, const FlightOrder& order,
                          const Estimate& estimate);
std::string sumsOf(const FlightOrder& order, const Estimate& estimate);  // a line each
std::string besideOf(const Document& document, const Visit& visit);
std::string windInWords(const Wind& wind);

}  // namespace mission_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// The map and the height profile of a flight as SVG, 390 units wide: lines of the page's own style,
// and a grid in metres.
#pragma once
#include <string>

#include "toolchain/mission_tool/estimate.hpp"

namespace mission_tool {

std::string mapOf(const Document& document, const Estimate& flight);
std::string profileOf(const Estimate& flight);

std::string escaped(const std::string& text);  // for HTML and SVG

// 1, 2 or 5 times a power of ten, so that `range` has at most `count` of them.
double gridStep(double range, int count);

}  // namespace mission_tool

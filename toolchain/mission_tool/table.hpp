// SPDX-License-Identifier: GPL-3.0-or-later
// A mission as a table to be read before the flight.
#pragma once
#include <string>

#include "toolchain/mission_tool/document.hpp"

namespace mission_tool {

std::string tableOf(const Document& document);

}  // namespace mission_tool

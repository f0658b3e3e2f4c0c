// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of a board as text.
#pragma once
#include <string>
#include <vector>

#include "toolchain/param_tool/board.hpp"

namespace param_tool {

// A .param file that Mission Planner and MAVProxy read; `changed`: only what is not the default.
std::string settingsOf(const std::vector<Parameter>& parameters, bool changed);

// To be read: unit, default, range, meaning; a '*' before what is not the default.
std::string tableOf(const std::vector<Parameter>& parameters, bool changed);

}  // namespace param_tool

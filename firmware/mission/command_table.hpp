// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mission/command_table.hpp"

namespace firmware {

extern const mission::Table kCommandTable;

constexpr uint8_t kApm1Commands = 30;
constexpr uint8_t kApm2Commands = 19;

}  // namespace firmware

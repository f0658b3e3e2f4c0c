// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mission/command_table.hpp"

namespace firmware {
namespace mission {

extern const ::mission::Table kCommandTable;
const char* commandName(uint8_t row);  // on a computer, not on the board

constexpr uint8_t kApm1Commands = 30;
constexpr uint8_t kApm2Commands = 19;
constexpr uint8_t kArduPlaneExtensionCommands = 22;  // of the APM 2.0 set, in neither document

}  // namespace mission
}  // namespace firmware

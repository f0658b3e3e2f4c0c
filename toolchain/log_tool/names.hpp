// SPDX-License-Identifier: GPL-3.0-or-later
// What the numbers in a log mean, in ArduPilot's names: modes (ArduPlane's), events, and errors by
// subsystem and code.
#pragma once
#include <string>

#include "toolchain/log_tool/log_file.hpp"

namespace log_tool {

// Whose codes the errors have: this firmware gives some a meaning of its own, docs/failsafes.md.
enum class Firmware { ours, another };
Firmware firmwareOf(const LogFile& log);

std::string banner(const LogFile& log);  // the text that names the firmware; empty: none

std::string meaningOf(const Record& record, Firmware firmware);  // of MODE, EV, ERR and MSG

}  // namespace log_tool

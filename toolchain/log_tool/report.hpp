// SPDX-License-Identifier: GPL-3.0-or-later
// The page that a simulated flight gets, from a log alone: what the airplane took itself to be
// doing stands where the simulator would know the truth.
#pragma once
#include <string>

#include "toolchain/log_tool/log_file.hpp"

namespace log_tool {

std::string report(const LogFile& log, const std::string& name);

}  // namespace log_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// The log tool's command line.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace log_tool {

// Exit status: 0 well, 1 when there is no such log, 2 when the command line or a file is wrong.
int run(const std::vector<std::string>& words, std::ostream& out, std::ostream& err);

}  // namespace log_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// The tool as a function of its command line.
#pragma once
#include <ostream>
#include <string>
#include <vector>

namespace param_tool {

// The exit status: 0 well, 1 the parameters or a file are wrong, 2 the command line is.
int run(const std::vector<std::string>& words, std::ostream& out, std::ostream& err);

}  // namespace param_tool

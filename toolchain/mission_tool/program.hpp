// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind its command line.
#pragma once
#include <ostream>
#include <string>
#include <vector>

namespace mission_tool {

// words: without the program's name. 0: done; 1: the mission is wrong; 2: the command line is.
int run(const std::vector<std::string>& words, std::ostream& out, std::ostream& err);

}  // namespace mission_tool

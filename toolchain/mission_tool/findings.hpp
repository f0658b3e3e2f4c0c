// SPDX-License-Identifier: GPL-3.0-or-later
// What a pilot should know of a mission before it flies: what the firmware refuses, and what it
// takes and never runs.
#pragma once
#include <string>
#include <vector>

#include "toolchain/mission_tool/document.hpp"

namespace mission_tool {

struct Finding {
    bool error;  // the firmware refuses the mission
    size_t index;
    std::string text;
};
std::vector<Finding> findings(const Document& document);  // in the items' order

// For every item the NAV that it accompanies: itself for a NAV, 0 when it is never run.
std::vector<size_t> accompaniedNavs(const Document& document);

}  // namespace mission_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// How long one pass of the mission engine (libraries/mission/sequencer.hpp) may be: what it looks
// at and runs from where it begins to the start of a NAV, a CONDITION or the end.
#pragma once
#include <cstddef>
#include <vector>

#include "mission/command_table.hpp"

namespace mission_tool {

struct PassItem {  // as the engine sees it
    bool good = false;
    mission::Class kind = mission::Class::action;
    size_t target = 0;     // of a jump
    bool counted = false;  // a jump with a count
};

struct PassCost {
    double record, action;  // of each record, and of running an action besides
};

struct LongPass {
    double cost = 0;
    size_t begins = 0;  // the first record it looks at
};

// Exact without counted jumps. Each of those is taken or passed over as it costs more, so with them
// it is the most that a pass can cost, and may be more than any does.
LongPass longestPass(mission::Set set, const std::vector<PassItem>& items, bool trailing,
                     const PassCost& cost);

// A jump without a count by which a chain comes round to where it was with no NAV or CONDITION on
// the way; 0: there is none.
size_t jumpThatGoesRound(mission::Set set, const std::vector<PassItem>& items);

}  // namespace mission_tool

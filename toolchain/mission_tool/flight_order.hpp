// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which a mission is flown, as the firmware's own engine goes through it: every NAV is
// taken as flown to its end, every CONDITION as ended before it.
#pragma once
#include <vector>

#include "toolchain/mission_tool/document.hpp"

namespace mission_tool {

struct Visit {
    size_t nav;                  // 0: commands behind the last NAV, which run in a circle around it
    bool from_here;              // its leg begins where the airplane is
    std::vector<size_t> beside;  // CONDITIONs, DOs and jumps that accompany it, as they begin
};

struct FlightOrder {
    enum class End {
        complete,  // RTL
        landed,
        circles,  // a NAV that never finishes
        repeats,  // for ever from visits[again] on
        longer,   // more than is looked at
    };
    std::vector<Visit> visits;
    End end = End::complete;
    size_t again = 0;
};

// The firmware must have been started (board.hpp). Of a mission that it refuses: nothing.
FlightOrder flightOrder(const Document& document);

// For every item the NAVs that it is flown beside, in their order, each once; a NAV beside itself.
std::vector<std::vector<size_t>> flownBeside(const Document& document, const FlightOrder& order);

std::string endOf(const FlightOrder& order);  // in words

}  // namespace mission_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// What a pilot should know of a flight before it is flown: each number against its limit. An error
// is what keeps the mission from being flown as it is written.
#pragma once
#include "toolchain/mission_tool/estimate.hpp"
#include "toolchain/mission_tool/findings.hpp"

namespace mission_tool {

struct Conditions {
    Wind wind;
    double range_m = 5000;  // from home
    simulator::Fence fence;
};

// The firmware must have been started (board.hpp): most limits are parameters.
std::vector<Finding> flightFindings(const Document& document, const FlightOrder& order,
                                    const Estimate& flight, const Conditions& conditions);

}  // namespace mission_tool

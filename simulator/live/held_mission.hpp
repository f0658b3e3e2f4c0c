// SPDX-License-Identifier: GPL-3.0-or-later
// What a board holds as if it had been read from a mission file: for the report of a flight whose
// mission somebody else has sent up.
#pragma once
#include "simulator/ground/mission_file.hpp"

namespace simulator::live {

// Of the three lists of the mission protocol. Corners belong to one polygon for as long as their
// first parameter, the number of its corners, says so; a polygon that is cut short is left out.
MissionFile heldMission(const Waypoints& mission, const Waypoints& fence, const Waypoints& rally);
Fence heldFence(const Waypoints& items);

}  // namespace simulator::live

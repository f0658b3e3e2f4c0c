// SPDX-License-Identifier: GPL-3.0-or-later
// Fence and rally points in files of their own, as Mission Planner and MAVProxy write them: .fen
// (the return point, then the corners), .poly (the corners alone) and .ral, or the items of the
// mission protocol as QGC WPL 110. And those of a .plan.
#pragma once
#include "simulator/ground/mission_file.hpp"

namespace simulator {

bool looksLikePoints(const std::string& text);  // .fen, .poly or .ral, as decodedText gives it

// Their fence and rally points; a mission is not looked at. Throw WaypointError.
MissionFile parsePoints(const std::string& bytes, const std::string& name);
MissionFile readPointsFile(const std::string& path);

// As .fen. Empty: it cannot say this fence, which is not one polygon with a return point.
std::string fenceAsPoints(const Fence& fence);
std::string rallyAsPoints(const std::vector<RallyPlace>& rally);  // as .ral; empty: there are none

}  // namespace simulator

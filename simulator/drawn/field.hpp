// SPDX-License-Identifier: GPL-3.0-or-later
// The missions of a drawn world, laid out from where the airplane stands.
#pragma once
#include "simulator/ground/waypoints.hpp"
#include "simulator/world.hpp"

namespace simulator::drawn {

struct FieldPlan {
    double slope = 0;         // of the approach, height by distance
    double approach_mps = 0;  // the airspeed flown on it
    double climb = 0;         // the steepest leg that its planner asks for, height by distance
};

// Legs of 600 m to the left of the runway, a climb and a descent, two turns of a loiter, and a
// landing along the runway where the airplane stood.
Waypoints boxMission(const WorldOptions& world, const FieldPlan& field);
// A take-off to 100 m, and a place far ahead.
Waypoints tuningMission(const WorldOptions& world);

}  // namespace simulator::drawn

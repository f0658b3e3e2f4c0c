// SPDX-License-Identifier: GPL-3.0-or-later
// What flying a path leaves for pitch and throttle: the height, the speed, and how to hold them.
#pragma once
#include "control/speed_height.hpp"
#include "navigation/slope.hpp"

namespace firmware {
namespace guidance {

constexpr float kGuidancePeriod_s = 0.05f;  // 20 Hz

struct Plan {
    navigation::HeightDemand height;
    ::control::Phase phase;
    float pitch_min_rad;
    float airspeed_mps;
};

// Cruise at the demanded height and speed; CONDITION_CHANGE_ALT moves that height as it goes.
Plan levelPlan();
// The demanded slope, where there is one, at a place along a way of this length.
void followSlope(Plan& plan, float length_m, float along_m, float along_mps);

}  // namespace guidance
}  // namespace firmware

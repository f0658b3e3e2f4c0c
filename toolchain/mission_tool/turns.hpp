// SPDX-License-Identifier: GPL-3.0-or-later
// How the turns between the legs of an estimate are flown, by the airplane's parameters.
#pragma once
#include "toolchain/mission_tool/estimate.hpp"

namespace mission_tool {

// Of the parameters, and of what the wings carry at this speed.
double bankLimit_deg(double airspeed_mps);

// Turns are planned with seven tenths of what the bank limit turns (firmware/guidance/bank.cpp).
double turnTangent(double airspeed_mps);  // of that bank
double turnRadius_m(double airspeed_mps, double ground_mps);

// 0 to pi; 0 where there is no corner, as one of both is a circle or has no direction.
double turnBetween_rad(const Stretch& before, const Stretch& after);

}  // namespace mission_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// Flies a plan's height and speed with vehicle.pitch_demand_rad and vehicle.throttle_demand.
#pragma once
#include "control/speed_height.hpp"
#include "firmware/guidance/plan.hpp"

namespace firmware {
namespace guidance {

void beginHeight();                     // taking over from whoever flew, without a step
void flyHeight(const Plan& plan);       // 10 Hz
void waitWithHeight(const Plan& plan);  // 10 Hz, instead: the motor stands
void shiftHeightFlown(float by_m);      // all heights are measured from elsewhere
const ::control::SpeedHeightFlown& heightFlown();
// Airspeeds are demanded as equivalent airspeeds, which lift depends on; energy is made of true
// ones, and so is the speed over the ground. 0.8 to 2.
float trueFromEquivalent();

}  // namespace guidance
}  // namespace firmware

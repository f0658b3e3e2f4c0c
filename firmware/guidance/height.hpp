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

}  // namespace guidance
}  // namespace firmware

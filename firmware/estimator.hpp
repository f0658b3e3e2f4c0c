// SPDX-License-Identifier: GPL-3.0-or-later
// Joins the sensors to what is flown by: attitude, place, height, speed, wind.
#pragma once
#include "core/maths.hpp"

namespace firmware {

void runEstimator();  // every frame, after the sensors

core::Vector3 gyroDrift_rads();  // learnt in flight, on top of the calibration

void zeroHeight();             // the airplane stands at height 0 now
void shiftHeight(float by_m);  // added to every height from now on

}  // namespace firmware

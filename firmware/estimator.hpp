// SPDX-License-Identifier: GPL-3.0-or-later
// Joins the sensors to what is flown by: attitude, place, height, speed, wind.
#pragma once

namespace firmware {

void runEstimator();  // every frame, after the sensors

void zeroHeight();             // the airplane stands at height 0 now
void shiftHeight(float by_m);  // added to every height from now on

}  // namespace firmware

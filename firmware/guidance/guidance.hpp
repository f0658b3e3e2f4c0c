// SPDX-License-Identifier: GPL-3.0-or-later
// Flies vehicle.demand: from where the airplane is to the bank, pitch and throttle that bring it
// where it should be, and how far it has come (vehicle.progress).
#pragma once

namespace firmware {
namespace guidance {

// All after the mode has run; none does anything in a mode that does not guide itself.
void runGuidance();       // 20 Hz: the path, the bank, and which height and speed belong to it
void runSpeedHeight();    // 10 Hz: that height and speed with pitch and throttle
void runTargetBearing();  // 5 Hz: vehicle.progress.target_bearing_cd
void runNavBearing();     // 2.5 Hz: vehicle.progress.nav_bearing_cd
void runLateralGains();   // 1 Hz: a gain tuned in flight takes effect within a second

float demandedAirspeed_mps();  // of what is flown; only in a mode that guides itself

void shiftDemands(float by_m);  // heights are now measured from elsewhere

}  // namespace guidance
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// What the flights along a path have in common: how the airplane moves, the leg, and what is
// published of it in vehicle.progress.
#pragma once
#include "navigation/l1.hpp"

namespace firmware {
namespace guidance {

void beginLateral();  // the gains: taking over from whoever flew, and from time to time
void planLateral();   // a new path

navigation::Motion motion();
const navigation::LateralGains& lateralGains();

// Flies demand.from to demand.to but for the bank; `learning`: the bank's trim, too.
navigation::Lateral followDemandedLeg(const navigation::Motion& now, bool learning);
// How far before the end of the demanded leg the turn to the leg to `next` begins.
float turnLead_m(const geo::Position& next);
float along_mps(const navigation::Lateral& lateral, const navigation::Motion& now);
float legLength_m();
float legHeading_rad();

// `from_datum`: where the airplane is, seen from the leg's start or the circle's centre.
void reportLateral(const navigation::Lateral& lateral, const geo::Offset& from_datum);
void reportTargetBearing();
void reportCourse();

}  // namespace guidance
}  // namespace firmware

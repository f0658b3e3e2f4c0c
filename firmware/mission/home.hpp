// SPDX-License-Identifier: GPL-3.0-or-later
// Home: where the airplane returns to, and the zero of its heights.
#pragma once
#include "geo/position.hpp"

namespace firmware {
namespace mission {

// By an order. What is set so is not refined before the airplane is armed.
bool setHomeHere();                                                // false: no 3D fix
void setHome(const geo::Position& position, int32_t altitude_cm);  // above sea level
// After a restart: as it was before. Nothing that is flown moves.
void resumeHome(const geo::Position& position, int32_t altitude_cm);

// Arming, whatever was ordered before. False: no 3D fix, it is as it was.
bool setHomeOfFlight();
// 10 Hz while disarmed with a fix that is good enough for arming: home is where the airplane
// stands, and after 5 s follows it when it, its height or the receiver's have moved clearly.
void refineHome();

}  // namespace mission
}  // namespace firmware

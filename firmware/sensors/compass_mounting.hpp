// SPDX-License-Identifier: GPL-3.0-or-later
// Whether an outside compass that lies flat is turned about the vertical against what
// COMPASS_ORIENT says: in straight flight it then points beside the course, by the same quarter of
// a turn there and back. A wind that makes the nose point beside the course does so to opposite
// sides, and so does a field of the airplane's own: the mean of as many looks there as back is free
// of both.
#pragma once
#include <stdint.h>

namespace firmware {
namespace sensors {

uint8_t compassMounting();     // the orientation that the readings are turned by
void watchCompassMounting();   // in flight, with a fix, every few seconds
bool compassTurned();          // found in the air, and not set since
uint8_t compassOrientation();  // what COMPASS_ORIENT has to be, when it is turned

}  // namespace sensors
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// What is true of a mode whoever looks at it: a row a mode in mode_traits.cpp.
#pragma once
#include <stdint.h>

#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace state {

bool isMode(uint8_t custom_mode);  // a mode of this airplane that can be chosen
bool fliesAlone(Mode mode);        // without the pilot's sticks
// Of the present mode:
bool guidesItself();    // flies vehicle.demand (AUTO, RTL, LOITER ...)
bool autoThrottle();    // owns the throttle
bool stickSetsSpeed();  // ... and the throttle stick sets the airspeed (FBWB, CRUISE)

}  // namespace state
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// The cruise speed and throttle of a mission: the parameters', until a command changes them; they
// go back when the mission restarts or ends.
#pragma once
#include <stdint.h>

namespace firmware {
namespace mission {

void resetSpeed();
void setAirSpeed(int32_t speed_cms);
void setGroundSpeed(int32_t speed_cms);
void setCruiseThrottle(int8_t throttle_pct);
void demandSpeed();  // into vehicle.demand
void stepSpeed();    // 10 Hz in AUTO: follows a demanded ground speed

}  // namespace mission
}  // namespace firmware

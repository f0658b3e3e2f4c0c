// SPDX-License-Identifier: GPL-3.0-or-later
// TAKEOFF, from the ground's side.
#pragma once
#include "firmware/mission/mission.hpp"

namespace firmware {
namespace modes {

// Enters TAKEOFF and climbs to z in the item's frame (0 or NaN: TKOFF_ALT), the nose at least
// param1 degrees up (0 or NaN: TKOFF_LVL_PITCH; up to 60). Disarmed it waits to be armed, in the
// air it circles, where it is lower climbing to the height first. Leaves everything as it is when
// it does not answer `accepted`; `error`: not now. It uses the item up.
mission::MissionResult takeOff(mission::MissionItem& target);

}  // namespace modes
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// GUIDED, from the ground's side: where to fly, in the terms of a mission item.
#pragma once
#include "firmware/mission/mission.hpp"

namespace firmware {
namespace modes {

// Enters GUIDED and circles the place, param3 metres around it (0: as WP_LOITER_RAD says, which
// also gives the direction), counter-clockwise when param4 is 1. Both leave everything as it is
// when they do not answer `accepted`; `error`: not now. They use the item up.
mission::MissionResult guideTo(mission::MissionItem& target);
// In GUIDED: straight on along this course over the ground, 0 to 2 pi, at the height and speed that
// are flown, until another target is given. False: not in GUIDED, or without a position.
bool guideAlong(float course_rad);
// The height alone, in every mode that holds one by itself but AUTO.
mission::MissionResult guideToHeight(mission::MissionItem& target);

// Makes z the height above home: by the rules of a mission's waypoint, NaN is the present height.
// The rest of the item is used up. Of NAV_WAYPOINT alone.
mission::MissionResult aboveHome(mission::MissionItem& item);

}  // namespace modes
}  // namespace firmware

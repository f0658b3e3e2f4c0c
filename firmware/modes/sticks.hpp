// SPDX-License-Identifier: GPL-3.0-or-later
// What the pilot's sticks demand in the modes that stabilise.
#pragma once
#include "core/fixed.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

core::Angle stickRoll_rad();   // full stick: LIM_ROLL_CD
core::Angle stickPitch_rad();  // full stick: LIM_PITCH_MAX or LIM_PITCH_MIN
core::Ratio stickThrottle();   // 0..1

// What the sticks do to the surfaces from now on; they add nothing to the demands.
void useSticks(state::Sticks use);

// Lets the pilot bend what an automatic mode demands, or move the surfaces: STICK_MIXING 1 and 2,
// off in a failsafe.
void mixSticks();

}  // namespace modes
}  // namespace firmware

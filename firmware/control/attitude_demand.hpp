// SPDX-License-Identifier: GPL-3.0-or-later
// What attitude control has to fly. A mode that flies by the sticks demands it in each run,
// guidance does for all others; the last demand stands until the next one.
#pragma once
#include "core/fixed.hpp"

namespace firmware {
namespace control {

void demandRoll(core::Angle bank_rad);      // right wing down
void demandPitch(core::Angle pitch_rad);    // nose up
void demandThrottle(core::Ratio throttle);  // 0..1
void demandRudder(core::Ratio deflection);  // -1..1, on top of what stabilises

}  // namespace control
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// What happens when something fails in flight: radio, ground station, battery, sensors, fence.
// The rules are the rows of table.cpp.
#pragma once
#include "firmware/safety/failsafe_table.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace safety {

void runFailsafe();  // 10 Hz

inline bool failing(Cause cause) { return (state::vehicle.failing & bitOf(cause)) != 0; }

bool failsafeGlides();     // FBWA is flown by nobody: wings level, motor off
bool failsafeGivesBack();  // a mode is being entered that was only interrupted

}  // namespace safety
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// What happens when something fails in flight: radio, ground station, battery, sensors, fence.
// The rules are the rows of table.cpp.
#pragma once
#include "firmware/safety/failsafe_table.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace safety {

void runFailsafe();  // 10 Hz

using state::failing;

}  // namespace safety
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// STABILIZE: levels the airplane; the sticks are added on top; the throttle is the pilot's.
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace state;

Entry startStabilize() { return Entry::entered; }

void runStabilize() {
    vehicle.sticks = Sticks::on_top;
    vehicle.roll_demand_rad = core::Angle::fromRaw(0);
    vehicle.pitch_demand_rad = core::Angle::fromRaw(0);
    vehicle.throttle_demand = stickThrottle();
}

}  // namespace modes
}  // namespace firmware

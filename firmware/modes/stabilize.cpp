// SPDX-License-Identifier: GPL-3.0-or-later
// STABILIZE: levels the airplane; the sticks are added on top; the throttle is the pilot's.
#include "firmware/control/attitude_demand.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace control;

EntryResult startStabilize() { return EntryResult::entered; }

void runStabilize() {
    useSticks(Sticks::on_top);
    demandRoll(core::Angle::fromRaw(0));
    demandPitch(core::Angle::fromRaw(0));
    demandThrottle(stickThrottle());
}

}  // namespace modes
}  // namespace firmware

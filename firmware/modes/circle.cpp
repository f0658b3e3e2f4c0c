// SPDX-License-Identifier: GPL-3.0-or-later
// CIRCLE: a gentle turn that holds the height and needs no GPS; what a short failsafe flies.
#include "firmware/control/attitude_demand.hpp"
#include "firmware/modes/circling.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

#include "core/maths.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace control;

EntryResult startCircle() {
    demandLevel(vehicle.estimate.height_m);
    return EntryResult::entered;
}

void runCircle() {
    demandRoll(core::Angle(core::fromCentidegrees(parameters.roll_limit_cd / 3)));
    mixSticks();
}

}  // namespace modes
}  // namespace firmware

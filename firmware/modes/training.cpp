// SPDX-License-Identifier: GPL-3.0-or-later
// TRAINING: MANUAL as long as the airplane keeps within the limits of bank and pitch; no stick
// moves it beyond them. The throttle is the pilot's.
#include "firmware/control/attitude_demand.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace control;

EntryResult startTraining() { return EntryResult::entered; }

void runTraining() {
    useSticks(Sticks::bounded);
    demandThrottle(stickThrottle());
}

}  // namespace modes
}  // namespace firmware

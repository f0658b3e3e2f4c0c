// SPDX-License-Identifier: GPL-3.0-or-later
// MANUAL: the sticks are the surfaces, and nothing stands between them.
#include "firmware/control/attitude_demand.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace control;

EntryResult startManual() { return EntryResult::entered; }

void runManual() {
    useSticks(Sticks::direct);
    demandThrottle(stickThrottle());
}

}  // namespace modes
}  // namespace firmware

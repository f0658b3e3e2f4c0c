// SPDX-License-Identifier: GPL-3.0-or-later
// MANUAL: the sticks are the surfaces, and nothing stands between them.
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace state;

Entry startManual() { return Entry::entered; }

void runManual() {
    vehicle.sticks = Sticks::direct;
    vehicle.throttle_demand = stickThrottle();
}

}  // namespace modes
}  // namespace firmware

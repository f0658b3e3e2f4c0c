// SPDX-License-Identifier: GPL-3.0-or-later
// LOITER: circles the place where it was entered, at the height it had there; after an
// interruption by a failsafe the same place.
#include "firmware/modes/circling.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace notify;
using namespace state;

EntryResult startLoiter() {
    if (!vehicle.estimate.known) {
        sendStatusText(Severity::warning, STATUS_TEXT("Circling needs a position"));
        return EntryResult::refused;
    }
    const geo::Position& place =
        vehicle.failsafe_gives_back ? vehicle.demand.to : vehicle.estimate.position;
    demandCircle(place, vehicle.estimate.height_m);
    return EntryResult::entered;
}

void runLoiter() { mixSticks(); }

}  // namespace modes
}  // namespace firmware

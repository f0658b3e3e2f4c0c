// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/rally.hpp"

#include "core/file_state.hpp"
#include "firmware/mission/fence_rally_items.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;

namespace {

struct RallyPoint {
    uint8_t next;
};
core::FileState<RallyPoint> rally{};

// Nearer than what is demanded; than home it need only be near.
bool better(const geo::Position& place) {
    const geo::Position &here = vehicle.estimate.position, &best = vehicle.demand.to;
    const float distance_m = geo::distance_m(here, place);
    if (best == vehicle.home.position && distance_m <= parameters.rally_limit_km * 1000)
        return true;
    return distance_m < geo::distance_m(here, best);
}

}  // namespace

void rallyFollow() { parameters.rally_total = static_cast<int8_t>(listCount(ListKind::rally)); }

void rallyBegin() { rally.next = 0; }

void rallyLook(FlyTo fly_to) {
    if (rally.next >= listCount(ListKind::rally)) return;
    uint8_t record[storage::kLargestRecord];
    const core::Status status = listRead(ListKind::rally, rally.next, record);
    if (status == core::Status::busy) return;
    ++rally.next;
    const geo::Position place = placeOf(record);
    if (status != core::Status::ok || !isPlace(place) || !better(place)) return;
    fly_to(place, rallyHeight_m(record));
    sendStatusText(Severity::info, STATUS_TEXT("Going to rally point #"), rally.next - 1);
}

}  // namespace mission
}  // namespace firmware

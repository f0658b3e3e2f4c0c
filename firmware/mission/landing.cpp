// SPDX-License-Identifier: GPL-3.0-or-later
// AUTO goes on at the nearest DO_LAND_START: for RTL_AUTOLAND, for the ground, and for a landing
// that is flown again. It is looked for a few records at a time.
#include "core/file_state.hpp"
#include "firmware/guidance/demand.hpp"
#include "firmware/mission/command_table.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/mission/host.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;
using namespace guidance;

namespace {

constexpr uint8_t kLandStart = 0xBD;

struct Search {
    uint8_t next;      // record to look at; 0: nothing is looked for
    uint8_t unplaced;  // a start at 0, 0: it lies where the next NAV does; 0: none
    uint8_t best;      // so far
    uint8_t landing;   // to be flown again, at least from the place before it; 0: none
    uint8_t generation;
    float best_m;  // below 0: no start so far
    Mode mode;     // in which it was requested
};
core::FileState<Search> search{};

void consider(uint8_t index, const geo::Position& place) {
    const float distance_m = geo::distance_m(vehicle.estimate.position, place);
    if (search.best_m >= 0 && distance_m >= search.best_m) return;
    search.best = index;
    search.best_m = distance_m;
}

void look(const Record& record, ItemPosition position) {
    geo::Position place = {record.p3, record.p4};
    if (record.id != kLandStart) {
        if (!placeOfNav(record, position, place)) return;
        if (search.unplaced != 0) consider(search.unplaced, place);
        if (search.best_m < 0 && position.index < search.landing) search.best = position.index;
        search.unplaced = 0;
    } else if (record.p3 == 0 && record.p4 == 0) {
        search.unplaced = position.index;
    } else {
        consider(position.index, place);
    }
}

void begin(uint8_t otherwise, uint8_t landing) {
    search = {1, 0, otherwise, landing, mission_store.generation(), -1, vehicle.mode};
}

bool landing() { return vehicle.mode == Mode::automatic && vehicle.demand.path == Path::land; }

void goThere() {
    if (missionSetCurrent(search.best)) (void)host.enterMode(Mode::automatic);
}

}  // namespace

bool missionLand() {
    if (mission_summary.land_start == 0 || !missionReady()) return false;
    if (landing()) return missionGoAround(0);
    begin(mission_summary.land_start, 0);
    return true;
}

// What comes first is a climb straight on, which landDone() ends.
bool missionGoAround(float height_m) {
    constexpr float kClear_m = 30;  // above the landing point: the least to turn at
    if (!landing() || !vehicle.estimate.flying) return false;
    PathDemand& demand = beginPath();
    const float least_m = demand.height_m + kClear_m;
    demand.path = Path::leg;  // the whole line is flown, also beyond its end
    demand.height_m = height_m > least_m ? height_m : least_m;
    demand.sloped = false;
    return true;
}

// A stick that was left there before the landing says nothing.
void breakOffByThrottle(bool& was_below) {
    constexpr int8_t kAll_pct = 90;
    if (vehicle.radio.lost) return;
    const bool all = vehicle.radio.throttle_pct >= kAll_pct;
    if (all && was_below && missionGoAround(0))
        sendStatusText(Severity::warning, STATUS_TEXT("Landing broken off by the throttle"));
    was_below = !all;
}

void landAgain() {
    const uint8_t landing = mission_engine.current();
    if (search.next == 0) begin(landing, landing);
}

void stepLanding() {
    if (search.next == 0) return;
    const bool other = search.generation != mission_store.generation() || missionChanging();
    if (other || vehicle.mode != search.mode) search.next = 0;
    for (uint8_t n = 0; n < kRecordsPerCall && search.next != 0; ++n) {
        const ItemPosition position = {search.next, mission_store.count()};
        uint8_t bytes[::mission::kRecordSize];
        const core::Status status = mission_store.read(position.index, bytes);
        if (status == core::Status::busy) return;
        if (status == core::Status::ok) look(::mission::unpack(missionSet(), bytes), position);
        if (++search.next < position.count) continue;
        search.next = 0;
        goThere();
    }
}

}  // namespace mission
}  // namespace firmware

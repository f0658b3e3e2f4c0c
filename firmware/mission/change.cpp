// SPDX-License-Identifier: GPL-3.0-or-later
// A mission committed in flight: when the NAV being flown and its chain are the same in both, the
// flight goes on. The old records are still there to compare.
#include <string.h>

#include "firmware/mission/command_table.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"

namespace firmware {
namespace {

constexpr uint8_t kPairsPerCall = 8;

struct {
    mission::Sequencer::InFlight items;
    uint8_t at;
    uint8_t runs_left;  // the NAV, the first run, the second
} compare;

bool isNav(const uint8_t* record) {
    const uint8_t row = kCommandTable.find(missionSet(), record[0]);
    return row != mission::kNoRow && kCommandTable.kind(row) == mission::Class::nav;
}

// The next run; false: there is none.
bool nextRun() {
    --compare.runs_left;
    const bool apm1 = missionSet() == mission::Set::apm1;
    if (compare.runs_left == 2) {
        compare.at = compare.items.first;
        return true;
    }
    compare.at = compare.items.second;
    return compare.runs_left == 1 && apm1 && compare.items.second != compare.items.first;
}

// An APM 1.0 run ends before the next NAV, which need not be the same one.
bool endsBefore(const uint8_t* now, const uint8_t* before, bool& same) {
    if (compare.runs_left == 3 || missionSet() == mission::Set::apm2) return false;
    const bool nav = isNav(now);
    if (!nav && !isNav(before)) return false;
    same = nav && isNav(before);
    return true;
}

// One pair. `ends`: the run is over and was the same.
core::Status comparePair(bool& same, bool& ends) {
    const uint8_t count = mission_store.count();
    ends = compare.at >= count;
    if (ends) {
        same = count == mission_store.previousCount();
        return core::Status::ok;
    }
    uint8_t now[storage::kRecordSize], before[storage::kRecordSize];
    core::Status status = mission_store.read(compare.at, now);
    if (status != core::Status::ok) return status;
    status = mission_store.readPrevious(compare.at, before);
    if (status == core::Status::busy) return status;
    if (status != core::Status::ok) {
        same = false;
        return core::Status::ok;
    }
    ends = endsBefore(now, before, same);
    if (ends) return core::Status::ok;
    same = memcmp(now, before, sizeof now) == 0;
    const bool to_nav = missionSet() == mission::Set::apm2 && !compare.items.to_end;
    ends = compare.runs_left == 3 || (to_nav && compare.at == compare.items.nav);
    ++compare.at;
    return core::Status::ok;
}

}  // namespace

void compareBegin() {
    const bool comparable = mission_engine.active() && mission_engine.inFlight(compare.items) &&
                            mission_store.set() == mission_store.previousSet();
    compare.runs_left = comparable ? 3 : 0;
    compare.at = compare.items.nav;
}

core::Status compareStep(bool& same) {
    same = compare.runs_left != 0;
    for (uint8_t n = 0; n < kPairsPerCall && compare.runs_left != 0; ++n) {
        bool ends = false;
        const core::Status status = comparePair(same, ends);
        if (status != core::Status::ok) return status;
        if (!same || (ends && !nextRun())) compare.runs_left = 0;
    }
    return compare.runs_left == 0 ? core::Status::ok : core::Status::busy;
}

}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// A mission committed in flight: when the NAV being flown and its chain are the same in both, the
// flight goes on. The old records are still there to compare.
#include <string.h>

#include "core/file_state.hpp"
#include "firmware/mission/command_table.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"

namespace firmware {
namespace mission {

namespace {

constexpr uint8_t kPairsPerCall = kRecordsPerCall / 2;

struct Comparison {
    ::mission::Sequencer::InFlight items;
    uint8_t at;
    uint8_t runs_left;  // the NAV, the first run, the second
};
core::FileState<Comparison> compare{};

// The next run; false: there is none.
bool nextRun() {
    --compare.runs_left;
    const bool first = compare.runs_left == 2;
    compare.at = first ? compare.items.first : compare.items.second;
    return first || (compare.runs_left == 1 && compare.items.second != compare.items.first);
}

// What one of the two missions has at this place of a run.
struct Side {
    uint8_t record[storage::kRecordSize];
    bool over;  // the run ends before this place
};

bool isNav(const uint8_t* bytes, uint8_t count) {
    const Record record = ::mission::unpack(missionSet(), bytes);
    const uint8_t row = kCommandTable.find(missionSet(), record.id);
    return row != ::mission::kNoRow && kCommandTable.kind(row) == ::mission::Class::nav &&
           kCommandTable.valid(row, record, {compare.at, count}) == 0;
}

// An APM 1.0 run ends before the next NAV, which need not be the same one.
core::Status look(ReadRecord read, uint8_t count, Side& side) {
    side.over = compare.at >= count;
    if (side.over) return core::Status::ok;
    const core::Status status = read(compare.at, side.record);
    if (status == core::Status::ok)
        side.over = compare.runs_left != 3 && missionSet() == ::mission::Set::apm1 &&
                    isNav(side.record, count);
    return status;
}

core::Status readNow(uint8_t index, uint8_t* to) { return mission_store.read(index, to); }
core::Status readBefore(uint8_t index, uint8_t* to) {
    return mission_store.readPrevious(index, to);
}

// One pair. `ends`: the run is over and was the same.
core::Status comparePair(bool& same, bool& ends) {
    Side now, before;
    core::Status status = look(readNow, mission_store.count(), now);
    if (status == core::Status::ok)
        status = look(readBefore, mission_store.previousCount(), before);
    if (status == core::Status::busy) return status;
    same = status == core::Status::ok && now.over == before.over;
    ends = now.over;
    if (!same || ends) return core::Status::ok;
    same = memcmp(now.record, before.record, sizeof now.record) == 0;
    ends = compare.runs_left == 3 ||
           compare.at == (compare.runs_left == 2 ? compare.items.last : compare.items.nav);
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
        if (comparePair(same, ends) != core::Status::ok) return core::Status::busy;
        if (!same || (ends && !nextRun())) compare.runs_left = 0;
    }
    return compare.runs_left == 0 ? core::Status::ok : core::Status::busy;
}

}  // namespace mission
}  // namespace firmware

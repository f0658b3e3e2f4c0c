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

enum class Part : uint8_t { nothing, nav, first_run, further_run };
struct Comparison {
    ::mission::Sequencer::InFlight items;
    uint8_t at;
    uint8_t run;  // where the further one began
    Part part;
};
core::FileState<Comparison> compare{};

// The next run; false: there is none.
bool nextRun() {
    if (compare.part == Part::nav) {
        compare.part = Part::first_run;
        compare.at = compare.items.first;
        return true;
    }
    compare.part = Part::further_run;
    compare.at = compare.run = mission_engine.nextRun(compare.run);
    return compare.run != 0;
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
        side.over = compare.part != Part::nav && missionSet() == ::mission::Set::apm1 &&
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
    ends = compare.at == (compare.part == Part::first_run ? compare.items.last : compare.items.nav);
    ++compare.at;
    return core::Status::ok;
}

}  // namespace

void compareBegin() {
    const bool comparable = mission_engine.active() && mission_engine.inFlight(compare.items) &&
                            mission_store.set() == mission_store.previousSet();
    compare.part = comparable ? Part::nav : Part::nothing;
    compare.at = compare.items.nav;
    compare.run = 0;
}

core::Status compareStep(bool& same) {
    same = compare.part != Part::nothing;
    for (uint8_t n = 0; n < kPairsPerCall && compare.part != Part::nothing; ++n) {
        bool ends = false;
        if (comparePair(same, ends) != core::Status::ok) return core::Status::busy;
        if (!same || (ends && !nextRun())) compare.part = Part::nothing;
    }
    return compare.part == Part::nothing ? core::Status::ok : core::Status::busy;
}

}  // namespace mission
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// Missions up and down. A new one is checked as a whole before it is committed, and the old one
// flies on until then.
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/mission/item.hpp"
#include "firmware/parameters.hpp"
#include "firmware/telemetry/text.hpp"
#include "hal/page_flash.hpp"

namespace firmware {

namespace {

using core::Status;

// storing, comparing: a commit is under way; it goes on even when nobody asks any more.
enum class Step : uint8_t { none, filling, storing, comparing };
Step step;
MissionResult outcome = MissionResult::error;  // of the last commit
Survey staged_survey;
Notes notes;
bool clearing;
uint8_t partial_last;  // last item of a partial write; 0xFF: all items come from the ground
constexpr uint8_t kWhole = 0xFF;

MissionResult answer(Status status) {
    switch (status) {
        case Status::ok:
            return MissionResult::accepted;
        case Status::busy:
            return MissionResult::busy;
        case Status::full:
            return MissionResult::no_space;
        case Status::bad_argument:
            return MissionResult::invalid_sequence;
        default:
            return MissionResult::error;
    }
}

mission::Set stagedSet() { return static_cast<mission::Set>(mission_store.stagedSet()); }

MissionResult begin(uint8_t count, uint8_t set) {
    if (!missionStorable()) return MissionResult::denied;
    if (!missionReady() || !hal::flashKnown() || step > Step::filling) return MissionResult::busy;
    const Status status = mission_store.begin(count, set);
    if (status == Status::full)
        tell(Severity::warning, ROM_TEXT("DataFlash does not work: clear the mission first"));
    if (status != Status::ok) return answer(status);
    step = Step::filling;
    notes = {};
    staged_survey = {};
    partial_last = kWhole;
    return MissionResult::accepted;
}

// The parts of a partial write that stay come from the present mission.
Status copyUpTo(uint8_t index) {
    for (uint8_t n = 0; n < kRecordsPerCall && mission_store.staged() < index; ++n) {
        uint8_t bytes[mission::kRecordSize];
        Status status = mission_store.read(mission_store.staged(), bytes);
        if (status == Status::ok) status = missionUploadRecord(bytes);
        if (status != Status::ok) return status;
    }
    return mission_store.staged() < index ? Status::busy : Status::ok;
}

void finish(MissionResult result) {
    if (result != MissionResult::accepted) mission_store.abort();
    step = Step::none;
    outcome = result;
}

void tellNotes() {
    if (notes.rounded) tell(Severity::notice, ROM_TEXT("Mission: values were rounded"));
    if (notes.dropped) tell(Severity::notice, ROM_TEXT("Mission: unused parameters dropped"));
}

void store() {
    const Status status = mission_store.commit();
    if (status == Status::busy) return;
    if (status != Status::ok) {
        tell(Severity::error, ROM_TEXT("Mission not stored: memory error"));
        return finish(MissionResult::error);
    }
    mission_survey = staged_survey;
    compareBegin();
    step = Step::comparing;
}

// What was committed in the DataFlash goes home to the EEPROM when nothing else is to be done.
void settle() {
    const Status status = mission_store.settle();
    if (status != Status::ok && status != Status::busy)
        tell(Severity::error, ROM_TEXT("EEPROM is worn: mission stays in the DataFlash"));
}

void compare() {
    bool same = false;
    if (compareStep(same) == Status::busy) return;
    const bool empty = mission_survey.first_nav == 0;
    tellNotes();
    tellWarnings(mission_survey, missionSet(), mission_store.count());
    finish(MissionResult::accepted);
    mission_engine.changed(missionSet(), mission_store.generation(), same && !empty, empty);
}

}  // namespace

void uploadStart() {
    step = Step::none;
    outcome = MissionResult::error;
    clearing = false;
}

bool missionChanging() { return step == Step::comparing; }

void uploadRun() {
    switch (step) {
        case Step::storing:
            return store();
        case Step::comparing:
            return compare();
        default:
            return settle();
    }
}

core::Status missionItem(uint16_t index, MissionItem& to) {
    if (!missionKnown()) return Status::busy;
    if (index >= mission_store.count()) return Status::bad_argument;
    uint8_t bytes[mission::kRecordSize];
    const Status status = mission_store.read(static_cast<uint8_t>(index), bytes);
    if (status != Status::ok) return status;
    decodeItem(missionSet(), static_cast<uint8_t>(index), mission::unpack(missionSet(), bytes), to);
    return Status::ok;
}

MissionResult missionBeginUpload(uint16_t count) {
    if (count > storage::kRecordSlots) return MissionResult::no_space;
    return begin(static_cast<uint8_t>(count), static_cast<uint8_t>(parameters.mission_set));
}

MissionResult missionBeginPartial(uint16_t first, uint16_t last) {
    const uint8_t count = mission_store.count();
    if (first > last || last >= count) return MissionResult::invalid_sequence;
    if (mission_store.set() != static_cast<uint8_t>(parameters.mission_set))
        return MissionResult::denied;
    const MissionResult result = begin(count, mission_store.set());
    if (result == MissionResult::accepted) partial_last = static_cast<uint8_t>(last);
    return result;
}

Status missionUploadRecord(const uint8_t* bytes) {
    const mission::Site at = {mission_store.staged(), mission_store.stagedCount()};
    const Status status = mission_store.put(bytes);
    if (status == Status::ok) surveyRecord(staged_survey, stagedSet(), bytes, at);
    return status;
}

MissionResult missionUploadItem(uint16_t index, const MissionItem& item) {
    if (step != Step::filling || !mission_store.staging()) return MissionResult::error;
    const uint8_t count = mission_store.stagedCount();
    if (index >= count) return MissionResult::invalid_sequence;
    const uint8_t place = static_cast<uint8_t>(index);
    if (partial_last != kWhole) {
        const Status status = copyUpTo(place);
        if (status != Status::ok) return answer(status);
    }
    if (place != mission_store.staged()) return MissionResult::invalid_sequence;
    Record record;
    Notes item_notes = {};
    const MissionResult result = encodeItem(stagedSet(), {place, count}, item, record, item_notes);
    if (result != MissionResult::accepted) return result;
    uint8_t bytes[mission::kRecordSize];
    mission::pack(stagedSet(), record, bytes);
    const Status status = missionUploadRecord(bytes);
    if (status != Status::ok) return answer(status);
    notes.rounded |= item_notes.rounded;
    notes.dropped |= item_notes.dropped;
    return MissionResult::accepted;
}

MissionResult missionCommit() {
    if (step == Step::none) return outcome;
    if (step == Step::filling) {
        if (partial_last != kWhole && mission_store.staged() > partial_last) {
            const Status status = copyUpTo(mission_store.stagedCount());
            if (status != Status::ok) return answer(status);
        }
        if (mission_store.staged() != mission_store.stagedCount())
            return MissionResult::invalid_sequence;
        if (staged_survey.counters > mission::kMostCounters) {
            tell(Severity::warning, ROM_TEXT("Mission: more than # counted jumps"),
                 mission::kMostCounters);
            finish(MissionResult::no_space);
            return outcome;
        }
        step = Step::storing;
    }
    uploadRun();
    return step == Step::none ? outcome : MissionResult::busy;
}

void missionAbort() {
    if (step == Step::filling) finish(MissionResult::cancelled);
}

MissionResult missionClear() {
    if (clearing && step == Step::none) {  // done since the last call
        clearing = false;
        return outcome;
    }
    if (!clearing) {
        const MissionResult begun = begin(0, static_cast<uint8_t>(parameters.mission_set));
        if (begun != MissionResult::accepted) return begun;
    }
    const MissionResult result = missionCommit();
    clearing = result == MissionResult::busy;
    return result;
}

}  // namespace firmware

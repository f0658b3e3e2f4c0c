// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/lists.hpp"

#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/fence_line.hpp"
#include "firmware/mission/host.hpp"
#include "firmware/notify/status_text.hpp"
#include "hal/page_flash.hpp"

namespace firmware {
namespace mission {

using namespace notify;

namespace {

using core::Status;

// storing, comparing: a commit is under way; it goes on even when nobody asks any more.
enum class Step : uint8_t { none, filling, storing, comparing };
struct ListChange {
    Step step;
    MissionResult outcome;  // of the last commit
    uint8_t clearing;       // 1 + the kind; 0: none
};
core::FileState<ListChange> change{};

void finish(MissionResult result) {
    if (result != MissionResult::accepted) mission_store.abort();
    change.step = Step::none;
    change.outcome = result;
    if (result == MissionResult::accepted) host.logCommand(kNoItem);
}

void store() {
    const Status status = mission_store.commit();
    if (status == Status::busy) return;
    if (status != Status::ok) {
        sendStatusText(Severity::error, STATUS_TEXT("Not stored: memory error"));
        return finish(MissionResult::error);
    }
    if (mission_store.kind() != ListKind::mission) return finish(MissionResult::accepted);
    missionCommitted();
    change.step = Step::comparing;
}

// In the order of Status.
constexpr MissionResult kResults[] ROM = {
    MissionResult::accepted, MissionResult::busy,
    MissionResult::error,    MissionResult::invalid_sequence,
    MissionResult::error,    MissionResult::no_space,
    MissionResult::error,
};

void reportMended() {
    ListKind which;
    if (!mission_store.takeMended(which)) return;
    reportMemory();
    sendStatusText(Severity::notice, which == ListKind::mission ? STATUS_TEXT("Mission mended")
                                     : which == ListKind::fence
                                         ? STATUS_TEXT("Fence mended")
                                         : STATUS_TEXT("Rally points mended"));
}

// A record that changes by itself is noticed before it is flown, within nine seconds.
void recheck() {
    if (mission_store.recheck() != Status::corrupt) return;
    reportMemory();
    missionLost();
    mission_engine.changed(missionSet(), mission_store.generation(), false, true);
}

// What was committed in the DataFlash goes home to the EEPROM when nothing else is to be done.
void migrate() {
    if (fenceLineWaits()) return;
    const Status status = mission_store.migrateToEeprom();
    if (status == Status::busy) return;
    if (status != Status::ok) reportWorn();
    reportMended();
    recheck();
}

}  // namespace

void reportMemory() {
    sendStatusText(Severity::error, STATUS_TEXT("Memory has not kept what was stored"));
}

void reportWorn() {
    sendStatusText(Severity::error, STATUS_TEXT("EEPROM is worn: lists are at risk"));
}

MissionResult resultOf(Status status) {
    return core::romRead(kResults[static_cast<uint8_t>(status)]);
}

void listsStart() {
    change.step = Step::none;
    change.outcome = MissionResult::error;
    change.clearing = 0;
}

void listsRun() {
    switch (change.step) {
        case Step::storing:
            return store();
        case Step::comparing:
            if (missionCompared()) finish(MissionResult::accepted);
            return;
        default:
            return migrate();
    }
}

bool missionChanging() { return change.step == Step::comparing; }

uint8_t listCapacity(ListKind kind) { return storage::shapeOf(kind).slots; }
uint8_t listCount(ListKind kind) { return mission_store.count(kind); }
uint8_t listSet(ListKind kind) { return mission_store.set(kind); }
uint8_t listGeneration(ListKind kind) { return mission_store.generation(kind); }
uint32_t listId(ListKind kind) { return mission_store.id(kind); }
bool listStaging(ListKind kind) { return mission_store.staging(kind); }

Status listRead(ListKind kind, uint8_t index, uint8_t* to) {
    return missionKnown() ? mission_store.read(kind, index, to) : Status::busy;
}

MissionResult listBegin(ListKind kind, uint16_t count, uint8_t set) {
    if (!missionStorable()) return MissionResult::denied;
    if (count > listCapacity(kind)) return MissionResult::no_space;
    if (!missionReady() || !hal::flashKnown() || change.step > Step::filling)
        return MissionResult::busy;
    const Status status = mission_store.begin(kind, static_cast<uint8_t>(count), set);
    if (status == Status::full)
        sendStatusText(Severity::warning,
                       STATUS_TEXT("DataFlash does not work: clear the old one first"));
    if (status == Status::ok) {
        change.step = Step::filling;
        change.clearing = 0;
    }
    return resultOf(status);
}

MissionResult listPut(const uint8_t* record) { return resultOf(mission_store.put(record)); }
uint8_t listStaged() { return mission_store.staged(); }
uint8_t listStagedCount() { return mission_store.stagedCount(); }
MissionResult listCopy() { return resultOf(mission_store.copy()); }

MissionResult listCommit() {
    if (change.step == Step::none) return change.outcome;
    if (change.step == Step::filling) {
        if (mission_store.staged() != mission_store.stagedCount())
            return MissionResult::invalid_sequence;
        change.step = Step::storing;
    }
    listsRun();
    return change.step == Step::none ? change.outcome : MissionResult::busy;
}

void listAbort() {
    if (change.step == Step::filling) finish(MissionResult::cancelled);
}

MissionResult listClear(ListKind kind, uint8_t set) {
    const uint8_t this_one = static_cast<uint8_t>(1 + static_cast<uint8_t>(kind));
    if (change.clearing != this_one) {
        const MissionResult begun = listBegin(kind, 0, set);
        if (begun != MissionResult::accepted) return begun;
        change.clearing = this_one;
    }
    const MissionResult result = listCommit();
    if (result != MissionResult::busy) change.clearing = 0;
    return result;
}

}  // namespace mission
}  // namespace firmware

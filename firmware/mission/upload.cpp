// SPDX-License-Identifier: GPL-3.0-or-later
// Missions up and down. A new one is checked as a whole before it is committed, and the old one
// flies on until then.
#include "core/file_state.hpp"
#include "firmware/mission/command_table.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/mission/item.hpp"
#include "firmware/mission/lists.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;

namespace {

using core::Status;

struct Upload {
    MissionSummary staged_summary;
    ::mission::LongestPass passes;
    EncodeWarnings warnings;
    uint8_t partial_last;  // last item of a partial write; 0xFF: all items come from the ground
    bool refused;          // an item was, and a text said why
};
core::FileState<Upload> upload{};
constexpr uint8_t kWhole = 0xFF;

::mission::Set stagedSet() { return static_cast<::mission::Set>(mission_store.stagedSet()); }

MissionResult begin(uint16_t count, uint8_t set) {
    const MissionResult result = listBegin(ListKind::mission, count, set);
    if (result != MissionResult::accepted) return result;
    upload.warnings = {};
    upload.staged_summary = {};
    upload.passes.begin(static_cast<::mission::Set>(set));
    upload.partial_last = kWhole;
    upload.refused = false;
    return result;
}

// The parts of a partial write that stay come from the present mission.
Status copyUpTo(uint8_t index) {
    for (uint8_t n = 0; n < kRecordsPerCall && mission_store.staged() < index; ++n) {
        uint8_t bytes[::mission::kRecordSize];
        Status status = mission_store.read(mission_store.staged(), bytes);
        if (status == Status::ok) status = missionUploadRecord(bytes);
        if (status != Status::ok) return status;
    }
    return mission_store.staged() < index ? Status::busy : Status::ok;
}

void reportNotes() {
    if (upload.warnings.rounded)
        sendStatusText(Severity::notice, STATUS_TEXT("Mission: values were rounded"));
    if (upload.warnings.dropped)
        sendStatusText(Severity::notice, STATUS_TEXT("Mission: unused parameters dropped"));
}

}  // namespace

void missionCommitted() {
    if (mission_store.count() == 0) upload.staged_summary = {};
    mission_summary = upload.staged_summary;
    compareBegin();
}

bool missionCompared() {
    bool same = false;
    if (compareStep(same) == Status::busy) return false;
    const bool empty = mission_summary.first_nav == 0;
    if (mission_store.count() > 0) reportNotes();
    reportWarnings(mission_summary, missionSet(), mission_store.count());
    mission_engine.changed(missionSet(), mission_store.generation(), same && !empty, empty);
    return true;
}

core::Status missionItem(uint16_t index, MissionItem& to) {
    if (!missionKnown()) return Status::busy;
    if (index >= mission_store.count()) return Status::bad_argument;
    uint8_t bytes[::mission::kRecordSize];
    const Status status = mission_store.read(static_cast<uint8_t>(index), bytes);
    if (status != Status::ok) return status;
    decodeItem(missionSet(), static_cast<uint8_t>(index), ::mission::unpack(missionSet(), bytes),
               to);
    return Status::ok;
}

MissionResult missionBeginUpload(uint16_t count) {
    return begin(count, static_cast<uint8_t>(parameters.mission_set));
}

MissionResult missionBeginPartial(uint16_t first, uint16_t last) {
    const uint8_t count = mission_store.count();
    if (first > last || last >= count) return MissionResult::invalid_sequence;
    if (mission_store.set() != static_cast<uint8_t>(parameters.mission_set))
        return MissionResult::denied;
    const MissionResult result = begin(count, mission_store.set());
    if (result == MissionResult::accepted) upload.partial_last = static_cast<uint8_t>(last);
    return result;
}

namespace {

void takeIn(const uint8_t* bytes, ::mission::ItemPosition at) {
    const uint8_t row = summarizeRecord(upload.staged_summary, stagedSet(), bytes, at);
    const ::mission::Class kind =
        row == ::mission::kNoRow ? ::mission::Class::action : kCommandTable.kind(row);
    ::mission::Jump jump = {};
    if (kind == ::mission::Class::jump)
        jump = kCommandTable.target(row)(::mission::unpack(stagedSet(), bytes));
    upload.passes.add(at.index, kind, jump);
}

// What may hold up the next NAV for too long is refused: part by part, at the end of an upload.
MissionResult checkPasses() {
    using Verdict = ::mission::LongestPass::Verdict;
    const Verdict verdict = upload.passes.step(mission_store.stagedCount());
    if (verdict == Verdict::busy) return MissionResult::busy;
    if (verdict == Verdict::fine) return MissionResult::accepted;
    reportRefused(upload.passes.item(), verdict);
    listAbort();
    return MissionResult::invalid;
}

}  // namespace

Status missionUploadRecord(const uint8_t* bytes) {
    const ::mission::ItemPosition at = {mission_store.staged(), mission_store.stagedCount()};
    const Status status = mission_store.put(bytes);
    if (status == Status::ok) takeIn(bytes, at);
    return status;
}

MissionResult missionUploadItem(uint16_t index, const MissionItem& item) {
    if (!mission_store.staging()) return MissionResult::error;
    const uint8_t count = mission_store.stagedCount();
    if (index >= count) return MissionResult::invalid_sequence;
    const uint8_t place = static_cast<uint8_t>(index);
    if (upload.partial_last != kWhole) {
        const Status status = copyUpTo(place);
        if (status != Status::ok) return resultOf(status);
    }
    if (place != mission_store.staged()) return MissionResult::invalid_sequence;
    Record record;
    EncodeWarnings item_warnings = {};
    const MissionResult result =
        encodeItem(stagedSet(), {place, count}, item, record, item_warnings);
    if (result != MissionResult::accepted) {
        if (!upload.refused) reportRefused(index, item, result);
        upload.refused = true;
        return result;
    }
    uint8_t bytes[::mission::kRecordSize];
    ::mission::pack(stagedSet(), record, bytes);
    const Status status = missionUploadRecord(bytes);
    if (status != Status::ok) return resultOf(status);
    upload.warnings.rounded |= item_warnings.rounded;
    upload.warnings.dropped |= item_warnings.dropped;
    return MissionResult::accepted;
}

MissionResult missionCommit() {
    if (mission_store.staging()) {
        if (upload.partial_last != kWhole && mission_store.staged() > upload.partial_last) {
            const Status status = copyUpTo(mission_store.stagedCount());
            if (status != Status::ok) return resultOf(status);
        }
        if (upload.staged_summary.counters > ::mission::kMaxCounters) {
            sendStatusText(Severity::warning, STATUS_TEXT("Mission: more than # counted jumps"),
                           ::mission::kMaxCounters);
            listAbort();
            return MissionResult::no_space;
        }
        const MissionResult passes = checkPasses();
        if (passes != MissionResult::accepted) return passes;
    }
    return listCommit();
}

void missionAbort() { listAbort(); }

MissionResult missionClear() {
    return listClear(ListKind::mission, static_cast<uint8_t>(parameters.mission_set));
}

}  // namespace mission
}  // namespace firmware

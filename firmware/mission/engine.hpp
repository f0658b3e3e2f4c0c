// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of firmware/mission/ as they see one another: the engine and the store behind it.
#pragma once
#include "core/file_state.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/state/vehicle.hpp"
#include "mission/longest_pass.hpp"
#include "mission/sequencer.hpp"
#include "storage/mission_store.hpp"

namespace firmware {
namespace mission {

extern core::FileState<storage::MissionStore> mission_store;
extern core::FileState<::mission::Sequencer> mission_engine;

// The set of the stored mission; of an empty one, MIS_SET.
::mission::Set missionSet();

bool missionReady();     // the stored one has been found and checked
bool missionStorable();  // the EEPROM is ours
void missionLost();      // it is there no more: reported, and AUTO is refused with that reason

// Records that background work looks at in one call: with the engine's, 16 a frame.
constexpr uint8_t kRecordsPerCall = 8;

// ---- summary.cpp: what a mission holds, found by looking at a few records each call
struct MissionSummary {
    uint8_t next;       // record to look at; kUnreadable: the mission is lost
    uint8_t first_nav;  // 0: none
    uint8_t last_nav;
    uint8_t last_run;    // or the jump behind it that leads on
    uint8_t counters;    // jumps that need one
    uint8_t land_start;  // the first of them; 0: none
    uint8_t idle;        // how many do nothing on this board
};
constexpr uint8_t kUnreadable = 0xFF;
// Returns the command's row; kNoRow: home, or unknown or out of range.
uint8_t summarizeRecord(MissionSummary& summary, ::mission::Set set, const uint8_t* bytes,
                        ::mission::ItemPosition at);
using ReadRecord = core::Status (*)(uint8_t index, uint8_t* to);
MUST_USE core::Status summarizeStep(MissionSummary& summary, ::mission::Set set, uint8_t count,
                                    ReadRecord read);
void reportWarnings(const MissionSummary& summary, ::mission::Set set, uint8_t count);

// ---- change.cpp: whether what is in flight is the same in the mission just committed
void compareBegin();
MUST_USE core::Status compareStep(bool& same);

// ---- lists.cpp
void listsStart();
void listsRun();         // carries a commit on, copies what was committed; 10 Hz
bool missionChanging();  // the engine must not run now
MissionResult resultOf(core::Status status);
void reportMemory();  // it has not kept what was stored
void reportWorn();    // it does not keep what is being stored

// ---- upload.cpp
// The next item of an upload as it is stored.
MUST_USE core::Status missionUploadRecord(const uint8_t* bytes);
void missionCommitted();
bool missionCompared();                                  // then until it is true
extern core::FileState<MissionSummary> mission_summary;  // of the present mission

// ---- refusals.cpp: why an item, or the mission for one, was not taken, as a text
void reportRefused(uint16_t index, const MissionItem& item, MissionResult result);
void reportRefused(uint16_t index, ::mission::LongestPass::Verdict verdict);

// Leaves AUTO for this mode once the pass that runs is over.
void leaveForMode(state::Mode mode);

}  // namespace mission
}  // namespace firmware

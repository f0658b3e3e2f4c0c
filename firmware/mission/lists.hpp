// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of records that change as a whole: the mission (upload.cpp puts its items), the fence and
// the rally points, whose records are what gcs/ makes of them. One is changed at a time;
// until a commit is accepted the old list is the list, and a power cut leaves one of the two.
#pragma once
#include <stdint.h>

#include "firmware/mission/mission.hpp"
#include "storage/lists.hpp"

namespace firmware {
namespace mission {

using storage::ListKind;

uint8_t listCapacity(ListKind kind);    // 171 records of 14 bytes, 20 of 10, 10 of 11
uint8_t listCount(ListKind kind);       // 0 also while missionKnown() is false
uint8_t listGeneration(ListKind kind);  // another one after every commit
uint32_t listId(ListKind kind);         // of its contents: storage::listId()
// busy: in a later frame. bad_argument: no such record.
MUST_USE core::Status listRead(ListKind kind, uint8_t index, uint8_t* to);

// begin, then every record in order, put or copied, then commit until it is not busy. A begin
// forgets what was staged before, of any kind: who has an upload open denies it to others. `set`
// (1..255) is stored with the list; the fence and the rally points have the version of their
// records there. denied: the EEPROM is another firmware's. no_space: more than the capacity, or no
// room beside the present list, which only is so without a DataFlash, and reported.
MissionResult listBegin(ListKind kind, uint16_t count, uint8_t set);
MissionResult listPut(const uint8_t* record);
MissionResult listCopy();   // the record that the present list has in this place
uint8_t listStaged();       // records put or copied so far ...
uint8_t listStagedCount();  // ... of so many
MissionResult listCommit();
void listAbort();
MissionResult listClear(ListKind kind, uint8_t set);  // until it is not busy

bool listStaging(ListKind kind);  // begun and not yet committed
uint8_t listSet(ListKind kind);

}  // namespace mission
}  // namespace firmware

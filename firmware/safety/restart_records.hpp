// SPDX-License-Identifier: GPL-3.0-or-later
// Between the files of this folder only: the records of a flight, in memory that a reset leaves
// alone, and which of them go on.
#pragma once
#include "firmware/state/restart_record.hpp"

namespace firmware {
namespace safety {

struct RestartRecords {
    state::SlowRecord slow;
    state::FastRecord fast[2];  // written in turn
    state::HangGyroRecord hang;
};
extern RestartRecords records;

// That was in the air when the last run ended; nullptr: there is none.
const state::FastRecord* flightToResume();

// The one written last, and the one to be written next. finishFastRecord() numbers the latter and
// gives it its checksum: from then on it is the newest, and not before, as a reset may come
// between.
const state::FastRecord& newestFastRecord();
state::FastRecord& nextFastRecord();
void finishFastRecord();

}  // namespace safety
}  // namespace firmware

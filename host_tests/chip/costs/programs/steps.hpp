// SPDX-License-Identifier: GPL-3.0-or-later
// What the programs of this folder time, each between its mark and the end's. costs.cpp reads it.
#pragma once
#include <stdint.h>

#include "hal/trace.hpp"

namespace costs {

enum Step : uint8_t {
    kNothing = 0x50,  // two marks
    kDistance,
    kBearing,
    kOffset,
    kTrack,
    kPassed,
    kNewBand,
    kNaiveDistance,
    kNaiveBearing,
    kNaiveOffset,
    kNaiveTrack,
    kNaivePassed,
    kIdlePoll,
    kAdvance,
    kHeavyStep,
    kUploadItem,
    kHeartbeat,      // received, MAVLink 1
    kCommand,        // COMMAND_LONG, MAVLink 2
    kItem,           // MISSION_ITEM_INT, MAVLink 2
    kNoise,          // one byte of it
    kFalseStarts,    // one byte of a line full of what looks like known messages
    kSendHeartbeat,  // MAVLink 1
    kSendPosition,   // GLOBAL_POSITION_INT, MAVLink 2
    kSendText,       // STATUSTEXT, MAVLink 2, of 50 letters
    kHashBlock,      // 64 bytes of SHA-256
    kHashQuarter,    // what is done of it at once
    kCheckSlice,     // one slice of checking a signed COMMAND_LONG
    kSignSlice,      // one slice of signing a GLOBAL_POSITION_INT
    kBroken = 0x7F,  // the program has not done what is to be timed
};

constexpr uint8_t kHeartbeatBytes = 17, kCommandBytes = 44, kItemBytes = 49;

// Fails the measurement. A mark counts when it ends.
inline void broken() {
    hal::trace(kBroken);
    hal::trace(hal::kTraceTaskEnd);
}

// Between two marks, with nothing of the caller's inlined into it.
template <class Work>
__attribute__((noinline)) void timed(Step step, Work work) {
    hal::trace(step);
    work();
    hal::trace(hal::kTraceTaskEnd);
}

}  // namespace costs

// SPDX-License-Identifier: GPL-3.0-or-later
// What link.cpp times on the chip, each between its mark and the end's. measure.cpp reads it.
#pragma once
#include <stdint.h>

namespace costs {

enum Step : uint8_t {
    kNothing = 0x50,  // two marks
    kHeartbeat,       // received, MAVLink 1
    kCommand,         // COMMAND_LONG, MAVLink 2
    kItem,            // MISSION_ITEM_INT, MAVLink 2
    kNoise,           // one byte of it
    kFalseStarts,     // one byte of a line full of what looks like known messages
    kSendHeartbeat,   // MAVLink 1
    kSendPosition,    // GLOBAL_POSITION_INT, MAVLink 2
    kSendText,        // STATUSTEXT, MAVLink 2, of 50 letters
};

constexpr uint8_t kHeartbeatBytes = 17, kCommandBytes = 44, kItemBytes = 49;
constexpr uint8_t kSentHeartbeatBytes = 17, kSentPositionBytes = 40, kSentTextBytes = 63;

}  // namespace costs

// SPDX-License-Identifier: GPL-3.0-or-later
// The flight log: begins when the airplane is armed, ends when it is disarmed (LOG_BITMASK bit 16:
// begins at start). What is logged how often is the table in log.cpp. A record for which the chip
// has no time waits; the next of its kind takes its place, and PM and the ground are informed.
#pragma once
#include <stdint.h>

#include "logging/log_store.hpp"

#include "core/file_state.hpp"

namespace firmware {
namespace logger {

extern core::FileState<logging::LogStore> flight_logs;

void logStart();
// In the rest of a frame, until the newest page is found. True: did something.
bool logFind();
void runLog();  // 50 Hz

// What is reported may not change until the log has it.
inline bool logOpen() { return flight_logs.writing(); }

// On the ground no log is written while one is read; arming resumes it in any case.
void logPause(bool pause);
void logErase();  // in the background, reported when done; arming stops it

// The mission's engine has begun this item.
void logCommand(uint8_t index);

// The parameter as it is now. False: not yet, ask again.
bool logParameter(uint8_t row);

uint16_t logDropped();  // records since start

}  // namespace logger
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/restart_records.hpp"

#include "firmware/safety/restart.hpp"
#include "hal/watchdog.hpp"

namespace firmware {
namespace safety {

using namespace state;

using hal::ResetCause;

SlowRecord steady __attribute__((section(".noinit")));
FastRecord moving[2] __attribute__((section(".noinit")));
HangGyroRecord blind __attribute__((section(".noinit")));
uint8_t number;
const FastRecord* last;  // to go on with; nullptr: nothing

bool lostTimeKnown() {
    const ResetCause cause = hal::resetCause();
    return cause == ResetCause::watchdog || cause == ResetCause::fault;
}

// A reset that somebody wanted ends the flight. Behind the bootloaders a loss of power looks like
// many things, and memory survives a short one: there the records alone decide.
bool mayGoOn() {
    const ResetCause cause = hal::resetCause();
    return cause != ResetCause::asked && cause != ResetCause::external;
}

void restartBegin() {
    last = mayGoOn() && isValid(steady) ? newest(moving) : nullptr;
    if (last != nullptr && !last->in_the_air) last = nullptr;
    if (last != nullptr) return;
    for (FastRecord& each : moving) invalidate(each);
    invalidate(steady);
}

bool memorySurvived() {
    return lostTimeKnown() || hal::resetCause() == ResetCause::brown_out || flyingOn();
}

bool flyingOn() { return last != nullptr; }

}  // namespace safety
}  // namespace firmware

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

bool runSurvives() {
    const ResetCause cause = hal::resetCause();
    return cause == ResetCause::watchdog || cause == ResetCause::brown_out ||
           cause == ResetCause::fault;
}

void restartBegin() {
    last = runSurvives() && isValid(steady) ? newest(moving) : nullptr;
    if (last != nullptr && !last->in_the_air) last = nullptr;
    if (last != nullptr) return;
    for (FastRecord& each : moving) invalidate(each);
    invalidate(steady);
}

bool flyingOn() { return last != nullptr; }

}  // namespace safety
}  // namespace firmware

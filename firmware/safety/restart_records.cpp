// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/restart_records.hpp"

#include "core/file_state.hpp"
#include "firmware/safety/restart.hpp"
#include "hal/watchdog.hpp"

namespace firmware {
namespace safety {

using namespace state;

using hal::ResetCause;

RestartRecords records __attribute__((section(".noinit")));

namespace {

struct InUse {
    uint8_t number;  // of the newest fast record, which is fast[number & 1]
    const FastRecord* resumes;
};
core::FileState<InUse> in_use{};

// A reset that somebody wanted ends the flight. Behind the bootloaders a loss of power looks like
// many things, and memory survives a short one: there the records alone decide.
bool mayGoOn() {
    const ResetCause cause = hal::resetCause();
    return cause != ResetCause::asked && cause != ResetCause::external;
}

const FastRecord* flightInTheAir() {
    const FastRecord* found = mayGoOn() && isValid(records.slow) ? newest(records.fast) : nullptr;
    return found != nullptr && found->in_the_air ? found : nullptr;
}

}  // namespace

const FastRecord* flightToResume() { return in_use.resumes; }
const FastRecord& newestFastRecord() { return records.fast[in_use.number & 1]; }
FastRecord& nextFastRecord() { return records.fast[(in_use.number + 1) & 1]; }

void finishFastRecord() {
    FastRecord& next = nextFastRecord();
    next.number = in_use.number + 1;
    updateChecksum(next);
    in_use.number = next.number;
}

void restartBegin() {
    in_use = {0, flightInTheAir()};
    if (flyingOn()) {
        in_use.number = in_use.resumes->number;
        return;
    }
    for (FastRecord& each : records.fast) invalidate(each);
    invalidate(records.slow);
}

bool lostTimeKnown() {
    const ResetCause cause = hal::resetCause();
    return cause == ResetCause::watchdog || cause == ResetCause::fault;
}

bool memorySurvived() {
    return lostTimeKnown() || hal::resetCause() == ResetCause::brown_out || flyingOn();
}

bool flyingOn() { return in_use.resumes != nullptr; }

}  // namespace safety
}  // namespace firmware

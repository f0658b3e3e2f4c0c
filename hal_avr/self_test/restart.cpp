// SPDX-License-Identifier: GPL-3.0-or-later
#include "hal/trace.hpp"
#include "hal/watchdog.hpp"
#include "self_test/parts.hpp"
#include "self_test/pause.hpp"
#include "self_test/report.hpp"

namespace self_test {

namespace {

constexpr uint8_t kHangs = 0xA5;  // survives in the note of the last run

}  // namespace

void testWatchdog() {
    constexpr uint8_t kSent_ms = 50;  // what waits in the port's buffer goes out before
    text(TEXT("watchdog waits"));
    endLine();
    pause_ms(kSent_ms);
    hal::trace(kHangs);
    hal::watchdogStart();
    for (;;) {
    }
}

bool wasBitten() {
    return hal::resetCause() == hal::ResetCause::watchdog && hal::lastRun().trace == kHangs;
}

}  // namespace self_test

// SPDX-License-Identifier: GPL-3.0-or-later
// The board's self-test: a program of its own, which toolchain/self_test writes in place of the
// firmware. It measures what the firmware cannot show a ground station, or must not do in an
// airplane. No output ever gets more than 1000 us, at which a speed controller keeps its motor
// still.
#include "board.hpp"
#include "hal/clock.hpp"
#include "hal/watchdog.hpp"
#include "self_test/parts.hpp"
#include "self_test/report.hpp"

namespace {

using namespace self_test;

// In the order of hal::ResetCause.
const char* nameOf(hal::ResetCause cause) {
    switch (cause) {
        case hal::ResetCause::power_on:
            return TEXT("power_on");
        case hal::ResetCause::external:
            return TEXT("external");
        case hal::ResetCause::brown_out:
            return TEXT("brown_out");
        case hal::ResetCause::watchdog:
            return TEXT("watchdog");
        case hal::ResetCause::fault:
            return TEXT("fault");
        case hal::ResetCause::asked:
            return TEXT("asked");
        case hal::ResetCause::unknown:
            break;
    }
    return TEXT("unknown");
}

void begin() {
    line(TEXT("self test of APM "), board::kModel);
    text(TEXT("started by "));
    text(nameOf(hal::resetCause()));
    endLine();
}

void testEverything() {
    startSensors();
    testSupply();
    testSensors();
    testCompass();
    testPulses();
    testEeprom();
    testDataflash();
    testRam();
    testWatchdog();
}

}  // namespace

int main() {
    board::start();
    openReport();
    // what listens has reset the board by opening the port, or, at a simulator's, comes after it
    constexpr uint16_t kListens_ms = 3000, kListensAgain_ms = 500;
    while (hal::now_ms() < (wasBitten() ? kListensAgain_ms : kListens_ms)) {
    }
    begin();
    if (!wasBitten()) testEverything();  // does not return: the watchdog ends it
    text(TEXT("end"));
    endLine();
    for (;;) {
    }
}

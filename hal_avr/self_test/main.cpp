// SPDX-License-Identifier: GPL-3.0-or-later
// The board's self-test: a program of its own, which toolchain/self_test writes in place of the
// firmware. It measures what the firmware cannot show a ground station, or must not do in an
// airplane. No output ever gets more than 1000 us, at which a speed controller keeps its motor
// still.
#include "board.hpp"
#include "core/rom.hpp"
#include "hal/watchdog.hpp"
#include "self_test/parts.hpp"
#include "self_test/pause.hpp"
#include "self_test/report.hpp"

namespace {

using namespace self_test;

// In the order of hal::ResetCause.
constexpr char kCauses[][10] ROM = {"power_on", "external", "brown_out", "watchdog",
                                    "unknown",  "fault",    "asked"};

void begin() {
    line(TEXT("self test of APM "), board::kModel);
    text(TEXT("started by "));
    text(kCauses[static_cast<uint8_t>(hal::resetCause())]);
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
    pause_ms(wasBitten() ? kListensAgain_ms : kListens_ms);
    begin();
    if (!wasBitten()) testEverything();  // does not return: the watchdog ends it
    text(TEXT("end"));
    endLine();
    for (;;) {
    }
}

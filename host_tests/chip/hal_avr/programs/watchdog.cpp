// SPDX-License-Identifier: GPL-3.0-or-later
// Reports why it was started and feeds the watchdog for a second; then, when the relay's pin says
// so, starts again by itself, or waits to be bitten.
#include "hal/watchdog.hpp"

#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

int main() {
    board::start();
    report(1, static_cast<uint16_t>(hal::resetCause()));
    hal::watchdogStart();
    while (hal::now_ms() < 1000) hal::watchdogFeed();
    report(2, 0);
    if (hal::resetCause() == hal::ResetCause::watchdog) {
        report(3, 0);
        hal::reboot();
    }
    for (;;) {
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Reports why it was started, resets the hang timer for half a second and then no more; scans the
// analogue inputs all the time and reports the first of them; stores a number after each scan;
// sleeps in between.
#include "hal/hang_timer.hpp"

#include "hal/analog.hpp"
#include "hal/eeprom.hpp"
#include "hal/watchdog.hpp"
#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
void passSticksToServos() { report(3, 0); }
}  // namespace hal

int main() {
    board::start();
    report(1, static_cast<uint16_t>(hal::resetCause()));
    hal::hangTimerStart();
    uint32_t scanned_ms = 0;
    uint8_t stored = 0;
    bool reported = false;
    for (;;) {
        if (hal::now_ms() - scanned_ms >= 20) {
            scanned_ms = hal::now_ms();
            const hal::AnalogSum taken = hal::analogTake(hal::Analog::airspeed);
            if (taken.count > 0) report(4, taken.sum / taken.count);
            hal::analogScan();
            if (hal::eepromWrite(500, &stored, 1) == core::Status::ok) ++stored;
        }
        if (hal::now_ms() < 500) {
            hal::hangTimerReset();
        } else if (!reported) {
            reported = true;
            report(2, 0);
        }
        hal::idle(nothingWaits);
    }
}

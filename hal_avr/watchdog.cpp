// SPDX-License-Identifier: GPL-3.0-or-later
#include "hal/watchdog.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/wdt.h>

namespace {
uint8_t reset_flags __attribute__((section(".noinit")));
}

// Runs before RAM is prepared: after a watchdog reset the watchdog is still on, at 15 ms, and its
// enable bit is held by WDRF (data sheet 12.4).
extern "C" void saveResetFlags() __attribute__((naked, used, section(".init3")));
void saveResetFlags() {
    reset_flags = MCUSR;
    MCUSR = 0;
    wdt_disable();
}

namespace hal {

ResetCause resetCause() {
    // The supply's rise sets other flags along with its own. A bootloader may have cleared all.
    if (reset_flags & (1 << PORF)) return ResetCause::power_on;
    if (reset_flags & (1 << WDRF)) return ResetCause::watchdog;
    if (reset_flags & (1 << BORF)) return ResetCause::brown_out;
    if (reset_flags & (1 << EXTRF)) return ResetCause::external;
    return ResetCause::unknown;
}

void watchdogStart() { wdt_enable(WDTO_250MS); }
void watchdogFeed() { wdt_reset(); }

void reboot() {
    cli();
    wdt_enable(WDTO_15MS);
    wdt_reset();  // the 15 ms count from here, whatever it counted before
    for (;;) {
    }
}

}  // namespace hal

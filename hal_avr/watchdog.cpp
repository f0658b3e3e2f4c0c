// SPDX-License-Identifier: GPL-3.0-or-later
#include "hal/watchdog.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/wdt.h>

#include "hal/interrupts.hpp"
#include "restart.hpp"
#include "wiring.hpp"

namespace {
uint8_t reset_flags __attribute__((section(".noinit")));

// Left by a restart through address 0, of which the hardware knows nothing.
constexpr uint16_t kRestarted = 0x5AC3;
uint16_t restarted __attribute__((section(".noinit")));
}  // namespace

// Runs before RAM is prepared: after a watchdog reset the watchdog is still on, at 15 ms, and its
// enable bit is held by WDRF (data sheet 12.4).
extern "C" void saveResetFlags() __attribute__((naked, used, section(".init3")));
void saveResetFlags() {
    reset_flags = MCUSR;
    if (!wiring::kWatchdogResets) {
        if (reset_flags == 0 && restarted == kRestarted) reset_flags = 1 << WDRF;
        restarted = 0;
    }
    MCUSR = 0;
    wdt_disable();
}

namespace avr {

// Everything that could still act or interrupt is as after a reset: all of the extended registers
// from the pin change control on (OSCCAL and the clock's divider lie before it), the ports, and
// the few below; then the flags.
void restart() {
    cli();
    restarted = kRestarted;
    for (uint16_t at = 0x68; at <= 0x136; ++at) *reinterpret_cast<volatile uint8_t*>(at) = 0;
    for (uint16_t at = 0x20; at <= 0x34; ++at) *reinterpret_cast<volatile uint8_t*>(at) = 0;
    EIMSK = SPCR = EECR = TCCR0A = TCCR0B = 0;
    TIFR0 = TIFR1 = TIFR2 = TIFR3 = TIFR4 = TIFR5 = EIFR = PCIFR = 0xFF;
    __asm__ volatile("jmp 0");
    __builtin_unreachable();
}

}  // namespace avr

namespace hal {

ResetCause resetCause() {
    // The supply's rise sets other flags along with its own. A bootloader may have cleared all.
    if (reset_flags & (1 << PORF)) return ResetCause::power_on;
    if (reset_flags & (1 << WDRF)) return ResetCause::watchdog;
    if (reset_flags & (1 << BORF)) return ResetCause::brown_out;
    if (reset_flags & (1 << EXTRF)) return ResetCause::external;
    return ResetCause::unknown;
}

void watchdogStart() {
    if (wiring::kWatchdogResets) {
        wdt_enable(WDTO_250MS);
        return;
    }
    Locked locked;
    wdt_reset();
    WDTCSR = (1 << WDCE) | (1 << WDE);
    WDTCSR = (1 << WDIE) | WDTO_250MS;  // its interrupt, no reset
}
void watchdogFeed() { wdt_reset(); }

void reboot() {
    if (!wiring::kWatchdogResets) avr::restart();
    cli();
    wdt_enable(WDTO_15MS);
    wdt_reset();  // the 15 ms count from here, whatever it counted before
    for (;;) {
    }
}

}  // namespace hal

// SPDX-License-Identifier: GPL-3.0-or-later
#include "hal/watchdog.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/wdt.h>

#include "hal/clock.hpp"
#include "hal/interrupts.hpp"
#include "restart.hpp"
#include "wiring.hpp"

using hal::ResetCause;

namespace {

// Of this run once it ends; until then of the last one, and without a checksum.
struct Note {
    hal::LastRun run;
    uint16_t checksum;  // of chance contents it is wrong
};
Note note __attribute__((section(".noinit")));

struct {
    uint8_t low, high;  // how long a low supply is still remembered, and its complement
} supply __attribute__((section(".noinit")));

constexpr uint8_t kStartUp_ms = 65;  // that the fuses add to every reset: data sheet 10.4, SUT 11
constexpr uint8_t kSupplyRemembered = 60;  // times 4 ms

uint16_t checksumOf(const hal::LastRun& run) {
    constexpr uint16_t kChecksumStart = 0x5AC3;
    return static_cast<uint16_t>(kChecksumStart ^ run.ended_ms ^
                                 (run.trace << 8 | uint8_t(run.ended)));
}

bool noted() { return note.checksum == checksumOf(note.run); }

ResetCause causeOf(uint8_t flags) {
    // The supply's rise sets other flags along with its own.
    if (flags & (1 << PORF)) return ResetCause::power_on;
    if (noted()) return note.run.ended;
    if (flags & (1 << WDRF)) return ResetCause::watchdog;
    if (flags & (1 << BORF)) return ResetCause::brown_out;
    if (flags & (1 << EXTRF)) return ResetCause::external;
    const bool sagged = supply.low != 0 && (supply.low ^ supply.high) == 0xFF;
    return sagged ? ResetCause::brown_out : ResetCause::unknown;
}

// After a watchdog reset the watchdog is still on, at 15 ms, and its enable bit is held by WDRF
// (data sheet 12.4).
__attribute__((noinline)) void examineLastRun() {
    const uint8_t flags = MCUSR;
    MCUSR = 0;
    wdt_disable();
    hal::LastRun& run = note.run;
    const bool known = noted();
    run.ended = causeOf(flags);
    const bool through_zero =
        known && (run.ended == ResetCause::watchdog || run.ended == ResetCause::fault);
    run.restart_ms = through_zero ? 0 : kStartUp_ms;
    note.checksum = static_cast<uint16_t>(~checksumOf(note.run));
    supply.low = 0;
}

void leaveNote(ResetCause why) {
    note.run.ended = why;
    note.run.trace = GPIOR0;
    note.run.ended_ms = static_cast<uint16_t>(hal::now_ms());
    note.checksum = checksumOf(note.run);
}

// Everything that could still act or interrupt is as after a reset: all of the extended registers
// from the pin change control on (OSCCAL and the clock's divider lie before it), the ports, and
// the few below; then the flags. The watchdog is switched off by examineLastRun().
[[noreturn]] void beginThroughZero() {
    for (uint16_t at = 0x68; at <= 0x136; ++at) *reinterpret_cast<volatile uint8_t*>(at) = 0;
    for (uint16_t at = 0x20; at <= 0x34; ++at) *reinterpret_cast<volatile uint8_t*>(at) = 0;
    EIMSK = SPCR = EECR = TCCR0A = TCCR0B = 0;
    TIFR0 = TIFR1 = TIFR2 = TIFR3 = TIFR4 = TIFR5 = EIFR = PCIFR = 0xFF;
    __asm__ volatile("jmp 0");
    __builtin_unreachable();
}

}  // namespace

// Before RAM is prepared.
extern "C" void saveResetFlags() __attribute__((naked, used, section(".init3")));
void saveResetFlags() { examineLastRun(); }

// Where a reset may follow, it does so when interrupts are off for too long.
ISR(WDT_vect) { avr::restart(ResetCause::watchdog); }

namespace avr {

void restart(ResetCause why) {
    cli();
    leaveNote(why);
    const bool resets = wiring::kWatchdogResets && why == ResetCause::asked;
    if (!resets) beginThroughZero();
    wdt_enable(WDTO_15MS);
    wdt_reset();  // the 15 ms count from here, whatever it counted before
    for (;;) {
    }
}

volatile bool supply_sags;

void noteSupply(bool low) {
    constexpr uint16_t kLongest = 500;  // times 4 ms
    static uint16_t lasts;
    if (low)
        supply.low = kSupplyRemembered;
    else if (supply.low != 0)
        --supply.low;
    supply.high = static_cast<uint8_t>(~supply.low);
    if (supply.low == 0) lasts = 0;
    supply_sags = supply.low != 0 && lasts < kLongest;
    if (supply_sags) ++lasts;
}

}  // namespace avr

namespace hal {

const LastRun& lastRun() { return note.run; }

void watchdogStart() {
    constexpr uint8_t kMode = (1 << WDIE) | (wiring::kWatchdogResets ? 1 << WDE : 0);
    const Locked locked;
    wdt_reset();
    WDTCSR = (1 << WDCE) | (1 << WDE);
    WDTCSR = kMode | WDTO_120MS;
}
void watchdogFeed() { wdt_reset(); }

void reboot() { avr::restart(ResetCause::asked); }

}  // namespace hal

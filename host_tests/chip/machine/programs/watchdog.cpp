// SPDX-License-Identifier: GPL-3.0-or-later
// Lets the watchdog bite once, then reports the cause of every start; .noinit memory remembers.
#include <avr/wdt.h>

#include "report.hpp"

__attribute__((section(".noinit"))) volatile uint8_t starts;

int main() {
    const uint8_t cause = MCUSR;
    MCUSR = 0;
    wdt_disable();
    if (cause & _BV(PORF)) starts = 0;
    starts++;
    report(starts, cause);
    if (starts == 1) {
        wdt_enable(WDTO_15MS);
        for (uint32_t i = 0; i < 40000; i++) wdt_reset();
        report(0x80, 0);
        for (;;) {
        }
    }
    for (;;) {
    }
}

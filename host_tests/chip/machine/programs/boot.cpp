// SPDX-License-Identifier: GPL-3.0-or-later
// Tells what it finds at its start: the cause that is left, and how much of the RAM below, above
// and between those two what it wrote there the time before. Then waits for the watchdog.
#include <avr/wdt.h>

#include "report.hpp"

static uint8_t* const kBelow = reinterpret_cast<uint8_t*>(0x0300);
static uint8_t* const kBetween = reinterpret_cast<uint8_t*>(0x1000);
static uint8_t* const kAbove = reinterpret_cast<uint8_t*>(0x2100);

int main() {
    report(1, MCUSR);
    report(2, WDTCSR);
    report(3, static_cast<uint16_t>(*kBelow | *kAbove << 8));
    report(4, *kBetween);
    *kBelow = *kBetween = *kAbove = 0x5A;
    wdt_enable(WDTO_15MS);
    for (;;) {
    }
}

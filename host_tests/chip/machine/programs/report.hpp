// SPDX-License-Identifier: GPL-3.0-or-later
// How the test programs speak: two bytes, then the number of the report.
#pragma once
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <stdint.h>

static inline void report(uint8_t number, uint16_t value) {
    GPIOR1 = static_cast<uint8_t>(value);
    GPIOR2 = static_cast<uint8_t>(value >> 8);
    GPIOR0 = number;
}

static inline void sleepForEver() {
    for (;;) sleep_mode();
}

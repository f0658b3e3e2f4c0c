// SPDX-License-Identifier: GPL-3.0-or-later
// How the programs speak: two bytes in GPIOR1 and GPIOR2, then the number of the report in GPIOR0.
// Each program is the hardware layer and a main() that exercises one part of it.
#pragma once
#include <avr/io.h>
#include <stdint.h>

#include "board.hpp"
#include "hal/clock.hpp"
#include "hal/imu_interrupt.hpp"
#include "hal/interrupts.hpp"
#include "hal/trace.hpp"

static inline void report(uint8_t number, uint16_t value) {
    const hal::Locked locked;  // interrupts keep registers there
    GPIOR1 = static_cast<uint8_t>(value);
    GPIOR2 = static_cast<uint8_t>(value >> 8);
    hal::trace(number);
}

static inline bool nothingWaits() { return false; }

static inline void wait_ms(uint16_t time_ms) {
    const uint32_t start_us = hal::now_us();
    while (hal::now_us() - start_us < 1000UL * time_ms) {
    }
}

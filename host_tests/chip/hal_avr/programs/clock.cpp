// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the clock at every phase of its overflow, with interrupts on and off.
#include <avr/interrupt.h>

#include "hal/interrupts.hpp"
#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

static void sample(uint8_t number) {
    const uint32_t us = hal::now_us();
    report(number, static_cast<uint16_t>(us));
    report(number + 1, static_cast<uint16_t>(us >> 16));
}

static uint32_t last_us, last_ms;

static void checkOrder() {
    static uint8_t nops;
    const uint32_t us = hal::now_us();
    const uint32_t ms = hal::now_ms();
    if (us - last_us > 1000) report(0x10, static_cast<uint16_t>(us - last_us));
    if (ms - last_ms > 1) report(0x11, static_cast<uint16_t>(ms - last_ms));
    if (static_cast<uint32_t>(ms - us / 1000) > 1) report(0x12, static_cast<uint16_t>(us));
    last_us = us;
    last_ms = ms;
    for (volatile uint8_t i = ++nops; i > 0; --i) {
    }
}

// The interrupt is kept waiting over an overflow; the readings may not fall back.
static void acrossAMaskedOverflow() {
    while (TCNT5 < 0xFF00) {
    }
    hal::Locked locked;
    last_us = hal::now_us();
    last_ms = hal::now_ms();
    for (uint16_t i = 0; i < 200; ++i) {
        const uint32_t us = hal::now_us();
        const uint32_t ms = hal::now_ms();
        if (us - last_us > 100 || ms - last_ms > 1) report(0x13, static_cast<uint16_t>(us));
        last_us = us;
        last_ms = ms;
    }
    report(0x20, TIFR5 & (1 << TOV5));
}

int main() {
    board::start();
    sample(1);
    for (uint8_t i = 0; i < 20; ++i) acrossAMaskedOverflow();
    last_us = hal::now_us();
    last_ms = hal::now_ms();
    while (hal::now_ms() < 3000) checkOrder();
    sample(3);
    report(5, static_cast<uint16_t>(hal::now_ms()));
    for (;;) hal::idle(nothingWaits);
}

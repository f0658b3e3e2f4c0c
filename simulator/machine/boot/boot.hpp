// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for a board's bootloader, which a reset begins with (fuse BOOTRST): no more than what
// it does to the application that it starts. Of the RAM both take more than any bootloader would:
// a KiB of variables from below, a KiB of stack and packet buffer from above.
#pragma once
#include <avr/io.h>
#include <avr/wdt.h>
#include <stdint.h>
#include <util/delay.h>

// The fuses hold the chip in reset for this long after whatever caused it (SUT 11); libsimavr lets
// it run at once.
constexpr uint8_t kStartUp_ms = 65;

inline __attribute__((always_inline)) void scribble(uint16_t from, uint16_t to) {
    for (volatile uint8_t* at = reinterpret_cast<volatile uint8_t*>(from);
         at <= reinterpret_cast<volatile uint8_t*>(to); ++at)
        *at = 0xB0;
}

inline __attribute__((always_inline, noreturn)) void startApplication() {
    scribble(0x0200, 0x05FF);
    scribble(0x1E00, RAMEND);
    __asm__ volatile("jmp 0");
    __builtin_unreachable();
}

// No start-up code comes before it and none of its variables lies in RAM.
extern "C" void boot() __attribute__((naked, noreturn, section(".vectors")));

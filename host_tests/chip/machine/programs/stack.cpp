// SPDX-License-Identifier: GPL-3.0-or-later
// A known deepest stack, crossing a 256-byte boundary in both directions, and known static RAM.
#include "report.hpp"

volatile uint32_t initialised = 0x12345678;  // .data
volatile uint8_t zeroed[10];                 // .bss
__attribute__((section(".noinit"))) volatile uint8_t kept[6];
volatile uint8_t sink;  // .bss

// 300 bytes of frame and no call inside: only the moved stack pointer shows it.
__attribute__((noinline)) void leaf() {
    volatile uint8_t frame[300];
    frame[0] = 1;
    frame[299] = frame[0];
    sink = frame[299];
    report(1, SP);
}

__attribute__((noinline)) void shallow(uint8_t depth) {
    volatile uint8_t frame[20];
    frame[depth] = depth;
    if (depth) shallow(depth - 1);
    sink = frame[0];
}

EMPTY_INTERRUPT(TIMER2_COMPA_vect)

int main() {
    kept[0] = zeroed[0] = static_cast<uint8_t>(initialised);
    for (uint8_t i = 0; i < 5; i++) shallow(8);
    leaf();
    for (uint8_t i = 0; i < 5; i++) shallow(8);
    TCCR2A = _BV(WGM21);
    OCR2A = 249;
    TIMSK2 = _BV(OCIE2A);
    TCCR2B = _BV(CS22);  // 1 kHz
    sei();
    sleepForEver();
}

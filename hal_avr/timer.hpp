// SPDX-License-Identifier: GPL-3.0-or-later
// The 16-bit timers by number: alike but for their addresses.
#pragma once
#include <avr/io.h>

namespace avr {

// TCCRnA and the registers after it (data sheet, register summary)
struct Timer {
    volatile uint8_t control_a, control_b, control_c, reserved;
    volatile uint16_t count, capture;  // where the capture register is the counter's TOP: the TOP
    volatile uint16_t compare[3];
};

constexpr uint16_t timerAddress(uint8_t number) {
    return number == 1 ? 0x80 : number == 3 ? 0x90 : number == 4 ? 0xA0 : 0x120;
}

inline Timer& timerAt(uint16_t address) { return *reinterpret_cast<Timer*>(address); }
template <uint8_t number>
inline __attribute__((always_inline)) Timer& timer() {
    static_assert(number == 1 || (number >= 3 && number <= 5), "0 and 2 have 8 bits");
    return timerAt(timerAddress(number));
}

inline volatile uint8_t& interruptMask(uint8_t number) { return (&TIMSK0)[number]; }
inline volatile uint8_t& interruptFlags(uint8_t number) { return (&TIFR0)[number]; }

// Of the compare output 0..2: A, B, C.
constexpr uint8_t comparePin(uint8_t compare) {
    return static_cast<uint8_t>(0x80 >> (2 * compare));
}
// `bit` is that of A; each compare's after it lies `step` to the right. Those of `first` to `last`.
constexpr uint8_t comparesBetween(uint8_t bit, uint8_t step, char first, char last) {
    uint8_t bits = 0;
    for (char name = first; name <= last; ++name) {
        bits = static_cast<uint8_t>(bits | bit >> (step * (name - 'A')));
    }
    return bits;
}
constexpr uint8_t compareBit(uint8_t compare) { return static_cast<uint8_t>(2 << compare); }

}  // namespace avr

// SPDX-License-Identifier: GPL-3.0-or-later
// What a board says of its servo outputs, and what its interrupts call.
#pragma once
#include "timer.hpp"

namespace avr {

struct ServoPin {
    uint16_t address;
    uint8_t timer;
    uint8_t compare;  // 0..2: A, B, C
};

template <uint8_t timer>
constexpr ServoPin servoOn(char compare) {
    return {timerAddress(timer), timer, static_cast<uint8_t>(compare - 'A')};
}

// The board's: its timers run to TOP, all outputs are silent and its pins outputs.
void servoTimersStart(uint16_t top);

// Makes the output registers of the compares `first` to `last` low, whose pins the port has: a
// program that begins again through address 0 in the middle of a pulse finds them high, and they
// would hold their pins so from the first writing to the next match. Outside PWM modes only, with
// an output mode (data sheet 17.7.1, 17.7.3, 17.8).
template <uint8_t number, char first, char last>
inline void forceServosLow() {
    Timer& to = timer<number>();
    to.control_a = comparesBetween(0x80, 2, first, last);  // a match clears
    to.control_c = comparesBetween(0x80, 1, first, last);
    to.control_a = 0;
}

// For that: the timer counts 0.5 us to TOP in mode 14, all its pins are the port's.
template <uint8_t number, char first, char last>
inline void startServoTimer(uint16_t top) {
    constexpr uint8_t kMode = (1 << WGM13) | (1 << WGM12);
    Timer& to = timer<number>();
    interruptMask(number) = 0;
    to.control_b = 0;  // stopped, no PWM
    forceServosLow<number, first, last>();
    to.control_a = 1 << WGM11;
    to.capture = top;
    to.count = 0;
    to.control_b = kMode | (1 << CS11);
}

// The end of an output's last pulse: for the compare's interrupt.
template <uint8_t number, char compare>
inline __attribute__((always_inline)) void endServo() {
    constexpr uint8_t index = compare - 'A';
    timer<number>().control_a &= static_cast<uint8_t>(~comparePin(index));
    interruptMask(number) &= static_cast<uint8_t>(~compareBit(index));
}

}  // namespace avr

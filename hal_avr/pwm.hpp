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

// For that: the timer counts 0.5 us to TOP in mode 14, all its pins are the port's.
template <uint8_t number>
inline void startServoTimer(uint16_t top) {
    constexpr uint8_t kMode = (1 << WGM13) | (1 << WGM12);
    Timer& to = timer<number>();
    interruptMask(number) = 0;
    to.control_b = kMode;  // stopped
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

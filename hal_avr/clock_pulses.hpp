// SPDX-License-Identifier: GPL-3.0-or-later
// Servo outputs on the clock's own timer, which runs freely and has no period: the compare sets the
// pin at one match and clears it at the next, and its interrupt only says when the next edge is
// due. The hardware makes the edges, so an interrupt that comes late moves none of them.
#pragma once
#include <stdint.h>

#include "wiring.hpp"

namespace avr {

struct ClockPulse {
    uint16_t width;  // in counts of 0.5 us, 0: silent
    uint16_t up;     // of the pulse under way, or the last
};
extern ClockPulse clock_pulses[2];  // of compare B and C
extern uint16_t clock_pulse_period;

void clockPulsesStart(uint16_t period);
void clockPulseWrite(uint8_t compare, uint16_t pulse_halfus);
uint16_t clockPulseRead(uint8_t compare);

// Both bits of the compare's mode: 2 clears the pin at a match, 3 sets it.
constexpr uint8_t compareMode(uint8_t compare, uint8_t mode) {
    return static_cast<uint8_t>(mode << (6 - 2 * compare));
}

// From the compare's interrupt: the pin has just risen or fallen.
template <char name>
inline __attribute__((always_inline)) void clockPulseEdge() {
    constexpr uint8_t kCompare = name - 'A';
    constexpr uint8_t kSets = compareMode(kCompare, 1);  // against clearing: the lower bit
    ClockPulse& pulse = clock_pulses[kCompare - 1];
    Timer& clock = timer<wiring::kClockTimer>();
    const uint16_t edge = clock.compare[kCompare];
    const uint16_t width = pulse.width;
    if (clock.control_a & kSets) {
        if (width != 0) pulse.up = width;
        clock.compare[kCompare] = edge + pulse.up;
        clock.control_a &= static_cast<uint8_t>(~kSets);
    } else if (width == 0) {
        clock.control_a &= static_cast<uint8_t>(~compareMode(kCompare, 3));
        interruptMask(wiring::kClockTimer) &= static_cast<uint8_t>(~compareBit(kCompare));
    } else {
        clock.compare[kCompare] = edge + (clock_pulse_period - pulse.up);
        clock.control_a |= kSets;
    }
}

}  // namespace avr

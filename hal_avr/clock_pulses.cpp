// SPDX-License-Identifier: GPL-3.0-or-later
#include "clock_pulses.hpp"

#include "hal/interrupts.hpp"

namespace avr {

ClockPulse clock_pulses[2];
uint16_t clock_pulse_period;

namespace {

// The interrupt of one edge must have run before the next is due.
constexpr uint16_t kShortest = 200;
constexpr uint16_t kLead = 100;  // from the first order to the first edge

inline Timer& clock() { return timer<wiring::kClockTimer>(); }

void begin(uint8_t compare, uint8_t bit) {
    clock().compare[compare] = clock().count + kLead;
    interruptFlags(wiring::kClockTimer) = bit;
    clock().control_a |= compareMode(compare, 3);
    interruptMask(wiring::kClockTimer) |= bit;
}

}  // namespace

void clockPulsesStart(uint16_t period) {
    constexpr uint8_t kOutputs = compareBit(1) | compareBit(2);
    clock_pulse_period = period;
    clock_pulses[0].width = clock_pulses[1].width = 0;
    clock().control_a &= static_cast<uint8_t>(~(compareMode(1, 3) | compareMode(2, 3)));
    interruptMask(wiring::kClockTimer) &= static_cast<uint8_t>(~kOutputs);
}

void clockPulseWrite(uint8_t compare, uint16_t pulse_halfus) {
    const uint16_t longest = clock_pulse_period - kShortest;
    uint16_t width = pulse_halfus > longest ? longest : pulse_halfus;
    if (width != 0 && width < kShortest) width = kShortest;
    const uint8_t bit = compareBit(compare);
    const hal::Locked locked;
    clock_pulses[compare - 1].width = width;
    const bool runs = clock().control_a & compareMode(compare, 3);
    if (width != 0) {
        if (!runs) begin(compare, bit);
        return;
    }
    // Between two pulses there is none to wait for; one that has just begun ends as it would.
    const bool low = clock().control_a & compareMode(compare, 1);
    if (!low || (interruptFlags(wiring::kClockTimer) & bit)) return;
    clock().control_a &= static_cast<uint8_t>(~compareMode(compare, 3));
    interruptMask(wiring::kClockTimer) &= static_cast<uint8_t>(~bit);
}

uint16_t clockPulseRead(uint8_t compare) {
    const hal::Locked locked;
    return clock_pulses[compare - 1].width;
}

}  // namespace avr

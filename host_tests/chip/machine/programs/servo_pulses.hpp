// SPDX-License-Identifier: GPL-3.0-or-later
// Servo pulses on OC1A as the autopilot makes them: mode 14, 20 ms, 0.5 us steps.
#pragma once
#include "report.hpp"

static inline void startServoPulses() {
    DDRB = _BV(5);
    TCCR1A = _BV(COM1A1) | _BV(WGM11);
    TCCR1B = _BV(WGM13) | _BV(WGM12);
    ICR1 = 39999;
    OCR1A = 2000;
    TCCR1B |= _BV(CS11);
}

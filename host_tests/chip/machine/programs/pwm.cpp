// SPDX-License-Identifier: GPL-3.0-or-later
// Servo pulses: the width is changed in the middle of a pulse, then the rate.
#include "servo_pulses.hpp"

int main() {
    startServoPulses();
    for (uint8_t period = 1; period <= 40; period++) {
        TIFR1 = _BV(TOV1);
        while (!(TIFR1 & _BV(TOV1))) {
        }
        while (TCNT1 < 1000) {
        }
        if (period == 3) OCR1A = 4000;  // while the pulse is high
        if (period == 6) OCR1A = 1800;
        if (period == 8) PORTB |= _BV(7);  // a write to the port must not touch the output
        if (period == 10) report(1, OCR1A);
        if (period == 12) ICR1 = 19999;
        if (period == 20) OCR1A = 1800 + 2 * 256;  // the same low byte
    }
    for (;;) {
    }
}

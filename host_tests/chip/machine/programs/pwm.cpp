// SPDX-License-Identifier: GPL-3.0-or-later
// Servo pulses on OC1A as the autopilot makes them: mode 14, 20 ms, 0.5 us steps; the width is
// changed in the middle of a pulse, then the rate.
#include "report.hpp"

int main() {
    DDRB = _BV(5);
    TCCR1A = _BV(COM1A1) | _BV(WGM11);
    TCCR1B = _BV(WGM13) | _BV(WGM12);
    ICR1 = 39999;
    OCR1A = 2000;
    TCCR1B |= _BV(CS11);
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

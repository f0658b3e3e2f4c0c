// SPDX-License-Identifier: GPL-3.0-or-later
// What PINB reads of a pin that a compare drives: in the pulse, after it, and when the port has it.
#include "servo_pulses.hpp"

int main() {
    startServoPulses();
    for (uint8_t period = 0; period < 2; period++) {
        TIFR1 = _BV(TOV1);
        while (!(TIFR1 & _BV(TOV1))) {
        }
    }
    while (TCNT1 < 1000) {
    }
    report(1, PINB);
    PORTB |= _BV(5);
    while (TCNT1 < 3000) {
    }
    report(2, PINB);
    TCCR1A = 0;
    report(3, PINB);
    for (;;) {
    }
}

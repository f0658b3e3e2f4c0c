// SPDX-License-Identifier: GPL-3.0-or-later
// INT6 on its rising edge, and an input that others write around.
#include "report.hpp"

ISR(INT6_vect) { report(1, PINE); }

int main() {
    EICRB = _BV(ISC61) | _BV(ISC60);
    EIMSK = _BV(INT6);
    PORTA = _BV(1);  // pull-up on the sense pin
    DDRA = _BV(3);
    sei();
    for (;;) {
        PORTA ^= _BV(3);
        PORTE ^= _BV(0);
        GPIOR1 = PINA;
    }
}

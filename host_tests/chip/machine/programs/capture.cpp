// SPDX-License-Identifier: GPL-3.0-or-later
// Edges on ICP5 captured in mode 15 at 0.5 us, and the pin itself.
#include "report.hpp"

ISR(TIMER5_CAPT_vect) {
    const uint16_t captured = ICR5;
    report(PINL & _BV(1) ? 1 : 2, captured);
    if (captured & 1) TCCR5B ^= _BV(ICES5);
}

int main() {
    TCCR5A = 3;
    OCR5A = 39999;
    TCCR5B = _BV(ICES5) | _BV(WGM53) | _BV(WGM52) | _BV(CS51);
    TIMSK5 = _BV(ICIE5);
    sei();
    for (;;) {
    }
}

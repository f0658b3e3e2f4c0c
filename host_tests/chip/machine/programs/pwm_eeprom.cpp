// SPDX-License-Identifier: GPL-3.0-or-later
// Servo pulses on OC1A, while the EEPROM is read without a pause: each read halts the processor for
// four cycles.
#include "report.hpp"

int main() {
    DDRB = _BV(5);
    TCCR1A = _BV(COM1A1) | _BV(WGM11);
    TCCR1B = _BV(WGM13) | _BV(WGM12);
    ICR1 = 39999;
    OCR1A = 2000;
    TCCR1B |= _BV(CS11);
    for (;;) {
        EECR |= _BV(EERE);
        ++EEARL;
    }
}

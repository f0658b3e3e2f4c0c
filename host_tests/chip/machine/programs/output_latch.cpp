// SPDX-License-Identifier: GPL-3.0-or-later
// OC3A is taken from its timer in the middle of a pulse and given back twice: as it is, and after
// its register was forced low.
#include "report.hpp"

static void startPulses() {
    TCNT3 = 0;
    ICR3 = 39999;
    OCR3A = 2000;
    TCCR3B = _BV(WGM33) | _BV(WGM32) | _BV(CS31);
    TCCR3A = _BV(COM3A1) | _BV(WGM31);
    while (!(TIFR3 & _BV(TOV3))) {
    }
    TIFR3 = _BV(TOV3);
    while (TCNT3 < 1000) {
    }
}

static void takePin() { TCCR3A = _BV(WGM31); }
static void givePin() { TCCR3A = _BV(COM3A1) | _BV(WGM31); }

int main() {
    DDRE = _BV(3);
    TCCR3A = _BV(COM3A1);
    report(8, 0);
    TCCR3A = 0;
    startPulses();
    report(1, 0);
    takePin();
    while (TCNT3 < 5000) {
    }
    report(2, 0);
    givePin();
    report(3, 0);
    startPulses();
    takePin();
    TCCR3C = _BV(FOC3A);  // in a PWM mode: nothing
    givePin();
    report(4, 0);
    TCCR3B = 0;
    TCCR3A = 0;
    TCCR3C = _BV(FOC3A);  // without an output mode: nothing
    TCCR3A = _BV(COM3A1);
    report(5, 0);
    TCCR3C = _BV(FOC3A);
    report(6, 0);
    TCCR3A = _BV(COM3A1) | _BV(COM3A0);
    TCCR3C = _BV(FOC3A);
    report(7, 0);
    for (;;) {
    }
}

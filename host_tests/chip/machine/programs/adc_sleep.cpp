// SPDX-License-Identifier: GPL-3.0-or-later
// Goes to sleep with the converter resting: by the interrupt of the conversion that this starts,
// with a converter that is off, and with one whose interrupt is off.
#include <avr/sleep.h>

#include "report.hpp"

volatile uint8_t converted, woken;
ISR(ADC_vect) { converted++; }
ISR(TIMER0_OVF_vect) { woken++; }

static void sleepIn(uint8_t mode) {
    converted = woken = 0;
    SMCR = mode | _BV(SE);
    while (!woken) sleep_cpu();
    SMCR = 0;
}

int main() {
    ADMUX = _BV(REFS0) | 3;
    TCCR0B = _BV(CS02) | _BV(CS00);  // an overflow each 16.4 ms
    TIMSK0 = _BV(TOIE0);
    sei();
    ADCSRA = _BV(ADEN) | _BV(ADIE) | 7;
    sleepIn(SLEEP_MODE_IDLE);
    report(1, converted);
    report(2, ADC);
    ADCSRA = _BV(ADIE) | 7;
    sleepIn(SLEEP_MODE_IDLE);
    report(3, converted);
    ADCSRA = _BV(ADEN) | 7;
    sleepIn(SLEEP_MODE_IDLE);
    report(4, converted);
    report(5, ADCSRA);
    for (;;) {
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Every input of the ADC by polling, the band gap, and a change of channel after the conversion.
#include "report.hpp"

static void select(uint8_t channel) {
    ADMUX = _BV(REFS0) | (channel & 7);
    ADCSRB = channel & 8 ? _BV(MUX5) : 0;
}

static void convert() {
    ADCSRA |= _BV(ADSC);
    while (ADCSRA & _BV(ADSC)) {
    }
}

volatile uint16_t by_interrupt;
ISR(ADC_vect) { by_interrupt = ADC; }

int main() {
    ADCSRA = _BV(ADEN) | 7;
    report(1, 0);
    for (uint8_t channel = 0; channel < 16; channel++) {
        select(channel);
        convert();
        report(10 + channel, ADC);
    }
    select(0);
    convert();
    select(3);
    report(2, ADC);
    ADMUX = _BV(REFS0) | 0x1E;
    ADCSRB = 0;
    convert();
    report(5, ADC);
    convert();
    report(3, ADC);
    select(12);
    ADCSRA |= _BV(ADIF);
    ADCSRA |= _BV(ADIE) | _BV(ADSC);
    sei();
    while (!by_interrupt) {
    }
    report(4, by_interrupt);
    for (;;) {
    }
}

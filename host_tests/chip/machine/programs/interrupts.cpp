// SPDX-License-Identifier: GPL-3.0-or-later
// Costs and flags of interrupts.
#include "report.hpp"

ISR(INT0_vect, ISR_NAKED) {
    asm volatile("out 0x1e, r16\n reti");  // report r16
}
volatile uint8_t compared, level_count;
ISR(TIMER1_COMPA_vect) { compared = 1; }
ISR(TIMER3_OVF_vect) {}
ISR(TIMER2_OVF_vect, ISR_NAKED) { asm volatile("out 0x1e, r16\n reti"); }

static void entryCost() {
    EICRA = 3;
    EIMSK = 1;
    DDRD = 1;
    asm volatile(
        "ldi r16, 1\n ldi r17, 2\n sei\n nop\n nop\n"
        "out 0x1e, r17\n sbi 0x0b, 0\n nop\n out 0x1e, r17\n" ::
            : "r16", "r17");
    cli();
}

static void writeOneClearsOnlyThat() {
    OCR1A = 20;
    OCR1B = 30;
    TCCR1B = 1;
    while (TCNT1 < 60) {
    }
    const uint8_t before = TIFR1;
    TIFR1 = _BV(OCF1B);
    report(10, static_cast<uint16_t>(before << 8 | TIFR1));
    TIFR1 = 0xFF;
    TCCR1B = 0;
}

static void sbiClearsOnlyThat() {
    TCNT1 = 0;
    TCCR1B = 1;
    while (TCNT1 < 60) {
    }
    TIFR1 |= _BV(OCF1A);
    report(11, TIFR1);
    TIFR1 = 0xFF;
    TCCR1B = 0;
}

static void raisedWhileMasked() {
    TCNT1 = 0;
    TCCR1B = 1;
    while (!(TIFR1 & _BV(OCF1A))) {
    }
    compared = 0;
    sei();
    TIMSK1 = _BV(OCIE1A);
    asm volatile("nop\n nop\n nop");
    report(12, compared);
    cli();
    TIMSK1 = 0;
}

static void externalFlagIsCleared() {
    EIMSK = 0;
    PORTD &= ~1;
    PORTD |= 1;
    EIFR = 1;
    report(13, EIFR);
}

// No interrupt would wake it.
static void sleepWithoutPermission() {
    SMCR = 0;
    asm volatile("sei\n sleep\n cli");
    report(22, SMCR);
}

static void wakeUpCost() {
    TCCR2B = 1;
    TCNT2 = 0;
    TIFR2 = 1;
    TIMSK2 = 1;
    set_sleep_mode(SLEEP_MODE_IDLE);
    asm volatile("ldi r16, 20\n sei\n" ::: "r16");
    sleep_mode();
    TIMSK2 = 0;
    report(21, 0);
}

int main() {
    entryCost();
    writeOneClearsOnlyThat();
    sbiClearsOnlyThat();
    raisedWhileMasked();
    externalFlagIsCleared();
    sleepWithoutPermission();
    wakeUpCost();
    sleepForEver();
}

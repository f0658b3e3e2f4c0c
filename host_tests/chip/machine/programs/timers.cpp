// SPDX-License-Identifier: GPL-3.0-or-later
// Counts read and written on the 16-bit timers 1 and 5 and the 8-bit timer 2.
#include "report.hpp"

int main() {
    TCCR1B = _BV(CS11);  // one tick in 8 cycles
    TCNT1 = 0xC000;
    report(1, TCNT1);
    for (uint8_t i = 0; i < 100; i++) asm volatile("nop\n nop\n nop\n nop\n nop");
    report(2, TCNT1);

    TCCR5A = 3;  // mode 15, TOP = OCR5A: as the PPM-sum is captured
    OCR5A = 39999;
    TCCR5B = _BV(WGM53) | _BV(WGM52) | _BV(CS51);
    TCNT5 = 39990;
    const uint16_t high = TCNT5;
    for (uint8_t i = 0; i < 20; i++) asm volatile("nop\n nop\n nop\n nop\n nop");
    report(3, high);
    report(4, TCNT5);
    report(5, TIFR5);

    TCCR1B = 0;  // a stopped timer keeps its count, and goes on from one that was written
    const uint16_t stopped = TCNT1;
    asm volatile("nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop");
    report(6, TCNT1 - stopped);
    TCNT1 = 1000;
    TCCR1B = _BV(CS10);
    report(7, TCNT1);

    TCCR2B = _BV(CS22) | _BV(CS21);  // 256: 62 ticks are 15872 cycles
    TIFR2 = 1;
    TCNT2 = 256 - 62;
    report(8, 0);
    while (!(TIFR2 & 1)) {
    }
    report(9, TCNT2);
    for (;;) {
    }
}

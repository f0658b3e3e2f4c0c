// SPDX-License-Identifier: GPL-3.0-or-later
// On an APM 1: has the BMP085 convert a pressure, and shows its pin EOC (PC7) on the relay's (PL2).
#include <avr/io.h>
#include <util/delay.h>

static void action(uint8_t bits) {
    TWCR = static_cast<uint8_t>(_BV(TWINT) | _BV(TWEN) | bits);
    if (bits & _BV(TWSTO)) return;
    while (!(TWCR & _BV(TWINT))) {
    }
}
static void put(uint8_t byte) {
    TWDR = byte;
    action(0);
}

int main() {
    DDRL |= _BV(2);
    PORTL |= _BV(2);
    TWBR = 72;  // 100 kHz
    _delay_ms(20);
    action(_BV(TWSTA));
    put(0x77 << 1);
    put(0xF4);
    put(0x34 + (3 << 6));  // at the highest oversampling
    action(_BV(TWSTO));
    for (;;) {
        if (PINC & _BV(7))
            PORTL |= _BV(2);
        else
            PORTL &= static_cast<uint8_t>(~_BV(2));
    }
}

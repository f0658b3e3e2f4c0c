// SPDX-License-Identifier: GPL-3.0-or-later
// SPI masters: USART2 without its clock pin as output, USART3 with it.
#include <util/delay.h>

#include "report.hpp"

int main() {
    UCSR2C = _BV(UMSEL21) | _BV(UMSEL20);
    UCSR2B = _BV(RXEN2) | _BV(TXEN2);
    UDR2 = 0x11;
    _delay_us(100);
    report(1, UCSR2A);

    DDRJ = 4;
    UCSR3C = _BV(UMSEL31) | _BV(UMSEL30);
    UCSR3B = _BV(RXEN3) | _BV(TXEN3);
    UDR3 = 0x11;
    UDR3 = 0x22;  // nobody reads: two wait in the buffer, one in the register, the rest is gone
    _delay_us(10);
    report(2, UCSR3A);
    UDR3 = 0x33;
    UDR3 = 0x44;
    _delay_us(10);
    for (uint8_t i = 0; i < 4; i++) {
        const uint8_t status = UCSR3A;
        const uint8_t byte = UDR3;
        report(3, static_cast<uint16_t>(status << 8 | byte));
    }
    for (;;) {
    }
}

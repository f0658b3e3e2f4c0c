// SPDX-License-Identifier: GPL-3.0-or-later
// USART2 sends 64 bytes by interrupt at 57600 (double speed) and then 3 at 115200; received bytes
// are reported, except while deaf (after 'd', for 20 ms). 'D' turns interrupts off for good while
// it polls.
#include <util/delay.h>

#include "report.hpp"

volatile uint8_t sent, deaf;

ISR(USART2_UDRE_vect) {
    UDR2 = sent++;
    if (sent == 64) UCSR2B &= ~_BV(UDRIE2);
}
ISR(USART2_TX_vect) { report(3, sent); }
ISR(USART2_RX_vect) {
    const uint8_t status = UCSR2A;
    const uint8_t byte = UDR2;
    report(1, static_cast<uint16_t>(byte | (status & _BV(DOR2) ? 0x100 : 0)));
    if (byte == 'd') deaf = 1;
}

int main() {
    report(4, UCSR2A);
    UBRR2 = 34;
    UCSR2A = _BV(U2X2);
    UCSR2B = _BV(RXCIE2) | _BV(TXCIE2) | _BV(UDRIE2) | _BV(RXEN2) | _BV(TXEN2);
    sei();
    for (;;) {
        if (!deaf) continue;
        cli();
        _delay_ms(20);
        deaf = 0;
        report(2, 0);
        sei();
    }
}

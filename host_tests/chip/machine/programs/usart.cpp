// SPDX-License-Identifier: GPL-3.0-or-later
// USART2 sends 64 bytes by interrupt at 57600 (double speed) and then 3 at 115200; received bytes
// are reported, except while deaf (after 'd', for 20 ms). Counts how often it wakes up.
#include <avr/sleep.h>
#include <util/delay.h>

#include "report.hpp"

volatile uint8_t sent, deaf, woken;

ISR(USART2_UDRE_vect) {
    UDR2 = sent++;
    if (sent == 64) UCSR2B &= ~_BV(UDRIE2);
}
ISR(USART2_TX_vect) {
    report(3, sent);
    report(5, woken);
}
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
    sleep_enable();
    for (;;) {
        cli();
        if (!deaf) {
            sei();
            sleep_cpu();
            asm volatile("nop");
            cli();  // at once: the interrupt is over, and nothing else asks for one
            ++woken;
            continue;
        }
        _delay_ms(20);
        deaf = 0;
        report(2, 0);
    }
}

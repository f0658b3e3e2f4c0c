// SPDX-License-Identifier: GPL-3.0-or-later
// One byte at each clock rate of the SPI, a collision, a byte by interrupt; then USART3 as master.
#include "report.hpp"

volatile uint8_t by_interrupt;
ISR(SPI_STC_vect) { by_interrupt = SPDR; }

static inline uint8_t transfer(uint8_t byte) {
    SPDR = byte;
    while (!(SPSR & _BV(SPIF))) {
    }
    return SPDR;
}

static uint8_t onUsart3(uint8_t byte) {
    while (!(UCSR3A & _BV(UDRE3))) {
    }
    UDR3 = byte;
    while (!(UCSR3A & _BV(RXC3))) {
    }
    return UDR3;
}

int main() {
    DDRB = 7;
    for (uint8_t rate = 0; rate < 8; rate++) {
        SPCR = static_cast<uint8_t>(_BV(SPE) | _BV(MSTR) | (rate & 3));
        SPSR = rate >> 2;
        report(10 + rate, 0);
        const uint8_t got = transfer(0x40 + rate);
        report(20 + rate, got);
    }
    SPCR = _BV(SPE) | _BV(MSTR);
    SPSR = 0;
    SPDR = 1;
    SPDR = 2;
    while (!(SPSR & _BV(SPIF))) {
    }
    const uint8_t collided = SPSR;
    const uint8_t got = SPDR;
    report(30, static_cast<uint16_t>(collided << 8 | got));
    report(31, SPSR);

    SPCR |= _BV(SPIE);
    sei();
    SPDR = 5;
    for (uint8_t i = 0; i < 30; i++) asm volatile("nop");
    report(32, by_interrupt);
    cli();

    DDRJ = 4;
    UCSR3C = 0xC0;
    UCSR3B = _BV(RXEN3) | _BV(TXEN3);
    UBRR3 = 2;
    const uint8_t first = onUsart3(0x10);
    UCSR3A = _BV(TXC3);
    UDR3 = 0x20;  // both at once: the transmitter has a buffer
    UDR3 = 0x30;
    report(40, first);
    while (!(UCSR3A & _BV(TXC3))) {
    }
    const uint8_t second = UDR3, third = UDR3;
    report(41, static_cast<uint16_t>(second << 8 | third));
    for (;;) {
    }
}

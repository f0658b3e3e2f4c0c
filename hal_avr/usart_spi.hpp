// SPDX-License-Identifier: GPL-3.0-or-later
// USARTs as SPI masters (ATmega2560 data sheet 23). USART3 in mode 0 at 8 MHz: its transmitter and
// receiver are buffered, so the next byte is handed over while one is on the wire; never more than
// two are under way, which is what the receiver holds: an interrupt in between costs time, not
// bytes.
#pragma once
#include <avr/io.h>

#include "pin.hpp"

namespace avr {

struct Usart3Spi {
    // Data sheet 23.3.1: no rate until the transmitter is on, the clock pin an output before that.
    static void start() {
        UBRR3 = 0;
        Pin<PortJ, 2>::output();  // XCK3
        UCSR3C = (1 << UMSEL31) | (1 << UMSEL30);
        UCSR3B = (1 << RXEN3) | (1 << TXEN3);
        UBRR3 = 0;  // 8 MHz
    }

    static void send(const uint8_t* bytes, uint8_t size) {
        UDR3 = *bytes++;
        while (--size) {
            UDR3 = *bytes++;
            arrived();
        }
        arrived();
    }

    static void receive(uint8_t* to, uint8_t size) {
        UDR3 = 0;
        while (--size) {
            UDR3 = 0;
            *to++ = arrived();
        }
        *to = arrived();
    }

private:
    __attribute__((always_inline)) static uint8_t arrived() {
        while (!(UCSR3A & (1 << RXC3))) {
        }
        return UDR3;
    }
};

// USART2 as SPI master in mode 0 at 2.67 MHz for a converter that is asked in pairs of bytes: as
// many as transmitter and receiver hold, so one interrupt serves two, however late it comes.
struct Usart2Pairs {
    static constexpr uint8_t kResting = (1 << RXEN2) | (1 << TXEN2);
    static constexpr uint8_t kWaking = kResting | (1 << TXCIE2);

    static void start() {
        UBRR2 = 0;
        Pin<PortH, 2>::output();  // XCK2
        UCSR2C = (1 << UMSEL21) | (1 << UMSEL20);
        rest();
        UBRR2 = 2;  // the converter's clock is 3.2 MHz at most, ADS7844 data sheet
    }
    static void wake() {
        UCSR2A = 1 << TXC2;  // which forgets the end of the last pair
        UCSR2B = kWaking;
    }
    static void rest() { UCSR2B = kResting; }
    static void begin(uint8_t first, uint8_t second) {
        UDR2 = first;
        UDR2 = second;
    }
    static bool ended() { return UCSR2A & (1 << TXC2); }
    static uint8_t received() { return UDR2; }
    static void flush() {
        while (UCSR2A & (1 << RXC2)) UDR2;
    }
};

}  // namespace avr

// SPDX-License-Identifier: GPL-3.0-or-later
// USART3 as SPI master in mode 0 at 8 MHz (ATmega2560 data sheet 23). Its transmitter and receiver
// are buffered, so the next byte is handed over while one is on the wire; never more than two are
// under way, which is what the receiver holds: an interrupt in between costs time, not bytes.
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

}  // namespace avr

// SPDX-License-Identifier: GPL-3.0-or-later
// SPI0 as master, in mode 0 for the sensors. A byte at 8 MHz takes 16 cycles, less than an
// interrupt would: polled.
#pragma once
#include <avr/io.h>

#include "pin.hpp"

namespace avr {

struct Spi0 {
    static void start() {
        // PB0 is the slave select of the peripheral too: an output, or the master mode would drop
        // out when it is low (data sheet 21.3.2). The board's start has made it one.
        Pin<PortB, 1>::output();
        Pin<PortB, 2>::output();
        slow();
    }

    static void slow() {  // 500 kHz
        SPCR = (1 << SPE) | (1 << MSTR) | (1 << SPR1);
        SPSR = 1 << SPI2X;
    }
    static void fast() {  // 8 MHz
        SPCR = (1 << SPE) | (1 << MSTR);
        SPSR = 1 << SPI2X;
    }

    static uint8_t transfer(uint8_t out) {
        SPDR = out;
        while (!(SPSR & (1 << SPIF))) {
        }
        return SPDR;
    }

    // The same in two halves, for work to be done while the byte is on its way.
    static void begin(uint8_t out) { SPDR = out; }
    __attribute__((always_inline)) static uint8_t end() {
        while (!(SPSR & (1 << SPIF))) {
        }
        return SPDR;
    }

    // Keeps the inertial sensor's interrupt, and no other, away from the bus. Its edge is
    // remembered by the hardware and served at the end.
    class Lock {
    public:
        Lock() : was_on_(EIMSK & (1 << INT6)) {
            EIMSK &= static_cast<uint8_t>(~(1 << INT6));
            __asm__ volatile("" ::: "memory");
        }
        ~Lock() {
            __asm__ volatile("" ::: "memory");
            if (was_on_) EIMSK |= 1 << INT6;
        }
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;

    private:
        const uint8_t was_on_;
    };
};

// The same peripheral with the DataFlash alone on it: mode 3 at 8 MHz, bytes one way.
struct FlashSpi0 {
    static void start() {
        Pin<PortB, 1>::output();
        Pin<PortB, 2>::output();
        SPCR = (1 << SPE) | (1 << MSTR) | (1 << CPOL) | (1 << CPHA);
        SPSR = 1 << SPI2X;
    }
    // The next byte is fetched, the last one stored, while one is on its way.
    static void send(const uint8_t* bytes, uint8_t size) {
        Spi0::begin(*bytes++);
        while (--size) {
            const uint8_t next = *bytes++;
            Spi0::end();
            Spi0::begin(next);
        }
        Spi0::end();
    }
    static void receive(uint8_t* to, uint8_t size) {
        Spi0::begin(0);
        while (--size) {
            const uint8_t byte = Spi0::end();
            Spi0::begin(0);
            *to++ = byte;
        }
        *to = Spi0::end();
    }
};

}  // namespace avr

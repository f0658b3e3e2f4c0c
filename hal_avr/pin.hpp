// SPDX-License-Identifier: GPL-3.0-or-later
// A pin as a type: each call is the port instruction itself. Ports above G lie beyond the reach of
// sbi and cbi, so there the change is read, modified and written with interrupts off.
#pragma once
#include <avr/io.h>

#include "hal/interrupts.hpp"

namespace avr {

template <uint16_t pin_address>
struct Port {
    // PINx, DDRx, PORTx follow each other (ATmega2560 data sheet, register summary)
    static volatile uint8_t& in() { return *reinterpret_cast<volatile uint8_t*>(pin_address); }
    static volatile uint8_t& direction() {
        return *reinterpret_cast<volatile uint8_t*>(pin_address + 1);
    }
    static volatile uint8_t& out() { return *reinterpret_cast<volatile uint8_t*>(pin_address + 2); }
    static constexpr bool kBitAccess = pin_address + 2 < 0x40;
};

using PortA = Port<0x20>;
using PortB = Port<0x23>;
using PortC = Port<0x26>;
using PortD = Port<0x29>;
using PortE = Port<0x2C>;
using PortF = Port<0x2F>;
using PortG = Port<0x32>;
using PortH = Port<0x100>;
using PortJ = Port<0x103>;
using PortK = Port<0x106>;
using PortL = Port<0x109>;

template <bool bit_access>
struct BitWriter {
    static void set(volatile uint8_t& at, uint8_t mask) { at |= mask; }
    static void clear(volatile uint8_t& at, uint8_t mask) { at &= static_cast<uint8_t>(~mask); }
};
template <>
struct BitWriter<false> {
    static void set(volatile uint8_t& at, uint8_t mask) {
        hal::Locked locked;
        at |= mask;
    }
    static void clear(volatile uint8_t& at, uint8_t mask) {
        hal::Locked locked;
        at &= static_cast<uint8_t>(~mask);
    }
};

template <class PortType, uint8_t bit>
struct Pin {
    static_assert(bit < 8, "a port has eight pins");
    using Writer = BitWriter<PortType::kBitAccess>;
    static constexpr uint8_t kMask = 1 << bit;

    static void output() { Writer::set(PortType::direction(), kMask); }
    static void input() { Writer::clear(PortType::direction(), kMask); }
    static void high() { Writer::set(PortType::out(), kMask); }  // of an input: its pull-up
    static void low() { Writer::clear(PortType::out(), kMask); }
    static bool isHigh() { return (PortType::in() & kMask) != 0; }
};

// A light between the supply and its pin.
template <class LedPin>
struct ActiveLowLed {
    static void output() {
        LedPin::high();
        LedPin::output();
    }
    static void on() { LedPin::low(); }
    static void off() { LedPin::high(); }
};

// A light between its pin and ground.
template <class LedPin>
struct ActiveHighLed {
    static void output() {
        LedPin::low();
        LedPin::output();
    }
    static void on() { LedPin::high(); }
    static void off() { LedPin::low(); }
};

}  // namespace avr

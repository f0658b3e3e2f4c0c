// SPDX-License-Identifier: GPL-3.0-or-later
// USART0..2, alike but for their numbers. The rings have one size, so that the three ports are
// one piece of code; 127 bytes are 11 ms of line at 115,200 baud, more than a frame.
#include "hal/serial.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "core/ring.hpp"
#include "hal/interrupts.hpp"
#include "pin.hpp"
#include "start.hpp"

namespace {

struct Usart {
    volatile uint8_t status, control, format, reserved;
    volatile uint16_t divider;
    volatile uint8_t data, reserved2;
};

struct Channel {
    core::Ring<128> rx, tx;
    uint16_t lost = 0;  // given, or the array would be constructed at start
};

Channel channels[hal::kPorts];

constexpr uint8_t kReceiving = (1 << RXCIE0) | (1 << RXEN0) | (1 << TXEN0);
constexpr uint8_t kSendingToo = kReceiving | (1 << UDRIE0);

inline Usart& usart(uint8_t port) { return reinterpret_cast<Usart*>(0xC0)[port]; }
inline Channel& channel(hal::Port port) { return channels[static_cast<uint8_t>(port)]; }

template <uint8_t port>
inline void received() {
    const bool overrun = usart(port).status & (1 << DOR0);  // to be read before the data
    const uint8_t byte = usart(port).data;
    if (overrun) ++channels[port].lost;
    if (!channels[port].rx.put(byte)) ++channels[port].lost;
}

// Up to 11,520 times a second and port: by hand 49 cycles with entry and exit, compiled 70. Does
//     if (tx.take(byte)) usart.data = byte; else usart.control = kReceiving;
template <uint8_t port>
inline __attribute__((always_inline)) void send() {
    using Ring = decltype(Channel::tx);
    static_assert(sizeof(Ring) == 130 && Ring::kTailAt == 129, "bytes, head, tail");
    const uint8_t* const ring = reinterpret_cast<const uint8_t*>(&channels[port].tx);
    __asm__ volatile(
        "push r24                        \n"
        "in   r24, __SREG__              \n"
        "push r24                        \n"
        "push r30                        \n"
        "push r31                        \n"
        "lds  r30, %[tail]               \n"
        "lds  r24, %[head]               \n"
        "cp   r24, r30                   \n"
        "breq 1f                         \n"
        "mov  r24, r30                   \n"
        "inc  r24                        \n"
        "andi r24, 0x7F                  \n"
        "sts  %[tail], r24               \n"
        "ldi  r31, 0                     \n"
        "subi r30, lo8(-(%[bytes]))      \n"
        "sbci r31, hi8(-(%[bytes]))      \n"
        "ld   r24, Z                     \n"
        "sts  %[data], r24               \n"
        "0:                              \n"
        "pop  r31                        \n"
        "pop  r30                        \n"
        "pop  r24                        \n"
        "out  __SREG__, r24              \n"
        "pop  r24                        \n"
        "reti                            \n"
        "1:                              \n"
        "ldi  r24, %[receiving]          \n"
        "sts  %[control], r24            \n"
        "rjmp 0b                         \n"
        :
        : [bytes] "i"(ring), [head] "i"(ring + Ring::kHeadAt), [tail] "i"(ring + Ring::kTailAt),
          [data] "i"(&usart(port).data), [control] "i"(&usart(port).control),
          [receiving] "M"(static_cast<int>(kReceiving)));
}

// The line's bit in units of 8 cycles, the double-speed mode's step. Where it is even the normal
// mode gives the same rate and samples every bit twice as often.
struct Divider {
    uint16_t divider;
    uint8_t status;
};

Divider dividerFor(uint32_t baud) {
    constexpr uint32_t kStep_hz = F_CPU / 8;
    uint32_t steps = baud == 0 ? 4096 : (kStep_hz + baud / 2) / baud;
    if (steps < 1) steps = 1;
    if (steps > 4096) steps = 4096;
    const uint16_t whole = static_cast<uint16_t>(steps);
    if (whole % 2 == 0) return {static_cast<uint16_t>(whole / 2 - 1), 0};
    return {static_cast<uint16_t>(whole - 1), 1 << U2X0};
}

}  // namespace

ISR(USART0_RX_vect) { received<0>(); }
ISR(USART1_RX_vect) { received<1>(); }
ISR(USART2_RX_vect) { received<2>(); }
ISR(USART0_UDRE_vect, ISR_NAKED) { send<0>(); }
ISR(USART1_UDRE_vect, ISR_NAKED) { send<1>(); }
ISR(USART2_UDRE_vect, ISR_NAKED) { send<2>(); }

namespace avr {

// An open receive pin picks up what its neighbour sends.
void serialStart() {
    Pin<PortE, 0>::high();
    Pin<PortD, 2>::high();
    Pin<PortH, 0>::high();
    Pin<PortA, 1>::high();  // the USB sense, should its processor not drive it: no USB
}

}  // namespace avr

namespace hal {

void serialOpen(Port port, uint32_t baud) {
    const Divider divider = dividerFor(baud);
    Usart& line = usart(static_cast<uint8_t>(port));
    Locked locked;
    line.control = 0;  // also empties the receiver
    channel(port).rx.clear();
    channel(port).tx.clear();
    line.status = divider.status;
    line.divider = divider.divider;
    line.format = (1 << UCSZ01) | (1 << UCSZ00);
    line.control = kReceiving;
}

uint8_t serialAvailable(Port port) { return channel(port).rx.used(); }
bool serialRead(Port port, uint8_t& byte) { return channel(port).rx.take(byte); }
uint8_t serialRoom(Port port) { return channel(port).tx.room(); }

bool serialWrite(Port port, const void* bytes, uint8_t size) {
    if (!channel(port).tx.put(bytes, size)) return false;
    usart(static_cast<uint8_t>(port)).control = kSendingToo;
    return true;
}

uint16_t serialLost(Port port) {
    Locked locked;
    return channel(port).lost;
}

bool usbConnected() { return !avr::Pin<avr::PortA, 1>::isHigh(); }

}  // namespace hal

// SPDX-License-Identifier: GPL-3.0-or-later
// The USARTs of the ports, alike but for their numbers and the size of their rings. 127 bytes of a
// link are 11 ms of line at 115,200 baud, more than a frame. The GPS is read out in every frame and
// talks at 38,400 baud: 63 bytes are 16.4 ms of it, against 13 ms between two readings at the worst
// (a late sample, and the tasks before the reader at their longest). Its driver leaves what follows
// a whole fix for the next frame: 54 bytes at most, the answer to its question. What it sends looks
// for room first.
#include "hal/serial.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "by_hand.hpp"
#include "core/crc.hpp"
#include "core/ring.hpp"
#include "hal/interrupts.hpp"
#include "pin.hpp"
#include "start.hpp"
#include "wiring.hpp"

namespace {

struct Usart {
    volatile uint8_t status, control, format, reserved;
    volatile uint16_t divider;
    volatile uint8_t data, reserved2;
};

template <uint16_t rx_size, uint16_t tx_size>
struct Channel {
    core::Ring<rx_size> rx;
    core::Ring<tx_size> tx;
    uint16_t lost = 0;  // given, or it would be constructed at start
};

Channel<128, 128> links[2];
Channel<64, 32> gps;
static_assert(hal::kPorts == 3, "each port has its channel");

template <uint8_t port>
struct ChannelOf {
    static constexpr Channel<128, 128>& get() { return links[port / 2]; }
};
template <>
struct ChannelOf<static_cast<uint8_t>(hal::Port::gps)> {
    static constexpr Channel<64, 32>& get() { return gps; }
};

template <class Act>
inline auto at(hal::Port port, Act act) {
    return port == hal::Port::gps ? act(gps) : act(links[static_cast<uint8_t>(port) / 2]);
}

constexpr uint8_t kReceiving = (1 << RXCIE0) | (1 << RXEN0) | (1 << TXEN0);
constexpr uint8_t kSendingToo = kReceiving | (1 << UDRIE0);

constexpr uint16_t usartAddress(uint8_t number) { return number == 3 ? 0x130 : 0xC0 + 8 * number; }

inline Usart& usart(uint8_t port) {
    const bool link1 = port == static_cast<uint8_t>(hal::Port::link1);
    return *reinterpret_cast<Usart*>(usartAddress(link1 ? wiring::kLink1Usart : port));
}

// Both by hand, as they come up to 11,520 times a second and port.
// clang-format off
#define COUNT_LOST(back)           \
    "lds  r31, %[lost]         \n" \
    "subi r31, 0xFF            \n" \
    "sts  %[lost], r31         \n" \
    "brne " back "             \n" \
    "lds  r31, %[lost]+1       \n" \
    "inc  r31                  \n" \
    "sts  %[lost]+1, r31       \n" \
    "rjmp " back "             \n"
// clang-format on

// 56 cycles with entry and exit, compiled 91. Does
//     const bool overrun = usart.status & (1 << DOR0);  // to be read before the data
//     const uint8_t byte = usart.data;
//     if (overrun) ++lost;
//     if (!rx.put(byte)) ++lost;
//     avr::wake();  // but for the GPS
template <uint8_t port>
inline __attribute__((always_inline)) void received() {
    auto& channel = ChannelOf<port>::get();
    constexpr bool kGps = port == static_cast<uint8_t>(hal::Port::gps);
    using Ring = core::Ring<kGps ? 64 : 128>;
    static_assert(sizeof(Ring) == sizeof(channel.rx) && sizeof(Ring) == Ring::kTailAt + 1,
                  "bytes, indices");
    const uint8_t* const ring = reinterpret_cast<const uint8_t*>(&channel.rx);
    __asm__ volatile(
        BY_HAND_ENTRY
        "out  %[kept_r24], r24           \n"
        "push r25                        \n"
        "lds  r31, %[status]             \n"
        "lds  r24, %[data]               \n"
        "sbrc r31, %[overrun]            \n"
        "rjmp 2f                         \n"
        "0:                              \n"
        "lds  r30, %[head]               \n"
        "mov  r25, r30                   \n"
        "inc  r25                        \n"
        "andi r25, %[mask]               \n"
        "lds  r31, %[tail]               \n"
        "cp   r25, r31                   \n"
        "breq 3f                         \n"
        "ldi  r31, 0                     \n"
        "subi r30, lo8(-(%[bytes]))      \n"
        "sbci r31, hi8(-(%[bytes]))      \n"
        "st   Z, r24                     \n"
        "sts  %[head], r25               \n"
        "1:                              \n"
        ".if  %[wakes]                   \n"
        "ldi  r24, 0                     \n"
        "out  %[sleep], r24              \n"
        ".endif                          \n"
        "pop  r25                        \n"
        "in   r24, %[kept_r24]           \n" BY_HAND_EXIT "2:                              \n"
        // clang-format off
        COUNT_LOST("0b")
        "3:                              \n"
        COUNT_LOST("1b")
        // clang-format on
        :
        : [bytes] "i"(ring), [head] "i"(ring + Ring::kHeadAt), [tail] "i"(ring + Ring::kTailAt),
          [lost] "i"(&channel.lost), [sleep] "I"(_SFR_IO_ADDR(SMCR)), [wakes] "i"(!kGps),
          [data] "i"(&usart(port).data), [status] "i"(&usart(port).status),
          [mask] "M"(static_cast<int>(Ring::kHeadAt - 1)), [overrun] "M"(DOR0), BY_HAND_KEPT);
}

// 39 cycles with entry and exit, compiled 70. Does
//     if (tx.take(byte)) usart.data = byte; else usart.control = kReceiving;
template <uint8_t port>
inline __attribute__((always_inline)) void send() {
    auto& tx = ChannelOf<port>::get().tx;
    using Ring = core::Ring<port == static_cast<uint8_t>(hal::Port::gps) ? 32 : 128>;
    static_assert(sizeof(Ring) == sizeof(tx) && sizeof(Ring) == Ring::kTailAt + 1,
                  "bytes, indices");
    const uint8_t* const ring = reinterpret_cast<const uint8_t*>(&tx);
    __asm__ volatile(
        BY_HAND_ENTRY
        "lds  r30, %[tail]               \n"
        "lds  r31, %[head]               \n"
        "cp   r31, r30                   \n"
        "breq 1f                         \n"
        "mov  r31, r30                   \n"
        "inc  r31                        \n"
        "andi r31, %[mask]               \n"
        "sts  %[tail], r31               \n"
        "ldi  r31, 0                     \n"
        "subi r30, lo8(-(%[bytes]))      \n"
        "sbci r31, hi8(-(%[bytes]))      \n"
        "ld   r30, Z                     \n"
        "sts  %[data], r30               \n"
        "0:                              \n" BY_HAND_EXIT
        "1:                              \n"
        "ldi  r30, %[receiving]          \n"
        "sts  %[control], r30            \n"
        "rjmp 0b                         \n"
        :
        : [bytes] "i"(ring), [head] "i"(ring + Ring::kHeadAt), [tail] "i"(ring + Ring::kTailAt),
          [data] "i"(&usart(port).data), [control] "i"(&usart(port).control),
          [mask] "M"(static_cast<int>(Ring::kHeadAt - 1)),
          [receiving] "M"(static_cast<int>(kReceiving)), BY_HAND_KEPT);
}

// Three products make the shifts of core::crc16 for a byte in the time of one. Three bytes at once,
// as the registers then come back to where they were: 16 cycles a byte, 20 one by one.
// clang-format off
#define SUM_BYTE(low, high, byte)           \
    "ld   " byte ", %a[from]+        \n"    \
    "st   %a[to]+, " byte "          \n"    \
    "eor  " byte ", " low "          \n"    \
    "mul  " byte ", %[up_4]          \n"    \
    "eor  " byte ", r0               \n"    \
    "mul  " byte ", %[up_4]          \n"    \
    "eor  " high ", r1               \n"    \
    "mul  " byte ", %[up_3]          \n"    \
    "eor  " high ", r0               \n"    \
    "eor  " byte ", r1               \n"
// clang-format on

inline __attribute__((always_inline)) void copySummed(uint8_t* to, const uint8_t*& from,
                                                      uint8_t size, uint16_t& crc) {
    uint8_t byte;
    __asm__ volatile(
        "subi %[size], 3                 \n"
        "brcs 2f                         \n"
        "1:                              \n"
        // clang-format off
        SUM_BYTE("%A[crc]", "%B[crc]", "%[byte]")
        SUM_BYTE("%B[crc]", "%[byte]", "%A[crc]")
        SUM_BYTE("%[byte]", "%A[crc]", "%B[crc]")
        // clang-format on
        "subi %[size], 3                 \n"
        "brcc 1b                         \n"
        "2:                              \n"
        "subi %[size], -3                \n"
        "breq 4f                         \n"
        "3:                              \n"
        // clang-format off
        SUM_BYTE("%A[crc]", "%B[crc]", "%[byte]")
        // clang-format on
        "mov  %A[crc], %B[crc]           \n"
        "mov  %B[crc], %[byte]           \n"
        "dec  %[size]                    \n"
        "brne 3b                         \n"
        "4:                              \n"
        "clr  r1                         \n"
        :
        [byte] "=&r"(byte), [from] "+&e"(from), [to] "+&e"(to), [crc] "+&r"(crc), [size] "+&d"(size)
        : [up_4] "r"(static_cast<uint8_t>(1 << 4)), [up_3] "r"(static_cast<uint8_t>(1 << 3))
        : "r0", "memory");
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

ISR(USART0_RX_vect, ISR_NAKED) { received<0>(); }
ISR(USART1_RX_vect, ISR_NAKED) { received<1>(); }
ISR(LINK1_RECEIVED_vect, ISR_NAKED) { received<2>(); }
ISR(USART0_UDRE_vect, ISR_NAKED) { send<0>(); }
ISR(USART1_UDRE_vect, ISR_NAKED) { send<1>(); }
ISR(LINK1_EMPTY_vect, ISR_NAKED) { send<2>(); }

namespace avr {

// An open receive pin picks up what its neighbour sends.
void serialStart() {
    Pin<PortE, 0>::high();
    Pin<PortD, 2>::high();
    wiring::Link1Receive::high();
    wiring::UsbSense::high();  // the USB sense, should its processor not drive it: no USB
}

}  // namespace avr

namespace hal {

void serialOpen(Port port, uint32_t baud) {
    const Divider divider = dividerFor(baud);
    Usart& line = usart(static_cast<uint8_t>(port));
    Locked locked;
    line.control = 0;  // also empties the receiver
    at(port, [](auto& channel) {
        channel.rx.clear();
        channel.tx.clear();
    });
    line.status = divider.status;
    line.divider = divider.divider;
    line.format = (1 << UCSZ01) | (1 << UCSZ00);
    line.control = kReceiving;
}

uint8_t serialAvailable(Port port) {
    return at(port, [](auto& channel) { return channel.rx.used(); });
}
bool serialRead(Port port, uint8_t& byte) {
    return at(port, [&byte](auto& channel) { return channel.rx.take(byte); });
}
uint8_t serialRoom(Port port) {
    return at(port, [](auto& channel) { return channel.tx.room(); });
}

bool serialWrite(Port port, const void* bytes, uint8_t size) {
    if (!at(port, [=](auto& channel) { return channel.tx.put(bytes, size); })) return false;
    usart(static_cast<uint8_t>(port)).control = kSendingToo;
    return true;
}

void linkWriteFrame(Port link, const Piece& head, const Piece& body, uint16_t crc, uint8_t extra) {
    const bool first = link == Port::link0;
    auto* channel = links + (first ? 0 : 1);
    __asm__("" : "+r"(channel));  // or it is worked out again wherever it is used
    core::Ring<128>& tx = channel->tx;
    uint8_t checksum[2];
    const uint8_t* from = head.bytes;
    uint8_t size = head.size;
    for (uint8_t piece = 0;; ++piece) {
        for (uint8_t run = tx.runOf(size);; run = size) {
            copySummed(tx.end(), from, run, crc);
            tx.added(run);
            if (run == size) break;
            size = static_cast<uint8_t>(size - run);
        }
        if (piece == 0) {
            from = body.bytes;
            size = body.size;
        } else if (piece == 1) {
            crc = core::crc16(crc, extra);
            checksum[0] = static_cast<uint8_t>(crc);
            checksum[1] = static_cast<uint8_t>(crc >> 8);
            from = checksum;
            size = sizeof checksum;
        } else {
            break;
        }
    }
    if (first) {
        usart(static_cast<uint8_t>(Port::link0)).control = kSendingToo;
    } else {
        usart(static_cast<uint8_t>(Port::link1)).control = kSendingToo;
    }
}

uint16_t serialLost(Port port) {
    Locked locked;
    return at(port, [](auto& channel) { return channel.lost; });
}

bool usbConnected() { return !wiring::UsbSense::isHigh(); }

}  // namespace hal

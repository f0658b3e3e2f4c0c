// SPDX-License-Identifier: GPL-3.0-or-later
// The USARTs of the ports, alike but for their numbers and the size of their rings. 127 bytes are
// 11 ms of line at 115,200 baud, more than a frame. The GPS is read out in every frame; an NMEA
// receiver at 115,200 baud fills 63 bytes in 5.5 ms, and loses sentences then. Its driver leaves
// what follows a whole fix for the next frame. What is sent to it looks for room first.
#include "hal/serial.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

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

core::Ring<128> links_rx[2];
// The frames behind the ring's head are held: its interrupt sends up to the head only.
struct LinkRing {
    using Ring = core::Ring<128>;
    Ring ring;
    uint8_t written = 0;  // index behind the last byte

    uint8_t held() const { return Ring::index(static_cast<uint8_t>(written - ring.head())); }
    uint8_t room() const {
        return static_cast<uint8_t>(Ring::kHeadAt - 1 -
                                    Ring::index(static_cast<uint8_t>(written - ring.tail())));
    }
    void clear() {
        ring.clear();
        written = ring.head();
    }
    uint8_t* end() { return ring.begin() + written; }
    void added(uint8_t count) { written = Ring::index(static_cast<uint8_t>(written + count)); }
    void add(uint8_t byte) {
        *end() = byte;
        added(1);
    }
    bool put(const void* bytes, uint8_t size) {  // not while frames are held
        const bool done = ring.put(bytes, size);
        written = ring.head();
        return done;
    }
    bool empty() const { return ring.empty(); }
};
// An address in one of these is a constant and the index below it: two instructions fewer for each
// byte sent, 0.3 % of the processor, which the gaps in the RAM are worth.
alignas(256) LinkRing link0_tx;
alignas(256) LinkRing link1_tx;
core::Ring<128> gps_rx;
core::Ring<32> gps_tx;
uint16_t lost_bytes[hal::kPorts];

constexpr uint8_t kGps = static_cast<uint8_t>(hal::Port::gps);
static_assert(hal::kPorts == 3 && kGps == 1, "a link to either side of the GPS");

// Of a port known to the compiler.
template <uint8_t port>
struct RingsOf {
    static core::Ring<128>& rx() { return links_rx[port / 2]; }
    static core::Ring<128>& tx() { return port == 0 ? link0_tx.ring : link1_tx.ring; }
};
template <>
struct RingsOf<kGps> {
    static core::Ring<128>& rx() { return gps_rx; }
    static core::Ring<32>& tx() { return gps_tx; }
};

inline LinkRing& sentOn(hal::Port link) { return link == hal::Port::link0 ? link0_tx : link1_tx; }

template <class Act>
inline auto atReceived(hal::Port port, Act act) {
    return port == hal::Port::gps ? act(gps_rx) : act(links_rx[static_cast<uint8_t>(port) / 2]);
}
template <class Act>
inline auto atSent(hal::Port port, Act act) {
    return port == hal::Port::gps ? act(gps_tx) : act(sentOn(port));
}

constexpr uint8_t kReceiving = (1 << RXCIE0) | (1 << RXEN0) | (1 << TXEN0);
constexpr uint8_t kSendingToo = kReceiving | (1 << UDRIE0);

constexpr uint16_t usartAddress(uint8_t number) { return number == 3 ? 0x130 : 0xC0 + 8 * number; }

inline Usart& usart(uint8_t port) {
    const bool link1 = port == static_cast<uint8_t>(hal::Port::link1);
    return *reinterpret_cast<Usart*>(usartAddress(link1 ? wiring::kLink1Usart : port));
}

template <uint8_t port>
inline void received() {
    const bool overrun = usart(port).status & (1 << DOR0);  // to be read before the data
    const uint8_t byte = usart(port).data;
    if (__builtin_expect(overrun, false)) ++lost_bytes[port];  // out of the way: a cycle a byte
    if (!RingsOf<port>::rx().put(byte)) ++lost_bytes[port];
    if (port != kGps) avr::wake();
}

// In assembler, as bytes go out up to 11,520 times a second and link: compiled it takes 2.2 % more
// of the processor. 42 cycles with entry and exit, compiled 70. Does
//     if (tx.take(byte)) usart.data = byte;
//     if (tx.empty()) usart.control = kReceiving;
// It does not ask whether there is a byte: see startSending.
template <uint8_t port>
inline __attribute__((always_inline)) void send() {
    using Ring = core::Ring<128>;
    const uint8_t* const ring = reinterpret_cast<const uint8_t*>(&RingsOf<port>::tx());
    static_assert(sizeof(Ring) == Ring::kTailAt + 1, "bytes, indices");
    __asm__ volatile(
        "push r30                        \n"
        "in   r30, __SREG__              \n"
        "push r30                        \n"
        "push r31                        \n"
        "lds  r30, %[tail]               \n"
        "ldi  r31, hi8(%[bytes])         \n"
        "ld   r31, Z                     \n"
        "sts  %[data], r31               \n"
        "inc  r30                        \n"
        "andi r30, %[mask]               \n"
        "sts  %[tail], r30               \n"
        "lds  r31, %[head]               \n"
        "cp   r31, r30                   \n"
        "breq 1f                         \n"
        "0:                              \n"
        "pop  r31                        \n"
        "pop  r30                        \n"
        "out  __SREG__, r30              \n"
        "pop  r30                        \n"
        "reti                            \n"
        "1:                              \n"
        "ldi  r30, %[receiving]          \n"
        "sts  %[control], r30            \n"
        "rjmp 0b                         \n"
        :
        : [bytes] "i"(ring), [head] "i"(ring + Ring::kHeadAt), [tail] "i"(ring + Ring::kTailAt),
          [data] "i"(&usart(port).data), [control] "i"(&usart(port).control),
          [mask] "M"(static_cast<int>(Ring::kHeadAt - 1)),
          [receiving] "M"(static_cast<int>(kReceiving)));
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

// While its interrupt is on there is a byte to send: it ends itself with the last one, which may
// have gone out before this is called.
template <class Ring>
inline void startSending(hal::Port port, const Ring& tx) {
    const hal::Locked locked;
    if (!tx.empty()) usart(static_cast<uint8_t>(port)).control = kSendingToo;
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
ISR(LINK1_RECEIVED_vect) { received<2>(); }
ISR(USART0_UDRE_vect, ISR_NAKED) { send<0>(); }
ISR(USART1_UDRE_vect) {  // little is sent to the GPS
    uint8_t byte;
    if (gps_tx.take(byte))
        usart(kGps).data = byte;
    else
        usart(kGps).control = kReceiving;
}
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
    atReceived(port, [](auto& rx) { rx.clear(); });
    atSent(port, [](auto& tx) { tx.clear(); });
    line.status = divider.status;
    line.divider = divider.divider;
    line.format = (1 << UCSZ01) | (1 << UCSZ00);
    line.control = kReceiving;
}

uint8_t serialAvailable(Port port) {
    return atReceived(port, [](auto& rx) { return rx.used(); });
}
bool serialRead(Port port, uint8_t& byte) {
    return atReceived(port, [&byte](auto& rx) { return rx.take(byte); });
}
uint8_t serialRoom(Port port) {
    return atSent(port, [](auto& tx) { return tx.room(); });
}

bool serialWrite(Port port, const void* bytes, uint8_t size) {
    if (!atSent(port, [=](auto& tx) { return tx.put(bytes, size); })) return false;
    atSent(port, [=](auto& tx) { startSending(port, tx); });
    return true;
}

void linkWriteFrame(Port link, const Piece& head, const Piece& body, uint16_t crc, uint8_t extra,
                    uint8_t signature) {
    LinkRing* ring = &sentOn(link);
    __asm__("" : "+r"(ring));  // or it is worked out again wherever it is used
    LinkRing& tx = *ring;
    const uint8_t* from = head.bytes;
    uint8_t size = head.size;
    for (bool is_body = false;; is_body = true) {
        for (uint8_t run = LinkRing::Ring::runFrom(tx.written, size);; run = size) {
            copySummed(tx.end(), from, run, crc);
            tx.added(run);
            if (run == size) break;
            size = static_cast<uint8_t>(size - run);
        }
        if (is_body) break;
        from = body.bytes;
        size = body.size;
    }
    crc = core::crc16(crc, extra);
    tx.add(static_cast<uint8_t>(crc));
    tx.add(static_cast<uint8_t>(crc >> 8));
    if (signature != 0) return tx.added(signature);
    tx.ring.handOver(tx.written);
    startSending(link, tx);
}

uint8_t linkHeldSize(Port link) { return sentOn(link).held(); }

Runs linkHeld(Port link) {
    LinkRing& tx = sentOn(link);
    const uint8_t at = tx.ring.head();
    return {tx.ring.begin() + at, tx.ring.runFrom(at, tx.held()), tx.ring.begin()};
}

void linkSendHeld(Port link, uint8_t size) {
    LinkRing& tx = sentOn(link);
    tx.ring.handOver(tx.ring.index(static_cast<uint8_t>(tx.ring.head() + size)));
    startSending(link, tx);
}

uint16_t serialLost(Port port) {
    Locked locked;
    return lost_bytes[static_cast<uint8_t>(port)];
}

bool usbConnected() { return !wiring::UsbSense::isHigh(); }

}  // namespace hal

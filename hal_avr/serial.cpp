// SPDX-License-Identifier: GPL-3.0-or-later
// The USARTs of the ports, alike but for their numbers and the size of their rings. 254 bytes to
// send are 22 ms of line at 115,200 baud: a download fills the next message into them while the
// last one goes out. 127 received are 11 ms, more than a frame. The GPS is read out in every frame;
// an NMEA receiver at 115,200 baud fills 63 bytes in 5.5 ms, and loses sentences then. Its driver
// leaves what follows a whole fix for the next frame. What is sent to it looks for room first.
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
// What the links send. An index into 256 bytes comes round by itself, and as they are aligned an
// address is a constant and the index below it: three instructions fewer for each byte sent. So
// aligned the bytes of both lie side by side, without their indices, or there would be gaps.
alignas(256) uint8_t links_tx_bytes[2][256];

// The frames behind the head are held: its interrupt sends up to the head only.
class LinkRing : public core::RingIndices<256> {
public:
    uint8_t written = 0;  // index behind the last byte

    uint8_t held() const { return static_cast<uint8_t>(written - head()); }
    // One less than there is: 255 free bytes are what a link waits for that has nothing to send.
    uint8_t room() const { return static_cast<uint8_t>(hal::kLinkRoom - (written - tail())); }
    void clear() {
        RingIndices::clear();
        written = head();
    }
    void added(uint8_t count) { written = static_cast<uint8_t>(written + count); }
    bool put(uint8_t* ring, const void* bytes, uint8_t size) {  // not while frames are held
        const bool done = putInto(ring, bytes, size);
        written = head();
        return done;
    }
};
LinkRing links_tx[2];
core::Ring<128> gps_rx;
core::Ring<32> gps_tx;
uint16_t lost_bytes[hal::kPorts];

constexpr uint8_t kGps = static_cast<uint8_t>(hal::Port::gps);
static_assert(hal::kPorts == 3 && kGps == 1, "a link to either side of the GPS");

// Of a port known to the compiler.
template <uint8_t port>
inline core::Ring<128>& receivedOn() {
    return links_rx[port / 2];
}
template <>
inline core::Ring<128>& receivedOn<kGps>() {
    return gps_rx;
}

inline uint8_t linkOf(hal::Port port) { return port == hal::Port::link0 ? 0 : 1; }

template <class Act>
inline auto atReceived(hal::Port port, Act act) {
    return port == hal::Port::gps ? act(gps_rx) : act(links_rx[static_cast<uint8_t>(port) / 2]);
}
template <class Act>
inline auto atSent(hal::Port port, Act act) {
    return port == hal::Port::gps ? act(gps_tx) : act(links_tx[linkOf(port)]);
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
    if (!receivedOn<port>().put(byte)) ++lost_bytes[port];
    if (port != kGps) avr::wake();
}

// In assembler, as bytes go out up to 11,520 times a second and link: compiled it takes 2.2 % more
// of the processor. 42 cycles with entry and exit, compiled 70. Does
//     if (tx.take(byte)) usart.data = byte;
//     if (tx.empty()) usart.control = kReceiving;
// It does not ask whether there is a byte: see startSending.
template <uint8_t port>
inline __attribute__((always_inline)) void send() {
    constexpr uint8_t kLink = port / 2;
    const uint8_t* const indices = reinterpret_cast<const uint8_t*>(&links_tx[kLink]);
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
        : [bytes] "i"(links_tx_bytes[kLink]), [head] "i"(indices + LinkRing::kHeadAt),
          [tail] "i"(indices + LinkRing::kTailAt), [data] "i"(&usart(port).data),
          [control] "i"(&usart(port).control), [receiving] "M"(static_cast<int>(kReceiving)));
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
    const uint8_t link = linkOf(port);
    const bool done = port == Port::gps ? gps_tx.put(bytes, size)
                                        : links_tx[link].put(links_tx_bytes[link], bytes, size);
    if (done) atSent(port, [=](auto& tx) { startSending(port, tx); });
    return done;
}

void linkWriteFrame(Port link, const Piece& head, const Piece& body, uint16_t crc, uint8_t extra,
                    uint8_t signature) {
    const uint8_t number = linkOf(link);
    LinkRing* ring = &links_tx[number];
    uint8_t* bytes = links_tx_bytes[number];
    __asm__("" : "+r"(ring), "+r"(bytes));  // or they are worked out again wherever they are used
    LinkRing& tx = *ring;
    const uint8_t* from = head.bytes;
    uint8_t size = head.size;
    for (bool is_body = false;; is_body = true) {
        for (uint8_t run = LinkRing::runFrom(tx.written, size);; run = size) {
            copySummed(bytes + tx.written, from, run, crc);
            tx.added(run);
            if (run == size) break;
            size = static_cast<uint8_t>(size - run);
        }
        if (is_body) break;
        from = body.bytes;
        size = body.size;
    }
    crc = core::crc16(crc, extra);
    bytes[tx.written] = static_cast<uint8_t>(crc);
    tx.added(1);
    bytes[tx.written] = static_cast<uint8_t>(crc >> 8);
    tx.added(1);
    if (signature != 0) return tx.added(signature);
    tx.handOver(tx.written);
    startSending(link, tx);
}

uint8_t linkHeldSize(Port link) { return links_tx[linkOf(link)].held(); }

Runs linkHeld(Port link) {
    const uint8_t number = linkOf(link);
    const LinkRing& tx = links_tx[number];
    uint8_t* const bytes = links_tx_bytes[number];
    return {bytes + tx.head(), tx.runFrom(tx.head(), tx.held()), bytes};
}

void linkSendHeld(Port link, uint8_t size) {
    LinkRing& tx = links_tx[linkOf(link)];
    tx.handOver(static_cast<uint8_t>(tx.head() + size));
    startSending(link, tx);
}

uint16_t serialLost(Port port) {
    Locked locked;
    return lost_bytes[static_cast<uint8_t>(port)];
}

bool usbConnected() { return !wiring::UsbSense::isHigh(); }

}  // namespace hal

// SPDX-License-Identifier: GPL-3.0-or-later
// The receiver's channels as one train of pulses on the capture pin of the clock's timer: a
// channel's width is the time from one rising edge to the next, and a gap of more than 4 ms begins
// a new frame. What lies between the longest pulse and that is two channels whose edge was missed:
// it must not begin a frame in the middle of another, in which the throttle would be a switch.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <string.h>

#include "hal/interrupts.hpp"
#include "hal/rc_input.hpp"
#include "start.hpp"
#include "timer.hpp"
#include "wiring.hpp"

namespace {

// in the clock's counts of 0.5 us
constexpr uint16_t kGap = 2 * 4000;
constexpr uint16_t kShortest = 2 * 700;  // encoders send 900..2100 us; else it is noise
constexpr uint16_t kLongest = 2 * 2500;

constexpr uint8_t kFewestChannels = 5;
// Overflows of the timer since an edge. An edge just after an overflow whose interrupt has still
// to run begins one below 0, so that it counts from 0 on.
constexpr uint8_t kOwnOverflow = 0xFF;
constexpr uint8_t kManyOverflows = 0xF0;  // the count stays here, 7.9 s

constexpr uint8_t kNotInFrame = 0xFF;  // until the next gap

struct {
    uint16_t frames[2 * hal::kRcChannels];
    uint16_t edge;           // of the last pulse
    uint8_t edge_overflows;  // of the timer since that edge, see kOwnOverflow
    uint8_t channel;         // the next to come
    uint8_t filling;         // which of the frames: where it begins, so that nothing multiplies
    bool fresh;
    uint16_t received;  // the edge that ended the newest frame
    uint8_t received_overflows;
} ppm;

// Calls nothing: with a call in it an interrupt saves every register.
inline __attribute__((always_inline)) void accept() {
    ppm.filling ^= hal::kRcChannels;
    ppm.fresh = true;
    ppm.received = ppm.edge;
    ppm.received_overflows = ppm.edge_overflows;
}

inline bool overflowPending(uint16_t count) {
    return (avr::interruptFlags(wiring::kClockTimer) & (1 << TOV1)) && count < 0x8000;
}

inline void gap() {
    if (ppm.channel != kNotInFrame && ppm.channel >= kFewestChannels) {
        while (ppm.channel < hal::kRcChannels) ppm.frames[ppm.filling + ppm.channel++] = 0;
        accept();
    }
    ppm.channel = 0;
}

inline uint16_t& next() { return ppm.frames[static_cast<uint8_t>(ppm.filling + ppm.channel)]; }

inline void pulse(uint16_t width) {
    if (ppm.channel == kNotInFrame) return;
    if (width < kShortest || width > kLongest) {
        ppm.channel = kNotInFrame;
        return;
    }
    next() = width;
    if (++ppm.channel == hal::kRcChannels) {
        accept();
        ppm.channel = kNotInFrame;
    }
}

}  // namespace

ISR(CLOCK_CAPTURE_vect) {
    const uint16_t edge = avr::timer<wiring::kClockTimer>().capture;
    const bool overflow_pending = overflowPending(edge);
    const uint16_t width = edge - ppm.edge;
    const uint8_t overflows = static_cast<uint8_t>(ppm.edge_overflows + overflow_pending);
    const bool too_long = overflows > 1 || (overflows == 1 && edge >= ppm.edge);
    ppm.edge = edge;
    ppm.edge_overflows = overflow_pending ? kOwnOverflow : 0;
    if (too_long || width > kGap) {
        gap();
    } else {
        pulse(width);
    }
}

namespace avr {

void ppmTick() {
    if (ppm.edge_overflows != kManyOverflows) ++ppm.edge_overflows;
    if (ppm.received_overflows != kManyOverflows) ++ppm.received_overflows;
}

void ppmStart() {
    // a level counts when seen four cycles running
    timer<wiring::kClockTimer>().control_b |= (1 << ICNC1) | (1 << ICES1);
    ppm.channel = kNotInFrame;
    ppm.received_overflows = kManyOverflows;
    interruptFlags(wiring::kClockTimer) = 1 << ICF1;
    interruptMask(wiring::kClockTimer) |= 1 << ICIE1;
}

}  // namespace avr

namespace hal {

bool rcRead(uint16_t (&pulse_us)[kRcChannels]) {
    if (!const_cast<const volatile bool&>(ppm.fresh)) return false;
    {
        Locked locked;
        memcpy(pulse_us, ppm.frames + (ppm.filling ^ kRcChannels), sizeof(pulse_us));
        ppm.fresh = false;
    }
    for (uint16_t& width : pulse_us) width /= 2;
    return true;
}

uint16_t rcPulse_us(uint8_t channel) {
    return ppm.frames[(ppm.filling ^ kRcChannels) + channel] / 2;
}

uint32_t rcAge_us() {
    const Locked locked;
    const uint16_t count = avr::timer<wiring::kClockTimer>().count;
    uint8_t overflows = ppm.received_overflows;
    if (overflows == kManyOverflows) return UINT32_MAX;
    if (overflowPending(count)) ++overflows;
    return ((static_cast<uint32_t>(overflows) << 16) + count - ppm.received) / 2;
}

}  // namespace hal

// SPDX-License-Identifier: GPL-3.0-or-later
// The receiver's channels as one train of pulses on the capture pin of the clock's timer:
// drivers/ppm_frames.hpp makes frames of them.
#include <avr/interrupt.h>
#include <avr/io.h>

#include "drivers/ppm_frames.hpp"
#include "hal/interrupts.hpp"
#include "hal/rc_input.hpp"
#include "start.hpp"
#include "timer.hpp"
#include "wiring.hpp"

namespace {

// Overflows of the timer since an edge. An edge just after an overflow whose interrupt has still
// to run begins one below 0, so that it counts from 0 on.
constexpr uint8_t kOwnOverflow = 0xFF;
constexpr uint8_t kManyOverflows = 0xF0;  // the count stays here, 7.9 s

struct {
    drivers::PpmFrames frames;
    uint16_t edge;           // of the last pulse
    uint8_t edge_overflows;  // of the timer since that edge, see kOwnOverflow
    bool fresh;
    uint16_t received;  // the edge that ended the newest frame
    uint8_t received_overflows;
} ppm;

inline bool overflowPending(uint16_t count) {
    return (avr::interruptFlags(wiring::kClockTimer) & (1 << TOV1)) && count < 0x8000;
}

void copy_us(const uint16_t* halves, uint16_t (&us)[hal::kRcChannels]) {
    for (uint8_t i = 0; i < hal::kRcChannels; ++i) us[i] = halves[i] / 2;
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
    if (!ppm.frames.edge(width, too_long)) return;
    ppm.fresh = true;
    ppm.received = ppm.edge;
    ppm.received_overflows = ppm.edge_overflows;
}

namespace avr {

void ppmTick() {
    if (ppm.edge_overflows != kManyOverflows) ++ppm.edge_overflows;
    if (ppm.received_overflows != kManyOverflows) ++ppm.received_overflows;
}

void ppmStart() {
    // a level counts when seen four cycles running
    timer<wiring::kClockTimer>().control_b |= (1 << ICNC1) | (1 << ICES1);
    ppm.frames.reset();
    // Silence counts from now on: the first edge seen may lie in the middle of a frame.
    ppm.edge = timer<wiring::kClockTimer>().count;
    ppm.received_overflows = kManyOverflows;
    interruptFlags(wiring::kClockTimer) = 1 << ICF1;
    interruptMask(wiring::kClockTimer) |= 1 << ICIE1;
}

}  // namespace avr

namespace hal {

bool rcRead(uint16_t (&pulse_us)[kRcChannels]) {
    if (!const_cast<const volatile bool&>(ppm.fresh)) return false;
    const Locked locked;
    copy_us(ppm.frames.newest(), pulse_us);
    ppm.fresh = false;
    return true;
}

bool rcReadWhole(uint16_t (&pulse_us)[kRcChannels]) {
    const Locked locked;
    const uint16_t* whole = ppm.frames.takeWhole();
    if (whole == nullptr) return false;
    copy_us(whole, pulse_us);
    return true;
}

uint16_t rcPulse_us(uint8_t channel) { return ppm.frames.newest()[channel] / 2; }

uint32_t rcAge_us() {
    const Locked locked;
    const uint16_t count = avr::timer<wiring::kClockTimer>().count;
    uint8_t overflows = ppm.received_overflows;
    if (overflows == kManyOverflows) return UINT32_MAX;
    if (overflowPending(count)) ++overflows;
    return ((static_cast<uint32_t>(overflows) << 16) + count - ppm.received) / 2;
}

}  // namespace hal

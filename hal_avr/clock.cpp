// SPDX-License-Identifier: GPL-3.0-or-later
// The clock's timer runs freely at 0.5 us a count; its overflow, every 32.768 ms, carries into RAM.
#include "hal/clock.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#include "hal/interrupts.hpp"
#include "start.hpp"
#include "timer.hpp"
#include "wiring.hpp"

namespace {

inline __attribute__((always_inline)) avr::Timer& counter() {
    return avr::timer<wiring::kClockTimer>();
}

constexpr uint16_t kOverflow_us = 32768;
// In counts. Whether a transmit buffer has room again is checked this often, not after each byte.
constexpr uint16_t kRest = 8000;  // 4 ms
// Shorter by more than the interrupts that may run between reading the clock and sleeping, or the
// end of the rest would come in between and be missed.
constexpr uint16_t kLongestRest = 7600;

// At the last overflow.
struct {
    uint32_t us;
    uint32_t ms;
    uint16_t us_past_ms;  // 0..999
} base;
uint32_t frame_began_ms;

// The timer and `base` belong together. A pending flag belongs to a count that is small again: the
// interrupt for that overflow has still to run.
template <class Take>
__attribute__((always_inline)) inline uint16_t readTimer(bool& overflowed, Take take) {
    const uint8_t previous = SREG;
    cli();
    const uint16_t count = counter().count;
    overflowed = (avr::interruptFlags(wiring::kClockTimer) & (1 << TOV1)) && count < 0x8000;
    take();
    __asm__ volatile("" ::: "memory");
    SREG = previous;
    return count;
}

// Without the 220 cycles of a division: the upper byte, in units of 256 us, gives it or one less.
// Exact for what two summands below can reach.
constexpr uint8_t thousands(uint16_t us) {
    const uint8_t ms = static_cast<uint8_t>((us >> 8) * 65 >> 8);
    return us - ms * 1000U >= 1000 ? ms + 1 : ms;
}

constexpr bool thousandsIsExact() {
    for (uint16_t us = 0; us < kOverflow_us + 1000; ++us)
        if (thousands(us) != us / 1000) return false;
    return true;
}
static_assert(thousandsIsExact(), "the multiplication does not replace the division");

void carry(uint32_t& ms, uint16_t& us_past_ms) {
    ms += kOverflow_us / 1000;
    us_past_ms += kOverflow_us % 1000;
    if (us_past_ms >= 1000) {
        us_past_ms -= 1000;
        ++ms;
    }
}

}  // namespace

namespace avr {

void clockStart() {
    counter().control_a = 0;
    counter().control_b = 1 << CS11;
    interruptMask(wiring::kClockTimer) = (1 << TOIE1) | (1 << OCIE1A);
}

}  // namespace avr

ISR(CLOCK_OVERFLOW_vect) {
    base.us += kOverflow_us;
    carry(base.ms, base.us_past_ms);
    avr::ppmTick();
    avr::eepromTick();
}

ISR(CLOCK_COMPARE_A_vect) { avr::wake(); }

namespace hal {

uint16_t ticks() {
    const uint8_t previous = SREG;
    cli();  // the two halves are read through a register that interrupts use as well
    const uint16_t count = counter().count;
    SREG = previous;
    return count;
}

uint32_t now_us() {
    bool overflowed;
    uint32_t us;
    const uint16_t count = readTimer(overflowed, [&] { us = base.us; });
    if (overflowed) us += kOverflow_us;
    return us + count / 2;
}

uint32_t now_ms() {
    bool overflowed;
    uint32_t ms;
    uint16_t us_past_ms;
    const uint16_t count = readTimer(overflowed, [&] {
        ms = base.ms;
        us_past_ms = base.us_past_ms;
    });
    if (overflowed) carry(ms, us_past_ms);
    return ms + thousands(us_past_ms + count / 2);
}

void beginFrame() { frame_began_ms = now_ms(); }
uint32_t frame_ms() { return frame_began_ms; }

// Where an interrupt has brought work in between, the instruction that sleeps does nothing, as
// that interrupt has taken back its permission (data sheet 11.10.1).
void idle(bool (*work_waits)()) {
    const uint16_t began = ticks();
    {
        const Locked locked;
        counter().compare[0] = began + kRest;
    }
    do {
        SMCR = SLEEP_MODE_IDLE | (1 << SE);
        if (work_waits()) break;
        do sleep_cpu();
        while (SMCR & (1 << SE));
    } while (static_cast<uint16_t>(ticks() - began) < kLongestRest);
    sleep_disable();
}

}  // namespace hal

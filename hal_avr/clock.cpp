// SPDX-License-Identifier: GPL-3.0-or-later
// Timer5 runs freely at 0.5 us a count; its overflow, every 32.768 ms, carries into RAM.
#include "hal/clock.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#include "hal/interrupts.hpp"
#include "start.hpp"

namespace {

constexpr uint16_t kOverflow_us = 32768;
constexpr uint16_t kLongestRest = 4000;  // 2 ms in counts

// At the last overflow.
struct {
    uint32_t us;
    uint32_t ms;
    uint16_t us_past_ms;  // 0..999
} base;

volatile bool rest_is_over;

struct Reading {
    uint16_t us;      // since the overflow `overflowed` tells of
    bool overflowed;  // the interrupt for it has still to run
};

// With interrupts off. A pending flag belongs to a count that is small again.
inline Reading readTimer() {
    const uint16_t count = TCNT5;
    return {static_cast<uint16_t>(count / 2), (TIFR5 & (1 << TOV5)) && count < 0x8000};
}

// Without the 220 cycles of a division; exact for what two summands below can reach.
constexpr uint8_t thousands(uint16_t us) {
    return static_cast<uint8_t>((static_cast<uint32_t>(us >> 3) * 4195) >> 19);
}

constexpr bool thousandsIsExact() {
    for (uint16_t ms = 1; ms <= kOverflow_us / 1000 + 1; ++ms) {
        const uint16_t us = ms * 1000;
        if (thousands(us) != ms || thousands(us - 1) != ms - 1) return false;
    }
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
    TCCR5A = 0;
    TCCR5B = 1 << CS51;
    TIMSK5 = (1 << TOIE5) | (1 << OCIE5A);
}

}  // namespace avr

ISR(TIMER5_OVF_vect) {
    base.us += kOverflow_us;
    carry(base.ms, base.us_past_ms);
    avr::ppmTick();
    avr::eepromTick();
}

ISR(TIMER5_COMPA_vect) { rest_is_over = true; }

namespace hal {

uint32_t now_us() {
    Reading now;
    uint32_t us;
    {
        Locked locked;
        now = readTimer();
        us = base.us;
    }
    if (now.overflowed) us += kOverflow_us;
    return us + now.us;
}

uint32_t now_ms() {
    Reading now;
    uint32_t ms;
    uint16_t us_past_ms;
    {
        Locked locked;
        now = readTimer();
        ms = base.ms;
        us_past_ms = base.us_past_ms;
    }
    if (now.overflowed) carry(ms, us_past_ms);
    return ms + thousands(us_past_ms + now.us);
}

void idle(bool (*work_waits)()) {
    set_sleep_mode(SLEEP_MODE_IDLE);
    cli();
    OCR5A = TCNT5 + kLongestRest;
    rest_is_over = false;
    while (!rest_is_over && !work_waits()) {
        sleep_enable();
        sei();  // takes effect after the next instruction: nothing comes in before the sleep
        sleep_cpu();
        sleep_disable();
        cli();
    }
    sei();
}

}  // namespace hal

// SPDX-License-Identifier: GPL-3.0-or-later
// The servo outputs as their pins show them: each edge is waited for with interrupts off, so that
// none of them delays the look at the clock.
#include "core/rom.hpp"
#include "hal/clock.hpp"
#include "hal/interrupts.hpp"
#include "hal/servo_output.hpp"
#include "self_test/parts.hpp"
#include "self_test/pause.hpp"
#include "self_test/report.hpp"
#include "self_test/span.hpp"
#include "wiring.hpp"

namespace self_test {

namespace {

constexpr uint16_t kRate_hz = 50;
constexpr uint16_t kWidths_us[] = {800, 900, 1000};
constexpr uint8_t kPulses = 10;
constexpr uint16_t kPeriod = 40000, kBefore = 200;  // of 0.5 us
constexpr uint16_t kLooks = 900;                    // at a pin, of some 9 cycles each
constexpr uint8_t kPeriods_ms = 70;                 // a new width is taken over

struct Level {
    volatile uint8_t* in;
    uint8_t mask;
    bool high() const { return (*in & mask) != 0; }
};

// Where the compares of a timer come out: data sheet 13.3, alternate functions of the ports.
Level pinOf(uint8_t output) {
    const avr::ServoPin of = core::romRead(wiring::kServos[output]);
    const uint8_t first = of.timer == 1 ? 5 : 3;
    volatile uint8_t* const in = of.timer == 1   ? &avr::PortB::in()
                                 : of.timer == 3 ? &avr::PortE::in()
                                 : of.timer == 4 ? &avr::PortH::in()
                                                 : &avr::PortL::in();
    return {in, static_cast<uint8_t>(1 << (first + of.compare))};
}

// `after` counts behind `from`, or up to 100 us before; false: not within about 300 us more.
bool edge(const Level& pin, bool high, uint16_t from, uint16_t after, uint16_t& at) {
    while (static_cast<uint16_t>(hal::ticks() - from) < after - kBefore) {
    }
    const hal::Locked locked;
    uint16_t looks = kLooks;  // the clock is looked at once: it takes longer than a pin
    while (pin.high() != high && --looks != 0) {
    }
    at = hal::ticks();
    return looks != 0;
}

// About when a pulse begins; false: none does within two periods.
bool findPulse(const Level& pin, uint16_t& begins) {
    const uint32_t from_ms = hal::now_ms();
    bool was_high = true;
    while (hal::now_ms() - from_ms < 2 * 1000 / kRate_hz) {
        const bool is_high = pin.high();
        begins = hal::ticks();
        if (is_high && !was_high) return true;
        was_high = is_high;
    }
    return false;
}

// `seen` stays empty where there is no pulse.
void measure(const Level& pin, uint16_t width, Span& seen, Span& period) {
    uint16_t rose, fell, next;
    if (!findPulse(pin, rose)) return;
    if (!edge(pin, true, rose, kPeriod, rose)) return;
    for (uint8_t i = 0; i < kPulses; ++i) {
        if (!edge(pin, false, rose, width, fell) || !edge(pin, true, rose, kPeriod, next)) return;
        seen.take(fell - rose);
        period.take(next - rose);
        rose = next;
    }
}

void endSpan(const Span& of) {
    text(TEXT(" least "));
    microseconds(of.most == 0 ? 0 : of.least);
    text(TEXT(" most "));
    microseconds(of.most);
    endLine();
}

void testOutput(uint8_t output) {
    const Level pin = pinOf(output);
    Span period;
    for (const uint16_t width_us : kWidths_us) {
        Span seen;
        hal::servoWrite(output, 2 * width_us);
        pause_ms(kPeriods_ms);
        measure(pin, 2 * width_us, seen, period);
        text(TEXT("pulse "));
        number(output + 1);
        text(TEXT(" asked "));
        number(width_us);
        endSpan(seen);
    }
    hal::servoWrite(output, 0);
    text(TEXT("period "));
    number(output + 1);
    endSpan(period);
}

}  // namespace

void testPulses() {
    hal::servoStart(kRate_hz);
    for (uint8_t output = 0; output < hal::kServos; ++output) testOutput(output);
}

}  // namespace self_test

// SPDX-License-Identifier: GPL-3.0-or-later
// Servo outputs on timers that count 0.5 us to TOP (mode 14). The hardware takes a new width over
// at the period's beginning, and an output is silenced at the end of its pulse, so no servo ever
// sees a pulse that was not asked for. Outputs on the clock's timer are clock_pulses.hpp's.
#include "pwm.hpp"

#include "clock_pulses.hpp"
#include "core/rom.hpp"
#include "hal/interrupts.hpp"
#include "hal/servo_output.hpp"
#include "wiring.hpp"

static_assert(core::count(wiring::kServos) == hal::kServos, "a row for each output");

namespace hal {

static inline bool onClock(uint8_t timer) {
    return wiring::kServosOnClock && timer == wiring::kClockTimer;
}

void servoStart(uint16_t rate_hz) {
    const uint16_t top = static_cast<uint16_t>(F_CPU / 8 / rate_hz - 1);
    Locked locked;
    avr::servoTimersStart(top);
}

void servoWrite(uint8_t output, uint16_t pulse_halfus) {
    if (output >= kServos) return;
    const avr::ServoPin& to = wiring::kServos[output];
    const uint8_t number = core::romRead(to.timer), compare = core::romRead(to.compare);
    if (onClock(number)) return avr::clockPulseWrite(compare, pulse_halfus);
    avr::Timer& timer = avr::timerAt(core::romRead(to.address));
    volatile uint8_t& mask = avr::interruptMask(number);
    const uint8_t bit = avr::compareBit(compare);
    Locked locked;
    if (pulse_halfus == 0) {
        if (!(timer.control_a & avr::comparePin(compare))) return;
        avr::interruptFlags(number) = bit;
        mask |= bit;
        return;
    }
    const uint16_t top = timer.capture;
    // The pin falls with the count after the compare (data sheet 17.9.3). A width of a whole
    // period would never fall.
    timer.compare[compare] = (pulse_halfus > top ? top : pulse_halfus) - 1;
    mask &= static_cast<uint8_t>(~bit);
    timer.control_a |= avr::comparePin(compare);
}

uint16_t servoRead(uint8_t output) {
    if (output >= kServos) return 0;
    const avr::ServoPin of = core::romRead(wiring::kServos[output]);
    if (onClock(of.timer)) return avr::clockPulseRead(of.compare);
    const avr::Timer& timer = avr::timerAt(of.address);
    const bool ending = avr::interruptMask(of.timer) & avr::compareBit(of.compare);
    const bool running = timer.control_a & avr::comparePin(of.compare);
    return running && !ending ? timer.compare[of.compare] + 1 : 0;
}

}  // namespace hal

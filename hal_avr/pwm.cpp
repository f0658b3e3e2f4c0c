// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs 1..8 on Timers 1, 3 and 4, which count 0.5 us to TOP (mode 14). The hardware takes a
// new width over at the period's beginning, and an output is silenced at the end of its pulse, so
// no servo ever sees a pulse that was not asked for.
#include <avr/interrupt.h>
#include <avr/io.h>

#include "core/rom.hpp"
#include "hal/interrupts.hpp"
#include "hal/servo_output.hpp"
#include "pin.hpp"

namespace {

// TCCRnA and the registers after it (data sheet, register summary)
struct Timer {
    volatile uint8_t control_a, control_b, control_c, reserved;
    volatile uint16_t count, top;
    volatile uint16_t compare[3];
};

template <uint8_t number>
struct At;
template <>
struct At<1> {
    static constexpr uint8_t kAddress = 0x80;
};
template <>
struct At<3> {
    static constexpr uint8_t kAddress = 0x90;
};
template <>
struct At<4> {
    static constexpr uint8_t kAddress = 0xA0;
};

inline Timer& timerAt(uint8_t address) {
    return *reinterpret_cast<Timer*>(static_cast<uint16_t>(address));
}
inline volatile uint8_t& interruptMask(uint8_t number) { return (&TIMSK0)[number]; }
inline volatile uint8_t& interruptFlags(uint8_t number) { return (&TIFR0)[number]; }

struct Output {
    uint8_t number;  // of the timer
    uint8_t address;
    uint8_t compare;  // 0..2: A, B, C
};

template <uint8_t number>
constexpr Output on(char compare) {
    return {number, At<number>::kAddress, static_cast<uint8_t>(compare - 'A')};
}

// clang-format off
constexpr Output kOutputs[] ROM = {
    on<1>('B'),  // PB6
    on<1>('A'),  // PB5
    on<4>('C'),  // PH5
    on<4>('B'),  // PH4
    on<4>('A'),  // PH3
    on<3>('C'),  // PE5
    on<3>('B'),  // PE4
    on<3>('A'),  // PE3
};
// clang-format on
static_assert(core::count(kOutputs) == hal::kServos, "a row for each output");

constexpr uint8_t kModeA = 1 << WGM11;
constexpr uint8_t kModeB = (1 << WGM13) | (1 << WGM12);
constexpr uint8_t kRunning = kModeB | (1 << CS11);
constexpr uint8_t pinBit(uint8_t compare) { return static_cast<uint8_t>(0x80 >> (2 * compare)); }
constexpr uint8_t compareBit(uint8_t compare) { return static_cast<uint8_t>(2 << compare); }

void startTimer(Timer& timer, uint16_t top) {
    timer.control_b = kModeB;  // stopped
    timer.control_a = kModeA;  // all pins are the port's: low
    timer.top = top;
    timer.count = 0;
    timer.control_b = kRunning;
}

// The end of an output's last pulse.
template <uint8_t number, char compare>
inline void silence() {
    constexpr uint8_t index = compare - 'A';
    timerAt(At<number>::kAddress).control_a &= static_cast<uint8_t>(~pinBit(index));
    interruptMask(number) &= static_cast<uint8_t>(~compareBit(index));
}

}  // namespace

ISR(TIMER1_COMPA_vect) { silence<1, 'A'>(); }
ISR(TIMER1_COMPB_vect) { silence<1, 'B'>(); }
ISR(TIMER3_COMPA_vect) { silence<3, 'A'>(); }
ISR(TIMER3_COMPB_vect) { silence<3, 'B'>(); }
ISR(TIMER3_COMPC_vect) { silence<3, 'C'>(); }
ISR(TIMER4_COMPA_vect) { silence<4, 'A'>(); }
ISR(TIMER4_COMPB_vect) { silence<4, 'B'>(); }
ISR(TIMER4_COMPC_vect) { silence<4, 'C'>(); }

namespace hal {

void servoStart(uint16_t rate_hz) {
    const uint16_t top = static_cast<uint16_t>(F_CPU / 8 / rate_hz - 1);
    Locked locked;
    TIMSK1 = TIMSK3 = TIMSK4 = 0;
    startTimer(timerAt(At<1>::kAddress), top);
    startTimer(timerAt(At<3>::kAddress), top);
    startTimer(timerAt(At<4>::kAddress), top);
    avr::Pin<avr::PortB, 6>::output();
    avr::Pin<avr::PortB, 5>::output();
    avr::Pin<avr::PortE, 5>::output();
    avr::Pin<avr::PortE, 4>::output();
    avr::Pin<avr::PortE, 3>::output();
    avr::Pin<avr::PortH, 5>::output();
    avr::Pin<avr::PortH, 4>::output();
    avr::Pin<avr::PortH, 3>::output();
}

void servoWrite(uint8_t output, uint16_t pulse_halfus) {
    if (output >= kServos) return;
    const Output to = core::romRead(kOutputs[output]);
    Timer& timer = timerAt(to.address);
    volatile uint8_t& mask = interruptMask(to.number);
    const uint8_t bit = compareBit(to.compare);
    Locked locked;
    if (pulse_halfus == 0) {
        if (!(timer.control_a & pinBit(to.compare))) return;
        interruptFlags(to.number) = bit;
        mask |= bit;
        return;
    }
    const uint16_t top = timer.top;
    // The pin falls with the count after the compare (data sheet 17.9.3). A width of a whole
    // period would never fall.
    timer.compare[to.compare] = (pulse_halfus > top ? top : pulse_halfus) - 1;
    mask &= static_cast<uint8_t>(~bit);
    timer.control_a |= pinBit(to.compare);
}

uint16_t servoRead(uint8_t output) {
    if (output >= kServos) return 0;
    const Output of = core::romRead(kOutputs[output]);
    const Timer& timer = timerAt(of.address);
    const bool ending = interruptMask(of.number) & compareBit(of.compare);
    const bool running = timer.control_a & pinBit(of.compare);
    return running && !ending ? timer.compare[of.compare] + 1 : 0;
}

}  // namespace hal

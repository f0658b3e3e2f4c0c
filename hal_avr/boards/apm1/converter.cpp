// SPDX-License-Identifier: GPL-3.0-or-later
// The ADS7844 between Timer2, which begins a set every millisecond, and the interrupt of its bus.
#include "converter.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "board.hpp"
#include "wiring.hpp"

// Flat: with a call in it an interrupt saves every register.
ISR(TIMER2_COMPA_vect, __attribute__((flatten))) { board::Converter::beginSet(); }
ISR(USART2_TX_vect, __attribute__((flatten))) { board::Converter::onSent(); }

namespace board {

void converterStart() {
    constexpr uint16_t kSteps = F_CPU / 64 * Inertial::kSet_us / 1000000UL;
    static_assert(kSteps <= 256, "Timer2 has 8 bits");
    TCCR2A = 1 << WGM21;
    OCR2A = kSteps - 1;
    TCNT2 = 0;
    TIMSK2 = 1 << OCIE2A;
    TCCR2B = 1 << CS22;  // 4 us a step
}

}  // namespace board

namespace wiring {

hal::AnalogSum airspeed() { return board::Inertial::takeAirspeed(); }

}  // namespace wiring

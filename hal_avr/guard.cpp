// SPDX-License-Identifier: GPL-3.0-or-later
// Timer0 overflows every 4.1 ms.
#include "hal/guard.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "restart.hpp"

namespace {

constexpr uint8_t kPatience = 12;  // 49 ms
volatile uint8_t untouched;

}  // namespace

ISR(TIMER0_OVF_vect) {
    avr::noteSupply(avr::supplyLow());
    if (untouched < kPatience)
        ++untouched;
    else
        hal::servosForgotten();
}

namespace hal {

void guardStart() {
    untouched = 0;
    TCCR0A = 0;
    TIMSK0 = 1 << TOIE0;
    TCCR0B = 1 << CS02;  // 16 us a step
}

void guardTouch() { untouched = 0; }

}  // namespace hal

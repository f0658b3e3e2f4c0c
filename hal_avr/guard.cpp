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

// Keeps every register it uses, as an interrupt does: who comes here keeps few.
extern "C" void __vector_guard_forgotten() __attribute__((signal, used));
void __vector_guard_forgotten() { hal::passSticksToServos(); }

ISR(TIMER0_OVF_vect) {
    avr::noteSupply(avr::supplyLow());
    if (untouched < kPatience)
        ++untouched;
    else  // it comes back with interrupts on, but not before one more instruction
        __asm__ volatile("call __vector_guard_forgotten\n\tcli" ::: "memory");
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

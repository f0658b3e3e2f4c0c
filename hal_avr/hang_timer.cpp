// SPDX-License-Identifier: GPL-3.0-or-later
// Timer0 overflows every 4.1 ms.
#include "hal/hang_timer.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "restart.hpp"

namespace {

constexpr uint8_t kHangs = 12;  // 49 ms
volatile uint8_t overflows;

}  // namespace

// Saves every register it uses, as an interrupt does: the interrupt below has saved few.
extern "C" void __vector_program_hangs() __attribute__((signal, used));
void __vector_program_hangs() { hal::passSticksToServos(); }

ISR(TIMER0_OVF_vect) {
    avr::noteSupply(avr::supplyLow());
    if (overflows < kHangs)
        ++overflows;
    else  // its RETI switches interrupts on, with effect after one more instruction
        __asm__ volatile("call __vector_program_hangs\n\tcli" ::: "memory");
}

namespace hal {

void hangTimerStart() {
    overflows = 0;
    TCCR0A = 0;
    TIMSK0 = 1 << TOIE0;
    TCCR0B = 1 << CS02;  // 16 us a step
}

void hangTimerReset() { overflows = 0; }

}  // namespace hal

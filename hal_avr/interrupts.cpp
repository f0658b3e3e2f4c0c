// SPDX-License-Identifier: GPL-3.0-or-later
#include "hal/interrupts.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "restart.hpp"

namespace hal {

uint8_t lockInterrupts() {
    const uint8_t previous = SREG;
    __asm__ volatile("cli" ::: "memory");
    return previous;
}

void unlockInterrupts(uint8_t previous) {
    __asm__ volatile("" ::: "memory");
    SREG = previous;
}

}  // namespace hal

// An interrupt without a handler: the library's own answer is a jump to 0, which would start the
// program on peripherals in any state.
ISR(BADISR_vect) { avr::restart(hal::ResetCause::fault); }

// SPDX-License-Identifier: GPL-3.0-or-later
// The peripherals' own start-up, called by the board in the order it needs. All with interrupts
// off; none waits. And what their interrupts hand to one another.
#pragma once
#include <avr/io.h>
#include <stdint.h>

namespace avr {

void clockStart();   // its timer runs; first, the others take times from it
void ppmStart();     // input capture of the same timer
void serialStart();  // pull-ups on the receive pins
void twiStart();
void adcStart();
void imuInterruptStart();  // INT6

// Called by the interrupts that may bring work: hal::idle's permission to sleep ends, and it looks.
inline void wake() { SMCR = 0; }

// Called by the clock's interrupt at every overflow of its timer, which is every 32.768 ms.
void ppmTick();     // counts how long the receiver has been silent
void eepromTick();  // lets the queue go on when a reader has not come back

}  // namespace avr

// SPDX-License-Identifier: GPL-3.0-or-later
// The peripherals' own start-up, called by the board in the order it needs. All with interrupts
// off; none waits.
#pragma once
#include <stdint.h>

namespace avr {

void clockStart();   // Timer5 runs; first, the others take times from it
void ppmStart();     // input capture of the same timer
void serialStart();  // pull-ups on the receive pins
void twiStart();
void adcStart();
void imuInterruptStart();  // INT6

// For other interrupts: how often Timer5 has overflowed (every 32.768 ms), low byte.
extern volatile uint8_t clock_overflows;
// Called at every overflow: lets the EEPROM queue go on when a reader has not come back.
void eepromTick();

}  // namespace avr

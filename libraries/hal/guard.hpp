// SPDX-License-Identifier: GPL-3.0-or-later
// A timer's interrupt that is left when the program no longer comes round: from then on until the
// watchdog bites it lets the firmware pass the sticks to the servos. It also watches the supply.
#pragma once

namespace hal {

void guardStart();
void guardTouch();  // every frame, by whoever drives the servos; within 49 ms

// Defined by the firmware: called every 4 ms while nobody touches the guard, interrupts off; at
// most 40 us.
void passSticksToServos();

}  // namespace hal

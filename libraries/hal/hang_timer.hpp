// SPDX-License-Identifier: GPL-3.0-or-later
// A timer whose interrupt finds out that the program hangs: from then on until the watchdog resets
// the chip it lets the firmware pass the sticks to the servos. It also watches the supply.
#pragma once

namespace hal {

void hangTimerStart();
void hangTimerReset();  // every frame, by whoever drives the servos; at the latest after 49 ms

// Defined by the firmware: called every 4 ms while nobody resets the timer, interrupts off; at
// most 40 us.
void passSticksToServos();

}  // namespace hal

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "hal/watchdog.hpp"

namespace avr {

// Ends this run, leaves a note why, and begins anew through address 0, which no bootloader can turn
// into an end: some loop for ever after a watchdog's reset. Where one asks for it, on the ground,
// it is that reset, on a board whose bootloader should survive it: one that does not is found
// there.
[[noreturn]] void restart(hal::ResetCause why);

// While the supply is below what the board needs, and for a quarter of a second afterwards; called
// every 4 ms. A run that then ends without a note ended by a brown-out.
void noteSupply(bool low);

// Now or within that quarter of a second, for at most two seconds: a byte that is written to the
// EEPROM meanwhile may become any value. A supply that is low for good, or is measured too low (the
// band gap is off by up to 9 %, data sheet 31.8), must not stop what is to be stored.
extern volatile bool supply_sags;

// Below 4.2 V, by a conversion between two scans of the analogue inputs; called likewise.
bool supplyLow();

}  // namespace avr

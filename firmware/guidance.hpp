// SPDX-License-Identifier: GPL-3.0-or-later
// Flies vehicle.demand: from where the airplane is to the bank, pitch and throttle that bring it
// where it should be, and how far it has come (vehicle.progress).
#pragma once

namespace firmware {

// 20 Hz, after the mode has run. Does nothing in a mode that does not guide itself.
void runGuidance();

}  // namespace firmware

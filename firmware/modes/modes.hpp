// SPDX-License-Identifier: GPL-3.0-or-later
// Which mode flies. Each mode is a file in modes/ with a start and a run function; the table in
// modes.cpp joins them.
#pragma once
#include <stdint.h>

#include "firmware/state/mode_traits.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using state::ModeReason;

void startModes();  // INITIALISING, until the first mode is set

// The only way to another mode. False: the number is no mode of this airplane, the one who asks may
// not now (mode_requests.hpp), or the mode cannot be entered now; the reason has been reported.
// Asking for the present mode again does nothing and is true.
bool requestMode(state::Mode mode, ModeReason reason);

void runMode();       // 100 Hz: the mode's own work
void demandOfMode();  // 20 Hz, of guidance

}  // namespace modes
}  // namespace firmware

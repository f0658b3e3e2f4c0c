// SPDX-License-Identifier: GPL-3.0-or-later
// Which mode flies. Each mode is a file in modes/ with a start and a run function; the table in
// modes.cpp joins them.
#pragma once
#include <stdint.h>

#include "firmware/state/mode_traits.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

enum class ModeReason : uint8_t { pilot, ground, mission, failsafe, boot };

void startModes();  // INITIALISING, until the first mode is set

// False: the number is no mode of this airplane, or the mode cannot be entered now (the reason
// has been reported). Setting the present mode again does nothing and is true.
bool setMode(state::Mode mode, ModeReason reason);

void runMode();       // 100 Hz: the mode's own work
void demandOfMode();  // 20 Hz, of guidance

}  // namespace modes
}  // namespace firmware

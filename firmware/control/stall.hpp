// SPDX-License-Identifier: GPL-3.0-or-later
// Stalls, in every mode whose elevator is the firmware's (STALL_PREVENTION): attitude control lets
// the nose fall and pulls out gently. Not near the ground, in a take-off, upside down, in AUTOTUNE,
// or where the pilot's stick is the elevator.
#pragma once
#include "control/stall.hpp"

namespace firmware {
namespace control {

void runStall();  // 20 Hz
::control::Stall::Phase stallPhase();
bool stallNeedsPower();  // and the throttle is the firmware's
bool stallIsSlow();      // the nose stays low until there is speed

}  // namespace control
}  // namespace firmware

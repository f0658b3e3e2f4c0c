// SPDX-License-Identifier: GPL-3.0-or-later
// Stalls, in every mode whose elevator is the firmware's (STALL_PREVENTION): attitude control lets
// the nose fall and pulls out gently. Not near the ground, in a take-off, upside down, or where the
// pilot's stick is the elevator.
#pragma once
#include "control/stall.hpp"
#include "core/file_state.hpp"

namespace firmware {
namespace control {

struct StallRecovery {
    ::control::Stall::Phase phase;
    bool slow;        // the nose stays low until there is speed
    bool full_power;  // and the throttle is the firmware's
};
extern core::FileState<StallRecovery> stall_recovery;

void runStall();  // 20 Hz

}  // namespace control
}  // namespace firmware

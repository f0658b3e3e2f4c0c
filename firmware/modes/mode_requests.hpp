// SPDX-License-Identifier: GPL-3.0-or-later
// Whose request for a mode is granted. Everyone asks by requestMode (modes.hpp); the table here
// says who may while something stands against it. Among those who may, the last one wins.
#pragma once
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

// What may stand against a request.
struct ModeSituation {
    bool resuming;     // the flight from before a restart goes on, in a mode not decided yet
    bool no_attitude;  // armed, and the inertial sensor is lost
    bool no_sticks;    // armed, and the receiver is lost
};

ModeSituation modeSituation();  // as it is now

bool mayEnter(state::Mode mode, state::ModeReason reason, const ModeSituation& now);

}  // namespace modes
}  // namespace firmware

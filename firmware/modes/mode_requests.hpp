// SPDX-License-Identifier: GPL-3.0-or-later
// Which requests for a mode are granted. All go through requestMode (modes.hpp); the table here
// says who may change the mode in a situation that forbids it to others. Of several requests that
// are granted, the last one wins.
#pragma once
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

// Situations in which not everyone may change the mode.
struct ModeSituation {
    bool resuming;     // the flight from before a restart goes on, in a mode not decided yet
    bool no_attitude;  // armed, and the inertial sensor is lost
    bool no_sticks;    // armed, and the receiver is lost
};

ModeSituation modeSituation();  // as it is now

bool mayEnter(state::Mode mode, state::ModeReason reason, const ModeSituation& now);

}  // namespace modes
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// One flight for each kind of path: it demands the bank, publishes the progress and returns what is
// left to be done with pitch and throttle. 20 Hz. What has a memory begins afresh with a path.
#pragma once
#include "firmware/guidance/plan.hpp"

namespace firmware {
namespace guidance {

Plan flyLeg();

void beginCircling();
Plan flyCircle();

void beginTakeoff();
Plan flyTakeoff();

void beginLanding();
Plan flyLanding();
float flarePower();  // what the flare keeps of the cruise throttle

}  // namespace guidance
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// An airplane whose surfaces are stronger than its gains are made for swings from side to side
// until it crashes. Its axis flies on with weaker gains, until it is disarmed or AUTOTUNE makes
// parameters of them.
#pragma once
#include "control/axis.hpp"
#include "control/swing.hpp"
#include "firmware/control/autotune.hpp"

namespace firmware {
namespace control {

// 20 Hz, while the axis is flown by its gains. True: they are to be weakened, this time once.
bool oscillates(TunedAxis axis, core::BodyRate rate_rads, core::Ratio surface, int16_t stick_cd);

// Gains that have been made of the parameters anew, as weak as they were.
void weakenAsBefore(TunedAxis axis, ::control::AxisGains& gains);

// 5 Hz. True: from now on the gains are those of the parameters.
bool weaknessEnds(TunedAxis axis);

::control::Swing& swingOf(TunedAxis axis);  // AUTOTUNE watches it, too

}  // namespace control
}  // namespace firmware

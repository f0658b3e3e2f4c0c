// SPDX-License-Identifier: GPL-3.0-or-later
// AUTOTUNE: FBWA that multiplies the gains of roll and pitch by what it finds in the pilot's turns.
#pragma once
#include "control/axis.hpp"
#include "control/swing.hpp"

namespace firmware {
namespace control {

enum TunedAxis : uint8_t { kTunedRoll, kTunedPitch };

void startTuning();  // AUTOTUNE has been entered

// While AUTOTUNE flies, after the loop of that axis has run with these.
void tune(TunedAxis which, const ::control::AxisGains& gains, const ::control::AxisState& state,
          const ::control::AirFlow& air, core::Angle error_rad, core::BodyRate rate_rads,
          ::control::Swing& swing);

// Sets the axis's gains to so much of what they are. False: not yet, others are being set.
bool tuneTo(TunedAxis which, uint8_t left_pct);

void tuneStep();  // 10 Hz: sets the next of what has been found

}  // namespace control
}  // namespace firmware

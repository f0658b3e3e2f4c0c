// SPDX-License-Identifier: GPL-3.0-or-later
// The three loops that hold an attitude: bank with the ailerons, pitch with the elevator, and the
// rudder that keeps turns coordinated. Each keeps its state in a struct of its own; a state made
// anew is a loop at rest.
#pragma once
#include "control/axis.hpp"

namespace control {

// Right wing down is positive.
float rollDeflection(const RollSettings& settings, AxisState& state, const AirFlow& air,
                     float error_rad, float rate_rads);

struct Bank {
    float sin_roll, cos_roll, cos_pitch;
};

// Nose up is positive. In a turn the nose has to come up along the horizon without the pitch
// angle changing: that body rate is added to the demand.
float pitchDeflection(const PitchSettings& settings, AxisState& state, const AirFlow& air,
                      const Bank& bank, float error_rad, float rate_rads);

struct YawState {
    float high_passed_rads = 0;
    float last_error_rads = 0;
    float integrator = 0;
};

// Nose right is positive. Damps what the turn does not ask for, and takes side-slip away.
float yawDeflection(const YawSettings& settings, YawState& state, const AirFlow& air,
                    const Bank& bank, float rate_rads, float lateral_accel_mss);

}  // namespace control

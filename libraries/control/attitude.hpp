// SPDX-License-Identifier: GPL-3.0-or-later
// The three loops that hold an attitude: bank with the ailerons, pitch with the elevator, and the
// rudder that keeps turns coordinated. Each keeps its state in a struct of its own; a state made
// anew is a loop at rest.
#pragma once
#include "control/axis.hpp"

namespace control {

// Right wing down is positive.
core::Ratio rollDeflection(const AxisGains& gains, AxisState& state, const AirFlow& air,
                           core::Angle error_rad, core::BodyRate rate_rads, uint8_t periods);

// The body rates of a coordinated turn with the present bank. In it the nose has to come up along
// the horizon without the pitch angle changing.
struct TurnRates {
    core::BodyRate pitch_rads;
    float yaw_rads;
};
TurnRates turnRates(const AirFlow& air, float sin_roll, float cos_roll, float cos_pitch);

// Nose up is positive.
core::Ratio pitchDeflection(const AxisGains& gains, AxisState& state, const AirFlow& air,
                            const TurnRates& turn, core::Angle error_rad, core::BodyRate rate_rads,
                            uint8_t periods);

struct YawState {
    float high_passed_rads = 0;
    float last_error_rads = 0;
    float integrator = 0;
};

bool yawUsed(const YawSettings& settings);  // yawDeflection is always 0 otherwise
// Nose right is positive. Damps what the turn does not ask for, and takes side-slip away.
float yawDeflection(const YawSettings& settings, YawState& state, const AirFlow& air,
                    const TurnRates& turn, float rate_rads, float lateral_accel_mss, float dt_s);

}  // namespace control

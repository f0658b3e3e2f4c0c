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
    core::BodyRate pitch_rads, yaw_rads;
};
TurnRates turnRates(const AirFlow& air, float sin_roll, float cos_roll, float cos_pitch);

// Nose up is positive.
core::Ratio pitchDeflection(const AxisGains& gains, AxisState& state, const AirFlow& air,
                            const TurnRates& turn, core::Angle error_rad, core::BodyRate rate_rads,
                            uint8_t periods);

struct YawGains {
    core::Gain damping;       // of full deflection for a radian a second, at the scaling speed
    core::Gain coordination;  // of the turn's yaw rate
    float slip, integral, integrator_max;
};
YawGains yawGains(const YawSettings& settings);

struct YawState {
    core::Fixed32<18> high_passed_rads = {};
    core::BodyRate last_error_rads = {};
    float integrator = 0;
};

// Nose right is positive. Damps what the turn does not ask for, and takes side-slip away. `periods`
// of 5 ms. Limited to -1..1.
core::Ratio yawDeflection(const YawGains& gains, YawState& state, const AirFlow& air,
                          const TurnRates& turn, core::BodyRate rate_rads,
                          core::Acceleration lateral_mss, uint8_t periods);

}  // namespace control

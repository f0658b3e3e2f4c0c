// SPDX-License-Identifier: GPL-3.0-or-later
// The loop that roll and pitch share: from a demanded rate to a deflection of -1..1. Feed-forward
// falls with the airspeed, damping with its square, as the airplane's own moments grow.
// What changes slowly is prepared in floats at a lower rate; the loop itself is fixed point.
#pragma once
#include "control/settings.hpp"
#include "core/fixed.hpp"

namespace control {

// How the surfaces work at this airspeed: the same for all loops.
struct AirFlow {
    core::Ratio speed_scale;  // SCALING_SPEED over airspeed, within 0.5 .. 2
    float inverse_airspeed_spm;
    bool integrators_rest;  // below the lowest flying speed
};
AirFlow airFlow(float scaling_speed_mps, float airspeed_mps, bool integrators_rest);

// Of full deflection and radians, at the scaling speed.
struct AxisGains {
    core::Fixed<15> rate_per_error;  // from an Angle's steps to a BodyRate's
    core::BodyRate most_up_rads, most_down_rads;
    core::Gain turn_compensation;
    core::Gain feed_forward, damping;
    core::Fixed<20> integral;  // in two sample periods
    core::Ratio integrator_max;
};
AxisGains rollGains(const RollSettings& settings);
AxisGains pitchGains(const PitchSettings& settings);
// Leaves kWeakened of them, for an axis that oscillates.
constexpr float kWeakened = 0.6f;
void weaken(AxisGains& gains);

struct AxisState {
    using Output = core::Fixed32<20>;
    core::Fixed32<30> integrator = {};  // of full deflection
    Output last_output = {};            // the same, before it was limited
};

// The rate that takes an error away, within the limits.
core::BodyRate demandedRate_rads(const AxisGains& gains, core::Angle error_rad);

// The fastest rate that is demanded: RMAX, or what most of the surface turns the airplane with.
// Farther out it would stay at its stop all the way from bank to bank, where it damps nothing.
core::BodyRate fastestRate_rads(const AxisGains& gains, const AirFlow& air, int16_t rate_max_dps);

// `periods` of 5 ms. Limited to -1..1.
core::Ratio axisDeflection(const AxisGains& gains, AxisState& state, const AirFlow& air,
                           core::BodyRate demand_rads, core::BodyRate rate_rads, uint8_t periods);

}  // namespace control

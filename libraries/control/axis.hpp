// SPDX-License-Identifier: GPL-3.0-or-later
// The loop that roll and pitch share: from a demanded rate to a deflection of -1..1. Feed-forward
// falls with the airspeed, damping with its square, as the airplane's own moments grow.
// What changes slowly is prepared at a lower rate: a division costs as much as four products.
#pragma once
#include "control/settings.hpp"

namespace control {

// How the air is felt: the same for all loops.
struct AirFlow {
    float speed_scale;  // SCALING_SPEED over airspeed, within 0.5 .. 2
    float inverse_airspeed_spm;
    bool too_slow;  // below the lowest flying speed integrators rest
};
AirFlow airFlow(float scaling_speed_mps, float airspeed_mps, float lowest_flying_mps);

// Of full deflection and radians, at the scaling speed.
struct AxisGains {
    float rate_per_error;
    float feed_forward;
    float damping;
    float integral;
};
AxisGains axisGains(const AxisSettings& settings);

struct AxisState {
    float integrator = 0;   // of full deflection
    float last_output = 0;  // before it was limited
};

// `rate_demand_rads` includes the error times rate_per_error. Limited to -1..1.
float axisDeflection(const AxisGains& gains, int16_t integrator_max_cd, AxisState& state,
                     const AirFlow& air, float rate_demand_rads, float rate_rads, float dt_s);

}  // namespace control

// SPDX-License-Identifier: GPL-3.0-or-later
// The loop that roll and pitch share: from a demanded rate to a deflection of -1..1. Feed-forward
// falls with the airspeed, damping with its square, as the airplane's own moments grow.
#pragma once
#include "control/settings.hpp"

namespace control {

// What is the same for all loops of one frame.
struct AirFlow {
    float speed_scale;  // see speedScale()
    float airspeed_mps;
    float inverse_airspeed_spm;
    bool too_slow;  // below the lowest flying speed integrators rest
    float dt_s;
};

// SCALING_SPEED over airspeed, within 0.5 .. 2.
float speedScale(float scaling_speed_mps, float inverse_airspeed_spm);

struct AxisState {
    float integrator = 0;   // of full deflection
    float last_output = 0;  // before it was limited
};

// `rate_demand_rads` includes `error_rad` over the time constant. Limited to -1..1.
float axisDeflection(const AxisSettings& settings, AxisState& state, const AirFlow& air,
                     float rate_demand_rads, float rate_rads);

}  // namespace control

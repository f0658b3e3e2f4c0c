// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/axis.hpp"

#include "core/maths.hpp"

namespace control {
namespace {

// Gains are degrees of surface for degrees of angle, and 45 degrees are all of a surface.
constexpr float kFullPerRadian = 4.0f / core::kPi;
constexpr float kFullPerCentidegree = 1.0f / 4500.0f;

}  // namespace

float speedScale(float scaling_speed_mps, float inverse_airspeed_spm) {
    return core::limit(scaling_speed_mps * inverse_airspeed_spm, 0.5f, 2.0f);
}

float axisDeflection(const AxisSettings& settings, AxisState& state, const AirFlow& air,
                     float rate_demand_rads, float rate_rads) {
    const float i = settings.i * settings.time_constant_s;
    const float feed_forward = (settings.p - i) * settings.time_constant_s - settings.d;
    const float scale = air.speed_scale * kFullPerRadian;
    const float error_rads = (rate_demand_rads - rate_rads) * air.speed_scale;

    if (i <= 0) {
        state.integrator = 0;
    } else if (!air.too_slow) {
        const float step = error_rads * i * scale * air.dt_s;
        const bool winds_up =
            (state.last_output > 1 && step > 0) || (state.last_output < -1 && step < 0);
        const float limit = settings.integrator_max_cd * kFullPerCentidegree;
        if (!winds_up) state.integrator = core::limit(state.integrator + step, -limit, limit);
    }

    float output = settings.d * error_rads;
    if (feed_forward > 0) output += feed_forward * rate_demand_rads;
    state.last_output = output * scale + state.integrator;
    return core::limit(state.last_output, -1.0f, 1.0f);
}

}  // namespace control

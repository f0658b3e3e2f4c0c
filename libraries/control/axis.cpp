// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/axis.hpp"

#include "core/maths.hpp"

namespace control {
namespace {

// Gains are degrees of surface for degrees of angle, and 45 degrees are all of a surface.
constexpr float kFullPerRadian = 4.0f / core::kPi;
constexpr float kFullPerCentidegree = 1.0f / 4500.0f;
constexpr float kSlowest_mps = 3.0f;  // nothing divides by less

}  // namespace

AirFlow airFlow(float scaling_speed_mps, float airspeed_mps, float lowest_flying_mps) {
    const float inverse = 1.0f / core::limit(airspeed_mps, kSlowest_mps, 200.0f);
    return {core::limit(scaling_speed_mps * inverse, 0.5f, 2.0f), inverse,
            airspeed_mps < lowest_flying_mps};
}

AxisGains axisGains(const AxisSettings& settings) {
    const float time_constant_s = core::limit(settings.time_constant_s, 0.1f, 10.0f);
    const float integral = settings.i * time_constant_s;
    const float feed_forward = (settings.p - integral) * time_constant_s - settings.d;
    return {1.0f / time_constant_s, feed_forward > 0 ? feed_forward * kFullPerRadian : 0.0f,
            settings.d * kFullPerRadian, integral * kFullPerRadian};
}

float axisDeflection(const AxisGains& gains, int16_t integrator_max_cd, AxisState& state,
                     const AirFlow& air, float rate_demand_rads, float rate_rads, float dt_s) {
    const float error_rads = (rate_demand_rads - rate_rads) * air.speed_scale;
    if (gains.integral <= 0) {
        state.integrator = 0;
    } else if (!air.too_slow) {
        const float step = error_rads * gains.integral * air.speed_scale * dt_s;
        const bool winds_up =
            (state.last_output > 1 && step > 0) || (state.last_output < -1 && step < 0);
        const float limit = integrator_max_cd * kFullPerCentidegree;
        if (!winds_up) state.integrator = core::limit(state.integrator + step, -limit, limit);
    }
    const float direct = gains.damping * error_rads + gains.feed_forward * rate_demand_rads;
    state.last_output = direct * air.speed_scale + state.integrator;
    return core::limit(state.last_output, -1.0f, 1.0f);
}

}  // namespace control

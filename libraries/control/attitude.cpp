// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/attitude.hpp"

#include "core/maths.hpp"

namespace control {
namespace {

constexpr float kSteepest_cos = 0.17f;  // 80 degrees: beyond, the turn's rate is not a turn's
constexpr float kYawHighPass_rads = 0.2f;
constexpr float kSlipPerAccel = 0.01f;  // deflection for a m/s2 at SLIP 1, INT 1

float limited_rads(float rate_rads, int16_t up_dps, int16_t down_dps) {
    if (up_dps > 0 && rate_rads > core::radians(up_dps)) return core::radians(up_dps);
    if (down_dps > 0 && rate_rads < -core::radians(down_dps)) return -core::radians(down_dps);
    return rate_rads;
}

}  // namespace

float rollDeflection(const RollSettings& settings, const AxisGains& gains, AxisState& state,
                     const AirFlow& air, float error_rad, float rate_rads, float dt_s) {
    const float demand_rads = limited_rads(error_rad * gains.rate_per_error, settings.rate_max_dps,
                                           settings.rate_max_dps);
    return axisDeflection(gains, settings.axis.integrator_max_cd, state, air, demand_rads,
                          rate_rads, dt_s);
}

TurnRates turnRates(const AirFlow& air, float sin_roll, float cos_roll, float cos_pitch) {
    // g / V * tan(bank) about the vertical, sin(bank) of it about the wing
    const float yaw_rads = core::kGravity_mss * air.inverse_airspeed_spm * cos_pitch * sin_roll;
    // inverted the nose must not be pulled through
    if (cos_roll <= 0) return {0, yaw_rads};
    return {yaw_rads * sin_roll / core::limit(cos_roll, kSteepest_cos, 1.0f), yaw_rads};
}

float pitchDeflection(const PitchSettings& settings, const AxisGains& gains, AxisState& state,
                      const AirFlow& air, const TurnRates& turn, float error_rad, float rate_rads,
                      float dt_s) {
    const float demand_rads = limited_rads(error_rad * gains.rate_per_error,
                                           settings.rate_max_up_dps, settings.rate_max_down_dps) +
                              settings.turn_compensation * turn.pitch_rads;
    return axisDeflection(gains, settings.axis.integrator_max_cd, state, air, demand_rads,
                          rate_rads, dt_s);
}

float yawDeflection(const YawSettings& settings, YawState& state, const AirFlow& air,
                    const TurnRates& turn, float rate_rads, float lateral_accel_mss, float dt_s) {
    if (settings.damping <= 0 && settings.slip <= 0 && settings.integral <= 0) return 0;
    const float error_rads = turn.yaw_rads * settings.coordination - rate_rads;
    // high pass: what stays is the turn's or the gyro's, not to be damped
    state.high_passed_rads += error_rads - state.last_error_rads;
    state.high_passed_rads -= state.high_passed_rads * kYawHighPass_rads * dt_s;
    state.last_error_rads = error_rads;

    // air that pushes to the right comes from the left: the nose goes to meet it
    const float slip = lateral_accel_mss * settings.slip * kSlipPerAccel;
    if (settings.integral <= 0) {
        state.integrator = 0;
    } else if (!air.too_slow) {
        const float limit = settings.integrator_max_cd / 4500.0f;
        const float step =
            (state.high_passed_rads - lateral_accel_mss * kSlipPerAccel) * settings.integral;
        state.integrator = core::limit(state.integrator + step * dt_s, -limit, limit);
    }
    const float output =
        (state.high_passed_rads * settings.damping - slip) * core::square(air.speed_scale) +
        state.integrator;
    return core::limit(output, -1.0f, 1.0f);
}

}  // namespace control

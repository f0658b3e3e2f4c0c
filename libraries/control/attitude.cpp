// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/attitude.hpp"

#include "core/maths.hpp"

namespace control {
namespace {

float limitedRate_rads(float error_rad, float time_constant_s, int16_t up_dps, int16_t down_dps) {
    float rate_rads = error_rad / core::limit(time_constant_s, 0.1f, 10.0f);
    if (up_dps > 0 && rate_rads > core::radians(up_dps)) rate_rads = core::radians(up_dps);
    if (down_dps > 0 && rate_rads < -core::radians(down_dps)) rate_rads = -core::radians(down_dps);
    return rate_rads;
}

constexpr float kSteepest_cos = 0.17f;  // 80 degrees: beyond, the turn's rate is not a turn's
constexpr float kYawHighPass_rads = 0.2f;
constexpr float kSlipPerAccel = 0.01f;  // deflection for a m/s2 at SLIP 1, INT 1

}  // namespace

float rollDeflection(const RollSettings& settings, AxisState& state, const AirFlow& air,
                     float error_rad, float rate_rads) {
    const float demand_rads = limitedRate_rads(error_rad, settings.axis.time_constant_s,
                                               settings.rate_max_dps, settings.rate_max_dps);
    return axisDeflection(settings.axis, state, air, demand_rads, rate_rads);
}

float pitchDeflection(const PitchSettings& settings, AxisState& state, const AirFlow& air,
                      const Bank& bank, float error_rad, float rate_rads) {
    float demand_rads = limitedRate_rads(error_rad, settings.axis.time_constant_s,
                                         settings.rate_max_up_dps, settings.rate_max_down_dps);
    // inverted the nose must not be pulled through
    if (bank.cos_roll > 0) {
        const float cos_roll = core::limit(bank.cos_roll, kSteepest_cos, 1.0f);
        // coordinated turn: g / V * tan(bank) about the vertical, sin(bank) of it about the wing
        demand_rads += settings.turn_compensation * bank.cos_pitch * core::kGravity_mss *
                       air.inverse_airspeed_spm * core::square(bank.sin_roll) / cos_roll;
    }
    return axisDeflection(settings.axis, state, air, demand_rads, rate_rads);
}

float yawDeflection(const YawSettings& settings, YawState& state, const AirFlow& air,
                    const Bank& bank, float rate_rads, float lateral_accel_mss) {
    const float turn_rads =
        core::kGravity_mss * air.inverse_airspeed_spm * bank.sin_roll * settings.coordination;
    const float error_rads = turn_rads - rate_rads;
    // high pass: what stays is the turn's or the gyro's, not to be damped
    state.high_passed_rads += error_rads - state.last_error_rads;
    state.high_passed_rads -= state.high_passed_rads * kYawHighPass_rads * air.dt_s;
    state.last_error_rads = error_rads;

    // a push to the right felt in the seat is slip to the right: the nose follows it
    const float slip = lateral_accel_mss * settings.slip * kSlipPerAccel;
    if (settings.integral <= 0) {
        state.integrator = 0;
    } else if (!air.too_slow) {
        const float limit = settings.integrator_max_cd / 4500.0f;
        const float step =
            (state.high_passed_rads + lateral_accel_mss * kSlipPerAccel) * settings.integral;
        state.integrator = core::limit(state.integrator + step * air.dt_s, -limit, limit);
    }
    const float output =
        (state.high_passed_rads * settings.damping - slip) * core::square(air.speed_scale) +
        state.integrator;
    return core::limit(output, -1.0f, 1.0f);
}

}  // namespace control

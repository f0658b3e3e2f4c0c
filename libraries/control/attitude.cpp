// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/attitude.hpp"

#include "core/maths.hpp"

namespace control {
namespace {

constexpr float kSteepest_cos = 0.17f;  // 80 degrees: beyond, the turn's rate is not a turn's
constexpr float kYawHighPass_rads = 0.2f;
constexpr float kSlipPerAccel = 0.01f;  // deflection for a m/s2 at SLIP 1, INT 1

}  // namespace

core::Ratio rollDeflection(const AxisGains& gains, AxisState& state, const AirFlow& air,
                           core::Angle error_rad, core::BodyRate rate_rads, uint8_t periods) {
    return axisDeflection(gains, state, air, demandedRate_rads(gains, error_rad), rate_rads,
                          periods);
}

TurnRates turnRates(const AirFlow& air, float sin_roll, float cos_roll, float cos_pitch) {
    // g / V * tan(bank) about the vertical, sin(bank) of it about the wing
    const float yaw_rads = core::kGravity_mss * air.inverse_airspeed_spm * cos_pitch * sin_roll;
    // inverted the nose must not be pulled through
    if (cos_roll <= 0) return {core::BodyRate::fromRaw(0), yaw_rads};
    const float steep_cos = core::limit(cos_roll, kSteepest_cos, 1.0f);
    return {core::BodyRate(yaw_rads * sin_roll / steep_cos), yaw_rads};
}

core::Ratio pitchDeflection(const AxisGains& gains, AxisState& state, const AirFlow& air,
                            const TurnRates& turn, core::Angle error_rad, core::BodyRate rate_rads,
                            uint8_t periods) {
    const int16_t held = core::times12(gains.turn_compensation.raw, turn.pitch_rads.raw);
    const auto demand_rads =
        core::BodyRate::fromRaw(int32_t{demandedRate_rads(gains, error_rad).raw} + held);
    return axisDeflection(gains, state, air, demand_rads, rate_rads, periods);
}

bool yawUsed(const YawSettings& settings) {
    return settings.damping > 0 || settings.slip > 0 || settings.integral > 0;
}

float yawDeflection(const YawSettings& settings, YawState& state, const AirFlow& air,
                    const TurnRates& turn, float rate_rads, float lateral_accel_mss, float dt_s) {
    if (!yawUsed(settings)) return 0;
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
    const float output = (state.high_passed_rads * settings.damping - slip) *
                             core::square(air.speed_scale.toFloat()) +
                         state.integrator;
    return core::limit(output, -1.0f, 1.0f);
}

}  // namespace control

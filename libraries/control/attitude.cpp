// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/attitude.hpp"

#include "core/maths.hpp"

namespace control {
namespace {

constexpr float kSteepest_cos = 0.17f;  // 80 degrees: beyond, the turn's rate is not a turn's
constexpr float kYawHighPass_rads = 0.2f, kPeriod_s = 0.005f;
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
    if (cos_roll <= 0) return {core::BodyRate::fromRaw(0), core::BodyRate(yaw_rads)};
    const float steep_cos = core::limit(cos_roll, kSteepest_cos, 1.0f);
    return {core::BodyRate(yaw_rads * sin_roll / steep_cos), core::BodyRate(yaw_rads)};
}

core::Ratio pitchDeflection(const AxisGains& gains, AxisState& state, const AirFlow& air,
                            const TurnRates& turn, core::Angle error_rad, core::BodyRate rate_rads,
                            uint8_t periods) {
    const int16_t held = core::times12(gains.turn_compensation.raw, turn.pitch_rads.raw);
    const auto demand_rads =
        core::BodyRate::fromRaw(int32_t{demandedRate_rads(gains, error_rad).raw} + held);
    return axisDeflection(gains, state, air, demand_rads, rate_rads, periods);
}

YawGains yawGains(const YawSettings& settings) {
    return {core::Gain(settings.damping), core::Gain(settings.coordination), settings.slip,
            settings.integral, core::real(settings.integrator_max_cd) * (1.0f / 4500)};
}

namespace {

// High pass: what stays is the turn's or the gyro's, not to be damped.
core::BodyRate swing_rads(const YawGains& gains, YawState& state, const TurnRates& turn,
                          core::BodyRate rate_rads, uint8_t periods) {
    constexpr int16_t kLeak = static_cast<int16_t>(65536 * kYawHighPass_rads * kPeriod_s + 0.5f);
    constexpr uint8_t kFiner = 8;  // than a BodyRate: a shift by whole bytes
    const auto error_rads = core::BodyRate::fromRaw(
        int32_t{core::times12(gains.coordination.raw, turn.yaw_rads.raw)} - rate_rads.raw);
    int32_t& swing = state.high_passed_rads.raw;
    swing += (int32_t{error_rads.raw} - state.last_error_rads.raw) * (1L << kFiner);
    // which rounds down; the smallest swing, too, shall end
    swing -= core::times16(swing, static_cast<int16_t>(kLeak * periods)) + (swing > 0 ? 1 : 0);
    state.last_error_rads = error_rads;
    // 8 rad/s: times 2 twice, which is the most that a speed asks for, it still fits
    constexpr int32_t kMaxSwing = 8 * core::BodyRate::kOne - 1;
    return core::BodyRate::fromRaw(core::limit(swing >> kFiner, -kMaxSwing, kMaxSwing));
}

// Air that pushes to the right comes from the left: the nose goes to meet it.
float againstSlip(const YawGains& gains, YawState& state, const AirFlow& air, float swing_rads,
                  float lateral_mss, float dt_s) {
    if (gains.integral <= 0) {
        state.integrator = 0;
    } else if (!air.integrators_rest) {
        const float step = (swing_rads - lateral_mss * kSlipPerAccel) * gains.integral;
        state.integrator = core::limit(state.integrator + step * dt_s, -gains.integrator_max,
                                       gains.integrator_max);
    }
    const float slip = lateral_mss * gains.slip * kSlipPerAccel;
    return state.integrator - slip * core::square(air.speed_scale.toFloat());
}

}  // namespace

core::Ratio yawDeflection(const YawGains& gains, YawState& state, const AirFlow& air,
                          const TurnRates& turn, core::BodyRate rate_rads,
                          core::Acceleration lateral_mss, uint8_t periods) {
    constexpr uint8_t kGainBits = 8;  // a Gain times a BodyRate has so many more than a Ratio
    const core::BodyRate swing = swing_rads(gains, state, turn, rate_rads, periods);
    const int16_t scale = air.speed_scale.raw;
    const int16_t effective = core::times14(core::times14(swing.raw, scale), scale);
    int32_t output = core::product(gains.damping.raw, effective) >> kGainBits;
    if (gains.slip > 0 || gains.integral > 0)
        output += core::Ratio(againstSlip(gains, state, air, swing.toFloat(), lateral_mss.toFloat(),
                                          periods * kPeriod_s))
                      .raw;
    constexpr int32_t kFull = core::Ratio::kOne;
    return core::Ratio::fromRaw(core::limit(output, -kFull, kFull));
}

}  // namespace control

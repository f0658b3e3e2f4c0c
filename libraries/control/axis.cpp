// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/axis.hpp"

#include "core/maths.hpp"

namespace control {
namespace {

// Gains are degrees of surface for degrees of angle, and 45 degrees are all of a surface.
constexpr float kFullPerRadian = 4.0f / core::kPi;
constexpr float kFullPerCentidegree = 1.0f / 4500.0f;
constexpr float kTwoPeriods_s = 0.01f;
constexpr float kSlowest_mps = 3.0f;  // nothing divides by less

constexpr core::BodyRate kMaxRate_rads(15.5f);  // twice as much fills 16 bits
using Direct = core::Fixed32<22>;               // a Gain times a BodyRate
constexpr int32_t kMaxDirect = 4 * Direct::kOne;
constexpr int32_t kFull = AxisState::Output::kOne;

core::BodyRate limit_rads(int16_t dps) {
    return core::BodyRate(dps > 0 ? core::radians(core::real(dps)) : kMaxRate_rads.toFloat());
}

AxisGains axisGains(const AxisSettings& settings) {
    const float time_constant_s = core::limit(settings.time_constant_s, 0.1f, 10.0f);
    const float integral = settings.i * time_constant_s;
    const float feed_forward = (settings.p - integral) * time_constant_s - settings.d;
    AxisGains gains;
    using Factor = decltype(gains.rate_per_error);
    constexpr float kFactor = core::BodyRate::kSteps / core::Angle::kSteps * Factor::kSteps;
    gains.rate_per_error.raw = static_cast<int16_t>(kFactor / time_constant_s);
    gains.turn_compensation = core::Gain::fromRaw(0);
    gains.feed_forward =
        core::Gain(core::isPositive(feed_forward) ? feed_forward * kFullPerRadian : 0.0f);
    gains.damping = core::Gain(settings.d * kFullPerRadian);
    gains.integral = decltype(gains.integral)(integral * (kFullPerRadian * kTwoPeriods_s));
    gains.integrator_max = core::Ratio(
        core::limit(core::real(settings.integrator_max_cd) * kFullPerCentidegree, 0.0f, 1.0f));
    return gains;
}

// By the rate's error at the scaling speed.
void integrate(const AxisGains& gains, AxisState& state, const AirFlow& air,
               core::BodyRate error_rads, uint8_t periods) {
    int32_t step =
        core::product(error_rads.raw, core::times14(gains.integral.raw, air.speed_scale.raw));
    if (periods != 2) step = step / 8 * core::limit<uint8_t>(periods, 0, 8) * 4;
    const int32_t last = state.last_output.raw;
    if ((last > kFull && step > 0) || (last < -kFull && step < 0)) return;  // it would wind up
    constexpr int32_t kSteps = decltype(state.integrator)::kOne / core::Ratio::kOne;
    const int32_t most = gains.integrator_max.raw * kSteps;
    state.integrator.raw = core::limit(state.integrator.raw + step, -most, most);
}

}  // namespace

AirFlow airFlow(float scaling_speed_mps, float airspeed_mps, bool integrators_rest) {
    const float inverse = core::inverse(core::limit(airspeed_mps, kSlowest_mps, 200.0f));
    return {core::Ratio(core::limit(scaling_speed_mps * inverse, 0.5f, 2.0f)), inverse,
            integrators_rest};
}

AxisGains rollGains(const RollSettings& settings) {
    AxisGains gains = axisGains(settings.axis);
    gains.most_up_rads = gains.most_down_rads = limit_rads(settings.rate_max_dps);
    return gains;
}

AxisGains pitchGains(const PitchSettings& settings) {
    AxisGains gains = axisGains(settings.axis);
    gains.most_up_rads = limit_rads(settings.rate_max_up_dps);
    gains.most_down_rads = limit_rads(settings.rate_max_down_dps);
    gains.turn_compensation = core::Gain(settings.turn_compensation);
    return gains;
}

void weaken(AxisGains& gains) {
    constexpr core::Ratio kLeft(kWeakened);
    gains.feed_forward.raw = core::times14(gains.feed_forward.raw, kLeft.raw);
    gains.damping.raw = core::times14(gains.damping.raw, kLeft.raw);
    gains.integral.raw = core::times14(gains.integral.raw, kLeft.raw);
}

core::BodyRate fastestRate_rads(const AxisGains& gains, const AirFlow& air, int16_t rate_max_dps) {
    constexpr float kMaxShare = 0.95f;      // of the surface
    constexpr float kSlowest_rads = 0.35f;  // fast enough for AUTOTUNE to measure
    const float fastest_rads = limit_rads(rate_max_dps).toFloat();
    const float surface_s = gains.feed_forward.toFloat() * air.speed_scale.toFloat();
    if (surface_s * fastest_rads <= kMaxShare) return core::BodyRate(fastest_rads);
    return core::BodyRate(core::limit(kMaxShare / surface_s, kSlowest_rads, fastest_rads));
}

core::BodyRate demandedRate_rads(const AxisGains& gains, core::Angle error_rad) {
    const int16_t rate = core::upper(2 * core::product(error_rad.raw, gains.rate_per_error.raw));
    return core::BodyRate::fromRaw(
        core::limit<int16_t>(rate, -gains.most_down_rads.raw, gains.most_up_rads.raw));
}

core::Ratio axisDeflection(const AxisGains& gains, AxisState& state, const AirFlow& air,
                           core::BodyRate demand_rads, core::BodyRate rate_rads, uint8_t periods) {
    const int16_t scale = air.speed_scale.raw;
    const int16_t demand =
        core::limit<int16_t>(demand_rads.raw, -kMaxRate_rads.raw, kMaxRate_rads.raw);
    const int16_t error = static_cast<int16_t>(core::limit<int32_t>(
        int32_t{demand} - rate_rads.raw, -kMaxRate_rads.raw, kMaxRate_rads.raw));
    core::BodyRate felt_rads;
    felt_rads.raw = core::times14(error, scale);
    if (gains.integral.raw <= 0) {
        state.integrator = {};
    } else if (!air.integrators_rest) {
        integrate(gains, state, air, felt_rads, periods);
    }
    const int32_t direct = core::product(gains.damping.raw, felt_rads.raw) +
                           core::product(gains.feed_forward.raw, demand);
    state.last_output.raw = core::times16(core::limit(direct, -kMaxDirect, kMaxDirect), scale) +
                            state.integrator.as<20>().raw;
    return core::Ratio::fromRaw((core::limit(state.last_output.raw, -kFull, kFull) + 32) >> 6);
}

}  // namespace control

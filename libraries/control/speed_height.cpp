// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/speed_height.hpp"

#include <math.h>

#include "control/slew.hpp"
#include "core/maths.hpp"

namespace control {
namespace {

// The height demand is flown as a trajectory: it closes on the target in 1 / kApproach_hz and
// turns with kHeightAccel_mss, which a trainer follows without losing speed in the pull-up.
constexpr float kApproach_hz = 1.0f;
constexpr float kHeightAccel_mss = 2.0f;
constexpr float kPitchLead_s = 0.45f;      // from pitch demand to flight path: half a second
constexpr float kSpeedDemandShare = 0.5f;  // of all energy, for a change of speed
constexpr float kLowestSpeed_mps = 3.0f;   // nothing divides by less
constexpr float kUnderspeed = 0.9f;        // of ARSPD_FBW_MIN
constexpr float kRecovered = 1.05f;
// Near the ground a lull of a gust costs height that is not there: the throttle opens earlier.
constexpr float kEarlierInApproach = 1.06f;
constexpr float kLoadFactorSpeed = 0.19f;  // stall speed grows by 19 % at 45 degrees of bank
constexpr float kFlareIntegral_hz = 1.0f;  // of the sink's error over the speed
// From no lift to the stall wings turn by some 0.25 rad, whatever the airplane: at the lowest
// speed, 1.2 times the stall's, 1 / 1.44 of it carries the weight.
constexpr float kLowestSpeedAlpha_rad = 0.2f;
constexpr float kMaxLift = 2.0f;  // of that
constexpr float kFastestPitchRate_rads = 1.0f;
constexpr float kGlideShare =
    0.25f;  // of what a descent spares, taken where the speed is not known
constexpr float kSmallestPitch_rad = 0.05f;  // nothing divides by less

// Speed at which a distance may be closed: linear near the end, along a braking parabola before.
float closingSpeed(float distance_m) {
    constexpr float kLinear_m = kHeightAccel_mss / (kApproach_hz * kApproach_hz);
    const float size_m = fabsf(distance_m);
    if (size_m <= kLinear_m) return distance_m * kApproach_hz;
    const float speed_mps = sqrtf(2 * kHeightAccel_mss * (size_m - kLinear_m / 2));
    return core::isNegative(distance_m) ? -speed_mps : speed_mps;
}

}  // namespace

void SpeedHeight::start(const SpeedHeightMeasured& now, float pitch_rad, float throttle) {
    height_m_ = now.height_m;
    climb_mps_ = now.climb_mps;
    climb_rate_mss_ = 0;
    speed_mps_ = core::limit(now.airspeed_mps, kLowestSpeed_mps, 100.0f);
    speed_demand_mps_ = speed_mps_;
    speed_demand_rate_mss_ = speed_bias_mss_ = speed_rate_mss_ = 0;
    pitch_rad_ = pitch_rad;
    pitch_integral_rad_ = core::limit(pitch_rad - now.climb_mps / speed_mps_, -0.2f, 0.2f);
    throttle_ = throttle;
    throttle_integral_ = 0;
    underspeed_ = flaring_ = false;
}

// Airspeed and its rate from the noisy sensor and the accelerometer; the loop between them also
// learns what the accelerometer is off by. Not inlined: its variables would lie in a stack frame
// beyond what an instruction reaches.
__attribute__((noinline)) void SpeedHeight::filterSpeed(const SpeedHeightSettings& settings,
                                                        const SpeedHeightMeasured& now,
                                                        float dt_s) {
    const float omega = settings.speed_omega_rads;
    const float error_mps = now.airspeed_mps - speed_mps_;
    speed_bias_mss_ += error_mps * core::square(omega) * 0.1f * dt_s;
    speed_bias_mss_ = core::limit(speed_bias_mss_, -3.0f, 3.0f);
    const float rate_mss = now.acceleration_mss + speed_bias_mss_;
    speed_mps_ += (rate_mss + error_mps * omega) * dt_s;
    speed_mps_ = core::limit(speed_mps_, kLowestSpeed_mps, 100.0f);
    speed_rate_mss_ =
        core::lerp(speed_rate_mss_, rate_mss, core::limit(2 * omega * dt_s, 0.0f, 1.0f));
}

void SpeedHeight::shapeHeight(const SpeedHeightSettings& settings, const SpeedHeightDemand& demand,
                              const Step& step) {
    const float wanted_mps =
        core::limit(demand.climb_mps + closingSpeed(demand.height_m - height_m_),
                    -settings.sink_max_mps, settings.climb_max_mps);
    const float before_mps = climb_mps_;
    climb_mps_ = slewed(climb_mps_, wanted_mps, kHeightAccel_mss * step.dt_s);
    climb_rate_mss_ = (climb_mps_ - before_mps) * step.rate_hz;
    height_m_ += climb_mps_ * step.dt_s;
}

void SpeedHeight::shapeSpeed(const SpeedHeightSettings& settings, const SpeedHeightLimits& limits,
                             float demand_mps, const Step& step) {
    const float wanted_mps =
        core::limit(demand_mps, limits.airspeed_min_mps, limits.airspeed_max_mps);
    const bool faster = wanted_mps > speed_demand_mps_;
    const float energy_mps = faster ? settings.climb_max_mps : settings.sink_min_mps;
    const float rate_mss =
        kSpeedDemandShare * core::kGravity_mss * energy_mps * step.inverse_speed_spm;
    const float before_mps = speed_demand_mps_;
    speed_demand_mps_ = slewed(speed_demand_mps_, wanted_mps, rate_mss * step.dt_s);
    speed_demand_rate_mss_ = (speed_demand_mps_ - before_mps) * step.rate_hz;
}

void SpeedHeight::watchUnderspeed(const SpeedHeightLimits& limits, Phase phase,
                                  bool airspeed_known) {
    if (phase == Phase::climb_out || phase == Phase::flare || !airspeed_known)
        underspeed_ = false;
    else if (speed_mps_ < limits.airspeed_min_mps * kUnderspeed &&
             throttle_ >= limits.throttle_max * 0.95f)
        underspeed_ = true;
    else if (speed_mps_ > limits.airspeed_min_mps * kRecovered)
        underspeed_ = false;
}

// 0 at the lowest speed and above, 1 at underspeed: the share in which height is given up for speed
// and the throttle opened.
float SpeedHeight::underspeedFraction(const SpeedHeightLimits& limits, bool airspeed_known,
                                      Phase phase) const {
    if (!airspeed_known || phase == Phase::flare) return 0;
    const float earlier = phase == Phase::approach ? kEarlierInApproach : 1.0f;
    const float short_mps = limits.airspeed_min_mps * earlier - speed_mps_;
    if (!core::isPositive(short_mps)) return 0;
    return core::limit(short_mps / (limits.airspeed_min_mps * (1 - kUnderspeed)), 0.0f, 1.0f);
}

SpeedHeight::Errors SpeedHeight::errors(const SpeedHeightMeasured& now) const {
    Errors errors;
    errors.potential_m = height_m_ - now.height_m;
    errors.potential_mps = climb_mps_ - now.climb_mps;
    if (!now.airspeed_known) {
        errors.kinetic_m = errors.kinetic_mps = 0;
        return errors;
    }
    errors.kinetic_m =
        (core::square(speed_demand_mps_) - core::square(speed_mps_)) * (0.5f / core::kGravity_mss);
    errors.kinetic_mps =
        (speed_demand_mps_ * speed_demand_rate_mss_ - speed_mps_ * speed_rate_mss_) *
        (1.0f / core::kGravity_mss);
    return errors;
}

// Where no sensor measures the speed the angle of attack does: the slower, the more of it holds the
// path. The throttle opens with the pitch, all of it at the highest, and hardly closes below level.
float SpeedHeight::throttleForPitch(const SpeedHeightLimits& limits) const {
    const float cruise = limits.throttle_cruise;
    if (core::isPositive(pitch_rad_)) {
        const float most_rad = core::limit(limits.pitch_max_rad, kSmallestPitch_rad, 1.6f);
        return cruise +
               (limits.throttle_max - cruise) * core::limit(pitch_rad_ / most_rad, 0.0f, 1.0f);
    }
    const float least_rad = core::limit(limits.pitch_min_rad, -1.6f, -kSmallestPitch_rad);
    return cruise +
           (limits.throttle_min - cruise) * core::limit(pitch_rad_ / least_rad, 0.0f, 1.0f);
}

float SpeedHeight::throttle(const SpeedHeightSettings& settings, const SpeedHeightLimits& limits,
                            const SpeedHeightMeasured& now, const Errors& errors, float turn,
                            const Step& step) {
    // a turn costs induced drag: RLL2THR times 1/cos2(bank) - 1
    const float turn_mps = settings.roll_to_throttle * turn * (1.0f / core::kGravity_mss);
    if (!now.airspeed_known) {
        throttle_integral_ = 0;
        const float spare = limits.throttle_max - limits.throttle_cruise;
        const float sink_mps = core::limit(-climb_mps_, 0.0f, settings.sink_max_mps);
        return throttleForPitch(limits) + turn_mps / settings.climb_max_mps * spare -
               kGlideShare * sink_mps / settings.sink_min_mps * limits.throttle_cruise;
    }
    const float demand_mps =
        climb_mps_ + turn_mps +
        speed_demand_mps_ * speed_demand_rate_mss_ * (1.0f / core::kGravity_mss);
    const float feed_forward =
        limits.throttle_cruise +
        (core::isPositive(demand_mps)
             ? demand_mps / settings.climb_max_mps * (limits.throttle_max - limits.throttle_cruise)
             : demand_mps / settings.sink_min_mps * limits.throttle_cruise);
    const float per_mps = limits.throttle_max / (settings.climb_max_mps + settings.sink_min_mps);
    const float per_m = per_mps * step.inverse_time_constant_hz;
    const float energy_m = errors.potential_m + errors.kinetic_m;
    const float energy_mps = errors.potential_mps + errors.kinetic_mps;
    const float direct =
        feed_forward + energy_m * per_m + energy_mps * per_mps * settings.throttle_damping;
    const float gain = energy_m * per_m * settings.integral_gain * step.dt_s;
    const float wanted = direct + throttle_integral_;
    const float beyond = wanted - core::limit(wanted, limits.throttle_min, limits.throttle_max);
    const bool winds_up = core::isPositive(beyond * gain);
    if (!winds_up)
        throttle_integral_ =
            core::limit(throttle_integral_ + gain, -limits.throttle_max, limits.throttle_max);
    return direct + throttle_integral_;
}

// Without a step in the pitch.
void SpeedHeight::beginOrEndFlare(bool flares, float lift_rad) {
    if (flares == flaring_) return;
    flaring_ = flares;
    pitch_integral_rad_ += flares ? -lift_rad : lift_rad;
}

float SpeedHeight::pitch(const SpeedHeightSettings& settings, const SpeedHeightLimits& limits,
                         const Errors& errors, float speed_weight, float lift_rad,
                         const Step& step) {
    const float height_weight = 2.0f - speed_weight;
    const float inverse_speed = step.inverse_speed_spm;
    const float per_m = inverse_speed * step.inverse_time_constant_hz;
    const float balance_m = height_weight * errors.potential_m - speed_weight * errors.kinetic_m;
    const float balance_mps =
        height_weight * errors.potential_mps - speed_weight * errors.kinetic_mps;

    float demand_rad = pitch_integral_rad_ + balance_m * per_m +
                       balance_mps * inverse_speed * settings.pitch_damping;
    if (flaring_) demand_rad += lift_rad;
    if (core::isPositive(height_weight))
        demand_rad += (climb_mps_ + climb_rate_mss_ * kPitchLead_s) * inverse_speed;
    const float limited_rad = core::limit(demand_rad, limits.pitch_min_rad, limits.pitch_max_rad);
    // in the flare the sink alone counts: the height is wrong by more than what is left of it
    const float rate_rads = flaring_ ? errors.potential_mps * inverse_speed * kFlareIntegral_hz
                                     : balance_m * per_m * settings.integral_gain;
    const float step_rad = rate_rads * step.dt_s;
    const bool winds_up = core::isPositive((demand_rad - limited_rad) * step_rad);
    if (!winds_up) pitch_integral_rad_ = core::limit(pitch_integral_rad_ + step_rad, -0.35f, 0.35f);

    const float fastest_rads =
        core::limit(settings.vertical_accel_mss * inverse_speed, 0.0f, kFastestPitchRate_rads);
    return slewed(pitch_rad_, limited_rad, fastest_rads * step.dt_s);
}

SpeedHeightOutput SpeedHeight::run(const SpeedHeightSettings& settings,
                                   const SpeedHeightLimits& limits, const SpeedHeightDemand& demand,
                                   const SpeedHeightMeasured& now, Phase phase, float dt_s) {
    if (now.airspeed_known)
        filterSpeed(settings, now, dt_s);
    else
        speed_mps_ = core::limit(now.airspeed_mps, kLowestSpeed_mps, 100.0f);
    watchUnderspeed(limits, phase, now.airspeed_known);
    const bool lands = phase == Phase::approach || phase == Phase::flare;
    const float time_constant_s = lands ? settings.land_time_constant_s : settings.time_constant_s;
    const Step step = {dt_s, core::inverse(dt_s), core::inverse(speed_mps_),
                       core::inverse(time_constant_s)};

    const bool height_given_up = phase == Phase::climb_out || underspeed_;
    if (height_given_up) {
        height_m_ = now.height_m;
        climb_mps_ = now.climb_mps;
        climb_rate_mss_ = 0;
    } else if (phase == Phase::flare) {
        height_m_ = now.height_m;
        climb_mps_ = demand.climb_mps;
        climb_rate_mss_ = 0;
    } else {
        shapeHeight(settings, demand, step);
    }
    const float cos2 = core::limit(core::square(now.cos_roll), 0.1f, 1.0f);
    const float turn = 1.0f / cos2 - 1.0f;
    SpeedHeightLimits turning = limits;
    turning.airspeed_min_mps *= 1.0f + kLoadFactorSpeed * core::limit(turn, 0.0f, 2.0f);
    // one that has just been thrown is not too fast: its nose would be raised until it stalls
    speed_demand_mps_ = fmaxf(speed_demand_mps_, limits.airspeed_min_mps);
    shapeSpeed(settings, turning, demand.airspeed_mps, step);

    const float speedPriority =
        height_given_up ? 1.0f : underspeedFraction(turning, now.airspeed_known, phase);
    float speed_weight =
        phase == Phase::approach ? 0.0f : core::limit(settings.speed_weight, 0.0f, 2.0f);
    // near the ground even the stall is met with power first
    const float most_weight = phase == Phase::approach ? 1.0f : 2.0f;
    if (!now.airspeed_known || phase == Phase::flare)
        speed_weight = 0;
    else if (speed_weight < most_weight)
        speed_weight = core::lerp(speed_weight, most_weight, speedPriority);

    const Errors errors = this->errors(now);
    float wanted = throttle(settings, limits, now, errors, turn, step);
    wanted = core::lerp(wanted, limits.throttle_max, speedPriority);
    wanted = core::limit(wanted, limits.throttle_min, limits.throttle_max);
    if (phase == Phase::flare) wanted = limits.throttle_max;
    throttle_ = slewed(throttle_, wanted, limits.throttle_slew * dt_s);
    const bool flares = phase == Phase::flare;
    float lift_rad = 0;
    if (flares || flaring_)  // nowhere else is it needed
        lift_rad = kLowestSpeedAlpha_rad *
                   core::limit(core::square(limits.airspeed_min_mps * step.inverse_speed_spm), 0.0f,
                               kMaxLift);
    beginOrEndFlare(flares, lift_rad);
    pitch_rad_ = pitch(settings, limits, errors, speed_weight, lift_rad, step);
    return {pitch_rad_, throttle_};
}

}  // namespace control

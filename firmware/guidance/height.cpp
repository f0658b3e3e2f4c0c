// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/height.hpp"

#include <math.h>

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/control/attitude_demand.hpp"
#include "firmware/guidance/flights.hpp"
#include "firmware/state/causes.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

using namespace state;
using namespace control;

namespace {

constexpr float kPeriod_s = 0.1f;  // 10 Hz
constexpr float kFlyingSpeed_mps = 5;
// No more angle of attack near the ground, nor anywhere without a sensor for the speed.
constexpr float kMaxAlpha_rad = 0.2f;
constexpr float kNudgedDown = 0.3f;  // of the cruise throttle, which still flies

struct HeightControl {
    ::control::SpeedHeight speed_height;
    core::Angle level_pitch_rad;  // of flight that neither climbs nor sinks, learnt in ten seconds
};
core::FileState<HeightControl> height_control{};

// Until the wind is known the estimate is the ground speed, which in a headwind is no airspeed: no
// airplane in the air flies slower than its lowest.
float airspeed_mps() {
    const float least_mps = vehicle.airspeed.healthy ? 3.0f : speedMin_mps();
    return core::limit(vehicle.estimate.airspeed_mps, least_mps, 100.0f);
}

float pathAngle_rad() {
    return core::limit(vehicle.estimate.climb_mps / airspeed_mps(), -0.8f, 0.8f);
}

// Of the bank, counted from upside down where that is flown.
float cosRoll() {
    const float cosine = vehicle.attitude.cos_roll.toFloat();
    return vehicle.inverted ? -cosine : cosine;
}

// Along the path, from what the accelerometer measures: lift acts across the path, so only the
// angle of attack's share of it is left, and gravity's.
float pathAcceleration_mss() {
    const auto& attitude = vehicle.attitude;
    const float path_rad = pathAngle_rad();
    const float cosine = core::limit(cosRoll(), 0.3f, 1.0f);
    float alpha_rad = core::limit((attitude.pitch_rad.toFloat() - path_rad) / cosine, -0.3f, 0.3f);
    if (vehicle.inverted) alpha_rad = -alpha_rad;
    const auto& accel_mss = vehicle.imu.accel_mss;
    return accel_mss.x.toFloat() + accel_mss.z.toFloat() * alpha_rad -
           core::kGravity_mss * path_rad;
}

::control::SpeedHeightMeasured measured() {
    const auto& estimate = core::based(vehicle.estimate);
    return {estimate.height_m,      estimate.climb_mps, airspeed_mps(),
            pathAcceleration_mss(), cosRoll(),          vehicle.airspeed.healthy};
}

// The highest angle of attack is kept away from the stall near the ground; without an airspeed
// sensor there is no speed to climb at, and the pitch is the take-off's own.
float pitchMax_rad(const Plan& plan) {
    float most_rad = core::fromCentidegrees(parameters.pitch_max_cd);
    const bool landing =
        plan.phase == ::control::Phase::approach || plan.phase == ::control::Phase::flare;
    if (landing || !vehicle.airspeed.healthy)
        most_rad = core::limit(pathAngle_rad() + kMaxAlpha_rad, 0.0f, most_rad);
    const bool pitch_given = plan.phase == ::control::Phase::climb_out && !vehicle.airspeed.healthy;
    return pitch_given || most_rad < plan.pitch_min_rad ? plan.pitch_min_rad : most_rad;
}

int8_t throttleMax_pct(::control::Phase phase) {
    const bool taking_off =
        phase == ::control::Phase::climb_out && parameters.takeoff_throttle_max_pct > 0;
    return taking_off ? parameters.takeoff_throttle_max_pct : parameters.throttle_max_pct;
}

// -1..1: how far the throttle stick is from its middle, where that counts. Above it asks for more,
// all of it for the most.
float nudge() {
    const int8_t above_pct = vehicle.radio.throttle_pct - 50;
    const bool counts = stickSetsSpeed() || (parameters.throttle_nudge != 0 && above_pct > 0);
    return counts && !vehicle.radio.lost ? core::real(above_pct) * 0.02f : 0;
}

float nudged_mps(float airspeed_mps) {
    if (stickSetsSpeed()) return airspeed_mps;
    return core::lerp(airspeed_mps, speedMax_mps(), nudge());
}

// Without a sensor the stick moves the throttle itself.
float cruiseThrottle(float most) {
    const float cruise = core::hundredths(vehicle.demand.throttle_pct);
    if (vehicle.airspeed.healthy) return cruise;
    const float share = nudge();
    return cruise + share * (core::isPositive(share) ? most - cruise : cruise * kNudgedDown);
}

// A thrown airplane sinks until its motor is at full power: as ArduPlane's TKOFF_THR_SLEW -1.
float throttleSlew(::control::Phase phase) {
    constexpr float kAtOnce = 100;
    const bool thrown =
        phase == ::control::Phase::climb_out && core::isPositive(parameters.takeoff_min_accel_mss);
    if (thrown || parameters.throttle_slew_pct <= 0) return kAtOnce;
    return core::hundredths(parameters.throttle_slew_pct);
}

::control::SpeedHeightLimits limits(const Plan& plan, float true_speed) {
    ::control::SpeedHeightLimits limits;
    limits.pitch_min_rad = plan.pitch_min_rad;
    limits.pitch_max_rad = pitchMax_rad(plan);
    limits.throttle_min = core::hundredths(parameters.throttle_min_pct);
    limits.throttle_max = core::hundredths(throttleMax_pct(plan.phase));
    limits.throttle_cruise = cruiseThrottle(limits.throttle_max);
    if (plan.phase == ::control::Phase::flare)
        limits.throttle_max =
            core::limit(flarePower() * limits.throttle_cruise, 0.0f, limits.throttle_max);
    limits.throttle_slew = throttleSlew(plan.phase);
    limits.airspeed_min_mps = speedMin_mps() * true_speed;
    limits.airspeed_max_mps = speedMax_mps() * true_speed;
    return limits;
}

void learnLevel() {
    constexpr float kLevel_mps = 1;
    if (!vehicle.baro.healthy || fabsf(vehicle.estimate.climb_mps) > kLevel_mps) return;
    const int16_t pitch = vehicle.attitude.pitch_rad.raw;
    height_control.level_pitch_rad.raw = static_cast<int16_t>(
        height_control.level_pitch_rad.raw + ((pitch - height_control.level_pitch_rad.raw) >> 6));
}

// With neither barometer nor GPS, a little above level: nobody sees the ground coming.
core::Angle blindPitch_rad() {
    constexpr core::Angle kAbove_rad(core::radians(0.7f));
    return core::Angle::fromRaw(
        static_cast<int16_t>(height_control.level_pitch_rad.raw + kAbove_rad.raw));
}

}  // namespace

float trueFromEquivalent() {
    const auto& estimate = core::based(vehicle.estimate);
    if (estimate.equivalent_airspeed_mps < kFlyingSpeed_mps) return 1;
    return core::limit(estimate.airspeed_mps / estimate.equivalent_airspeed_mps, 0.8f, 2.0f);
}

void beginHeight() {
    core::based(height_control.speed_height)
        .start(measured(), vehicle.attitude.pitch_rad.toFloat(), vehicle.throttle_demand.toFloat());
}

void shiftHeightFlown(float by_m) { height_control.speed_height.shift(by_m); }

const ::control::SpeedHeightFlown& heightFlown() { return height_control.speed_height.flown(); }

void waitWithHeight(const Plan& plan) {
    // from the nose of the throw: from level it would have to be raised while the airplane sinks
    core::based(height_control.speed_height)
        .start(measured(), vehicle.attitude.pitch_rad.toFloat(), 0);
    demandPitch(core::Angle(plan.phase == ::control::Phase::climb_out ? plan.pitch_min_rad : 0.0f));
    demandThrottle(core::Ratio(
        parameters.suppressed_manual != 0 ? core::hundredths(vehicle.radio.throttle_pct) : 0.0f));
}

void flyHeight(const Plan& plan) {
    const float true_speed = trueFromEquivalent();
    const bool blind = failing(Cause::no_height) && plan.phase == ::control::Phase::cruise;
    const ::control::SpeedHeightDemand demand = {
        blind ? vehicle.estimate.height_m : plan.height.height_m, plan.height.climb_mps,
        nudged_mps(plan.airspeed_mps) * true_speed};
    const auto out =
        core::based(height_control.speed_height)
            .run(core::based(parameters.speed_height), limits(plan, true_speed), demand, measured(),
                 blind ? ::control::Phase::approach : plan.phase, kPeriod_s);
    learnLevel();
    demandPitch(blind ? blindPitch_rad() : core::Angle(out.pitch_rad));
    demandThrottle(core::Ratio(out.throttle));
}

}  // namespace guidance
}  // namespace firmware

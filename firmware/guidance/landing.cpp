// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/landing.hpp"

#include <math.h>

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/fixed.hpp"
#include "core/maths.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/guidance/bank.hpp"
#include "firmware/guidance/flights.hpp"
#include "firmware/guidance/height.hpp"
#include "firmware/guidance/lateral.hpp"
#include "firmware/guidance/path_state.hpp"
#include "firmware/guidance/steering.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

using namespace state;

namespace {

constexpr float kApproachShare = 0.55f;  // of the way from the lowest speed to cruise
constexpr float kPerHeadwind = 0.6f, kMaxForHeadwind_mps = 3;
// Gusts of 1 m/s RMS move the airspeed by 0.8 m/s in the mean. The approach speed alone bears 0.6:
// where it was left to bear 0.8, one landing in 35 crashed, or ended far away, in drawn gusts of 1
// to 2 m/s, and now none of 448.
constexpr float kBorneGusts_mps = 0.6f, kPerGust = 3, kMaxForGusts_mps = 4;
using Gusts = core::Fixed<11>;      // m/s
constexpr uint8_t kGustsShift = 7;  // the mean is of 6.4 s: 128 runs at 20 Hz
constexpr float kAligned = 0.97f;   // cosine: in the turn onto the leg no gust is seen
// Lower than this a gust changes the approach speed no more: an airplane sped up just above the
// ground does not come down, and touched down 115 m behind the point.
constexpr float kGustsAbove_m = 4;

constexpr float kMiddle_radpm = 0.03f, kMaxToMiddle_rad = 0.1f;

// What the wind loses near the ground comes off the airspeed within a second. The flare keeps power
// for what the speed over the ground is below the approach's in calm air: the airspeed that is left
// once the wind is gone. So it does for what a lull takes below the lowest speed, which would end
// in a stall. None is left at the ground, or, wherever that is, so far behind the point.
constexpr float kPerHeadwind_spm = 0.3f;
constexpr float kMaxPower = 1.4f;   // of the cruise throttle
constexpr float kPowered_m = 0.9f;  // less below
constexpr float kPoweredBehind_m = 15, kPowerFades_m = 20;
constexpr float kPerMissing_spm = 0.75f;
// The flare ends so much behind the point: airplanes touched down short by that, in the mean.
constexpr float kLate_s = 0.05f, kLaterIntoWind_s = 0.75f;
constexpr float kSofter = 0.5f;
// Below LAND_PITCH_CD, the higher the more: a fast airplane would not come down.
constexpr float kNoseDown_radpm = 0.1f, kMaxNoseDown_m = 2;

struct Descent {
    navigation::Landing landing;
    core::Ratio power;  // of the cruise throttle
    Gusts gusts_mps;    // mean of what gusts change of the headwind, up or down
};
core::FileState<Descent> descent{};

// Of the landing point; of the field where no ground was there.
float ground_m() {
    if (!descent.landing.byField()) return vehicle.demand.height_m;
    return vehicle.estimate.height_m - estimator::aboveField_m();
}

float aboveGround_m() { return vehicle.estimate.height_m - ground_m(); }

// Between the lowest speed and cruise: slow enough to land, fast enough to flare. Most of the
// headwind is added, for near the ground it is gone.
float calmApproachSpeed_mps(float cruise_mps) {
    return speedMin_mps() + kApproachShare * (cruise_mps - speedMin_mps());
}

// Not of the headwind as it is: a lull would ask for less speed.
float approachSpeed_mps(float calm_mps, float along_mps, float steady_mps) {
    auto& gusts = descent.gusts_mps;
    const bool aligned = along_mps > kAligned * vehicle.estimate.ground_speed_mps;
    if (aligned && aboveGround_m() > kGustsAbove_m) {
        const Gusts now(fabsf(vehicle.estimate.airspeed_mps - along_mps - steady_mps));
        gusts.raw += (now.raw - gusts.raw) >> kGustsShift;
    }
    const float for_gusts_mps = kPerGust * (gusts.toFloat() - kBorneGusts_mps);
    return calm_mps + core::limit(kPerHeadwind * steady_mps, 0.0f, kMaxForHeadwind_mps) +
           core::limit(for_gusts_mps, 0.0f, kMaxForGusts_mps);
}

float share(float value) { return core::limit(value, 0.0f, 1.0f); }

float steadyHeadwind_mps(const navigation::Lateral& lateral) {
    const auto& wind = vehicle.estimate.wind_mps;
    return -(wind.x * lateral.course.north_m + wind.y * lateral.course.east_m);
}

float demandedPower(const navigation::Lateral& lateral, float missing_mps) {
    const float left_m = legLength_m() + kPoweredBehind_m - lateral.along_m;
    return kMaxPower * share(missing_mps * kPerMissing_spm) *
           share(aboveGround_m() * (1 / kPowered_m)) * share(left_m * (1 / kPowerFades_m));
}

navigation::HeightDemand height(const navigation::Lateral& lateral, float along_mps,
                                float into_wind) {
    const auto& demand = core::based(vehicle.demand);
    const float counted_from_m = ground_m();  // in this run: at its end it may be another
    const navigation::LandingSettings settings = {
        parameters.flare_height_m, parameters.flare_s,
        parameters.speed_height.land_sink_mps * (1 - kSofter * into_wind),
        kLate_s + kLaterIntoWind_s * into_wind};
    const navigation::Approach approach = {demand.from_height_m - demand.height_m,
                                           legLength_m(),
                                           lateral.along_m,
                                           along_mps,
                                           vehicle.estimate.height_m - counted_from_m,
                                           -vehicle.estimate.climb_mps,
                                           estimator::aboveField_m()};
    const auto above_ground = descent.landing.run(settings, approach);
    return {above_ground.height_m + counted_from_m, above_ground.climb_mps};
}

// Back to the middle of the runway.
float runwayError_rad(float crosstrack_m) {
    return core::limit(crosstrack_m * kMiddle_radpm, -kMaxToMiddle_rad, kMaxToMiddle_rad);
}

}  // namespace

void beginLanding() { descent.landing.start(); }
float flarePower() { return descent.power.toFloat(); }

Plan flyLanding() {
    const auto now = motion();
    const auto lateral = followDemandedLeg(now, !descent.landing.flaring());
    const float speed_mps = along_mps(lateral, now);
    Plan to_fly = levelPlan();
    const float headwind_mps = steadyHeadwind_mps(lateral);
    const float into_wind = share(headwind_mps * kPerHeadwind_spm);
    to_fly.height = height(lateral, speed_mps, into_wind);
    const float calm_mps = calmApproachSpeed_mps(to_fly.airspeed_mps);
    to_fly.airspeed_mps = approachSpeed_mps(calm_mps, speed_mps, headwind_mps);
    to_fly.phase = ::control::Phase::approach;
    if (descent.landing.flaring()) {
        to_fly.phase = ::control::Phase::flare;
        to_fly.pitch_min_rad = core::fromCentidegrees(parameters.land_pitch_cd) -
                               kNoseDown_radpm * core::limit(aboveGround_m(), 0.0f, kMaxNoseDown_m);
        const float lost_mps = calm_mps * trueFromEquivalent() - vehicle.estimate.ground_speed_mps;
        const float slow_mps =
            speedMin_mps() * trueFromEquivalent() - vehicle.estimate.airspeed_mps;
        descent.power = core::Ratio(demandedPower(lateral, fmaxf(lost_mps, slow_mps)));
        steerTowards(legHeading_rad() - runwayError_rad(lateral.crosstrack_m));
    }
    progress.flaring = descent.landing.flaring();
    demandBank(lateral.bank_accel_mss,
               descent.landing.flaring() ? BankLimit::level : BankLimit::flying);
    return to_fly;
}

}  // namespace guidance
}  // namespace firmware

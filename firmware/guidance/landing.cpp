// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/landing.hpp"

#include "core/maths.hpp"
#include "firmware/guidance/bank.hpp"
#include "firmware/guidance/flights.hpp"
#include "firmware/guidance/lateral.hpp"
#include "firmware/guidance/steering.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {
namespace {

constexpr float kMostForHeadwind_mps = 3;
constexpr float kApproachShare = 0.55f;  // of the way from the lowest speed to cruise

constexpr float kMiddle_radpm = 0.03f, kMostToMiddle_rad = 0.1f;

navigation::Landing landing;

// Between the lowest speed and cruise: slow enough to land, fast enough to flare. Most of the
// headwind is added, for near the ground it is gone.
float approachSpeed_mps(float cruise_mps, float along_mps) {
    const float headwind_mps = vehicle.estimate.airspeed_mps - along_mps;
    return parameters.speed_min_mps + kApproachShare * (cruise_mps - parameters.speed_min_mps) +
           core::limit(0.6f * headwind_mps, 0.0f, kMostForHeadwind_mps);
}

navigation::HeightDemand height(const navigation::Lateral& lateral, float along_mps) {
    const auto& demand = vehicle.demand;
    const navigation::LandingSettings settings = {parameters.flare_height_m, parameters.flare_s,
                                                  parameters.speed_height.land_sink_mps};
    const navigation::Approach approach = {demand.from_height_m - demand.height_m,
                                           legLength_m(),
                                           lateral.along_m,
                                           along_mps,
                                           vehicle.estimate.height_m - demand.height_m,
                                           -vehicle.estimate.climb_mps};
    const auto above_point = landing.run(settings, approach);
    return {above_point.height_m + demand.height_m, above_point.climb_mps};
}

// Back to the middle of the runway.
float runwayError_rad(float crosstrack_m) {
    return core::limit(crosstrack_m * kMiddle_radpm, -kMostToMiddle_rad, kMostToMiddle_rad);
}

}  // namespace

void beginLanding() { landing.start(); }

Plan flyLanding() {
    const auto now = motion();
    const auto lateral = followDemandedLeg(now, !landing.flaring());
    const float speed_mps = along_mps(lateral, now);
    Plan to_fly = levelPlan();
    to_fly.height = height(lateral, speed_mps);
    to_fly.airspeed_mps = approachSpeed_mps(to_fly.airspeed_mps, speed_mps);
    to_fly.phase = control::Phase::approach;
    if (landing.flaring()) {
        to_fly.phase = control::Phase::flare;
        to_fly.pitch_min_rad = core::radiansFromCentidegrees(parameters.land_pitch_cd);
        steerTowards(legHeading_rad() - runwayError_rad(lateral.crosstrack_m));
    }
    vehicle.progress.flaring = landing.flaring();
    demandBank(lateral.bank_accel_mss, landing.flaring() ? BankLimit::level : BankLimit::flying);
    return to_fly;
}

}  // namespace firmware

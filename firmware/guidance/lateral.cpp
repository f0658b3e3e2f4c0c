// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/lateral.hpp"

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "estimation/atan2_table.hpp"
#include "firmware/guidance/bank.hpp"
#include "firmware/guidance/path_state.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

using namespace state;

namespace {

struct FlownPath {
    navigation::LateralGains gains;
    navigation::Leg leg;
    geo::Offset course, place;  // place: from the leg's start or the circle's centre
};
core::FileState<FlownPath> flown{};

core::Angle bearing(const geo::Offset& direction) {
    return estimation::tableAtan2(core::Ratio(direction.east_m), core::Ratio(direction.north_m));
}
uint16_t bearing_cd(const geo::Offset& direction) { return core::wrap360_cd(bearing(direction)); }

}  // namespace

void beginLateral() {
    planTurns();
    flown.gains = navigation::lateralGains(parameters.lateral, turnAccel_mss());
}

void reportTargetBearing() {
    const float distance_m = vehicle.progress.distance_m;
    if (distance_m < 1) return;  // over it every bearing is as true
    const float share = core::inverse(distance_m);
    const float ahead_m = vehicle.demand.path == Path::circle ? 0 : flown.leg.length_m;
    progress.target_bearing_cd =
        bearing_cd({(flown.leg.forward.north_m * ahead_m - flown.place.north_m) * share,
                    (flown.leg.forward.east_m * ahead_m - flown.place.east_m) * share});
}

void reportCourse() { progress.nav_bearing_cd = bearing_cd(flown.course); }

void planLateral() {
    flown.leg = navigation::legAlong(geo::offset(vehicle.demand.from, vehicle.demand.to));
    // a take-off reports no more than this
    progress.distance_m = flown.leg.length_m;
    flown.course = flown.leg.forward;
    flown.place = {0, 0};
}

navigation::Motion motion() {
    const auto& estimate = core::based(vehicle.estimate);
    navigation::Motion motion;
    motion.velocity_mps = {estimate.velocity_mps.x, estimate.velocity_mps.y};
    motion.wind_mps = {estimate.wind_mps.x, estimate.wind_mps.y};
    motion.airspeed_mps = estimate.airspeed_mps;
    motion.bank_accel_mss = expectedBank_mss();
    motion.bank_lag_s = bankLag_s();
    return motion;
}

const navigation::LateralGains& lateralGains() { return flown.gains; }

float legLength_m() { return flown.leg.length_m; }

float legHeading_rad() { return bearing(flown.leg.forward).toFloat(); }

navigation::Lateral followDemandedLeg(const navigation::Motion& now, bool learning) {
    const geo::Offset from_start = geo::offset(vehicle.demand.from, vehicle.estimate.position);
    const auto lateral = navigation::followLeg(flown.gains, now, flown.leg, from_start);
    reportLateral(lateral, from_start);
    progress.passed = lateral.along_m >= flown.leg.length_m;
    if (learning) learnBankTrim(-lateral.crosstrack_m);
    return lateral;
}

float turnLead_m(const geo::Position& next) {
    return navigation::turnLead_m(flown.gains, motion(), flown.leg,
                                  navigation::legAlong(geo::offset(vehicle.demand.to, next)));
}

// Close to the leg the demanded course is the leg's.
float along_mps(const navigation::Lateral& lateral, const navigation::Motion& now) {
    const float along_mps = lateral.course.north_m * now.velocity_mps.north_m +
                            lateral.course.east_m * now.velocity_mps.east_m;
    return core::limit(along_mps, 0.0f, 100.0f);
}

void reportLateral(const navigation::Lateral& lateral, const geo::Offset& from_datum) {
    progress.distance_m = lateral.distance_m;
    progress.crosstrack_m = lateral.crosstrack_m;
    flown.course = lateral.course;
    flown.place = from_datum;
}

}  // namespace guidance
}  // namespace firmware

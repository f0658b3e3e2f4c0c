// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/lateral.hpp"

#include "core/maths.hpp"
#include "firmware/guidance/bank.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {
namespace {

constexpr float kBankLoop_s = 0.1f;  // what servo and airframe add to RLL2SRV_TCONST

bool target_told;  // by the last tellBearings
geo::Offset course;

}  // namespace

navigation::Motion motion() {
    const auto& estimate = vehicle.estimate;
    navigation::Motion motion;
    motion.position = estimate.position;
    motion.velocity_mps = {estimate.velocity_mps.x, estimate.velocity_mps.y};
    motion.wind_mps = {estimate.wind_mps.x, estimate.wind_mps.y};
    motion.bank_accel_mss = presentBank_mss();
    motion.bank_lag_s = parameters.roll.axis.time_constant_s + kBankLoop_s;
    motion.turn_accel_mss = turnAccel_mss();
    return motion;
}

navigation::Lateral followDemandedLeg(const navigation::Motion& now, bool learning) {
    const auto& demand = vehicle.demand;
    const auto lateral = navigation::followLeg(parameters.lateral, now, demand.from, demand.to);
    tellLateral(lateral);
    vehicle.progress.passed = lateral.along_m >= lateral.length_m;
    if (learning) learnBankTrim(-lateral.crosstrack_m);
    return lateral;
}

// Close to the leg the demanded course is the leg's.
float along_mps(const navigation::Lateral& lateral, const navigation::Motion& now) {
    const float along_mps = lateral.course.north_m * now.velocity_mps.north_m +
                            lateral.course.east_m * now.velocity_mps.east_m;
    return core::limit(along_mps, 0.0f, 100.0f);
}

void tellLateral(const navigation::Lateral& lateral) {
    auto& progress = vehicle.progress;
    progress.distance_m = lateral.distance_m;
    progress.crosstrack_m = lateral.crosstrack_m;
    course = lateral.course;
}

// In turns, each five times a second.
void tellBearings() {
    auto& progress = vehicle.progress;
    target_told = !target_told;
    if (target_told)
        progress.target_bearing_cd = geo::bearing_cd(vehicle.estimate.position, vehicle.demand.to);
    else
        progress.nav_bearing_cd =
            core::wrap360_cd(core::rounded(core::centidegrees(geo::bearing_rad(course))));
}

}  // namespace firmware

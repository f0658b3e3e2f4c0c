// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/plan.hpp"

#include "control/slew.hpp"
#include "core/maths.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {
namespace {

// from_height_m is what moves, as long as there is a rate.
navigation::HeightDemand changingHeight() {
    auto& demand = vehicle.demand;
    if (demand.climb_rate_mps <= 0) return {demand.height_m, 0};
    const float before_m = demand.from_height_m;
    demand.from_height_m =
        control::slewed(before_m, demand.height_m, demand.climb_rate_mps * kGuidancePeriod_s);
    return {demand.from_height_m, (demand.from_height_m - before_m) / kGuidancePeriod_s};
}

}  // namespace

Plan levelPlan() {
    return {changingHeight(), control::Phase::cruise,
            core::radiansFromCentidegrees(parameters.pitch_min_cd), vehicle.demand.airspeed_mps};
}

}  // namespace firmware

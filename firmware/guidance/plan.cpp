// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/plan.hpp"

#include "control/slew.hpp"
#include "core/based.hpp"
#include "core/maths.hpp"
#include "firmware/guidance/path_state.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

using namespace state;

namespace {

// from_height_m is what moves, as long as there is a rate.
navigation::HeightDemand changingHeight() {
    auto& demand = path_demand;
    if (!core::isPositive(demand.climb_rate_mps)) return {demand.height_m, 0};
    const float before_m = demand.from_height_m;
    demand.from_height_m =
        ::control::slewed(before_m, demand.height_m, demand.climb_rate_mps * kGuidancePeriod_s);
    return {demand.from_height_m, (demand.from_height_m - before_m) / kGuidancePeriod_s};
}

// Too high above the way up, the rest of it begins where the airplane is: it need not come down.
void beginSlopeHere(float length_m, float along_m) {
    auto& demand = path_demand;
    const float most_m = demand.height_m - vehicle.estimate.height_m;
    const float left_m = core::isPositive(most_m) ? most_m : 0;
    demand.from_height_m = demand.height_m - left_m * length_m / (length_m - along_m);
}

}  // namespace

void followSlope(Plan& plan, float length_m, float along_m, float along_mps) {
    const auto& demand = core::based(vehicle.demand);
    if (!demand.sloped) return;
    plan.height = navigation::heightOnSlope(demand.from_height_m, demand.height_m, length_m,
                                            along_m, along_mps);
    const int8_t most_m = parameters.glide_slope_threshold_m;
    const bool up =
        core::isPositive(along_m) && along_m < length_m && demand.from_height_m < demand.height_m;
    if (up && most_m > 0 && vehicle.estimate.height_m - plan.height.height_m > core::real(most_m))
        beginSlopeHere(length_m, along_m);
}

Plan levelPlan() {
    return {changingHeight(), ::control::Phase::cruise,
            core::fromCentidegrees(parameters.pitch_min_cd), vehicle.demand.airspeed_mps};
}

}  // namespace guidance
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/circling.hpp"

#include "core/convert.hpp"
#include "firmware/guidance/demand.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace guidance;

namespace {

PathDemand& level(float height_m) {
    PathDemand& demand = beginPath();
    demand.path = Path::none;
    demand.height_m = height_m;
    demand.sloped = false;
    demand.climb_rate_mps = 0;
    demand.airspeed_mps = core::hundredths(parameters.cruise_speed_cms);
    demand.throttle_pct = parameters.cruise_throttle_pct;
    return demand;
}

}  // namespace

void demandLevel(float height_m) { level(height_m); }

// Down to a lower place goes a slope, which ends where the circle begins; up it goes at once.
void demandCircle(const geo::Position& centre, float height_m) {
    PathDemand& demand = level(height_m);
    const int16_t radius_m = parameters.loiter_radius_m;
    demand.path = Path::circle;
    demand.from = vehicle.estimate.position;
    demand.to = centre;
    demand.from_height_m = vehicle.estimate.height_m;
    demand.sloped = demand.from_height_m - height_m > core::real(parameters.glide_slope_min_m);
    demand.radius_m = core::real(radius_m < 0 ? -radius_m : radius_m);
    demand.counter_clockwise = radius_m < 0;
}

}  // namespace modes
}  // namespace firmware

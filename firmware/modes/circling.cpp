// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/circling.hpp"

#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {

void demandCircle(const geo::Position& centre, float height_m) {
    auto& demand = vehicle.demand;
    const int16_t radius_m = parameters.loiter_radius_m;
    demand.path = Path::circle;
    demand.from = vehicle.estimate.position;
    demand.to = centre;
    demand.from_height_m = vehicle.estimate.height_m;
    demand.height_m = height_m;
    demand.sloped = false;
    demand.radius_m = radius_m < 0 ? -radius_m : radius_m;
    demand.counter_clockwise = radius_m < 0;
    demand.climb_rate_mps = 0;
    demand.airspeed_mps = parameters.cruise_speed_cms * 0.01f;
    demand.throttle_pct = parameters.cruise_throttle_pct;
    demand.new_path = true;
}

}  // namespace firmware

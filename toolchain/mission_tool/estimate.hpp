// SPDX-License-Identifier: GPL-3.0-or-later
// What a mission takes: way, time, heights and energy of every NAV in the order of the flight, by
// the airplane's parameters and the simulator's model of it. An estimate: corners are cut as they
// are flown, but what a bank costs, gusts and the take-off run are left out.
#pragma once
#include <optional>
#include <vector>

#include "simulator/ground/plan.hpp"
#include "toolchain/mission_tool/flight_order.hpp"
#include "toolchain/mission_tool/power.hpp"

namespace mission_tool {

struct Wind {
    double speed_mps = 0;
    std::optional<double> from_deg;  // not given: whichever is worst, where that matters
};

struct Stretch {
    size_t nav;
    simulator::Point from, to;  // north and east of home; of a circle `to` is its centre
    bool placed = false;        // at a place of its own; else straight on, or at home
    double circle_m = 0;        // radius; 0: no circle
    double turns = 0;
    double length_m = 0;  // over the ground
    double time_s = 0, used_mah = 0;
    double airspeed_mps = 0;
    double ground_mps = 0;     // on the way there; not above 0: it is not reached against the wind
    double from_height_m = 0;  // above home
    double wanted_height_m = 0, height_m = 0;  // at its end: demanded, and reached
    double needed_climb_mps = 0;               // below 0: sink
};

struct Estimate {
    std::vector<Stretch> stretches;  // one a visit of `order`, as far as it can be reckoned
    double length_m = 0, time_s = 0, used_mah = 0, capacity_mah = 0;
    double climbed_m = 0, highest_m = 0, farthest_m = 0;
    double largest_climb_mps = 0, largest_sink_mps = 0;  // the airplane's limits
};

// The firmware must have been started (board.hpp): speeds and limits are parameters.
Estimate estimate(const Document& document, const FlightOrder& order, const Power& power,
                  const Wind& wind);

// Over the ground along `course_rad` (from north to east) through that wind; not above 0: never.
double groundSpeed_mps(double airspeed_mps, const Wind& wind, double course_rad);

double heightOf_m(const Document& document, size_t index);  // above home
double airspeedOf_mps(double indicated_mps, double above_sea_m);

}  // namespace mission_tool

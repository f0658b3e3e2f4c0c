// SPDX-License-Identifier: GPL-3.0-or-later
// FBWB: the roll stick demands bank, the pitch stick a climb, the throttle stick an airspeed
// between the lowest and the highest. With the pitch stick centred the height is held.
#include "core/based.hpp"
#include "core/maths.hpp"
#include "firmware/control/attitude_demand.hpp"
#include "firmware/guidance/demand.hpp"
#include "firmware/modes/circling.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace guidance;
using namespace control;

namespace {

constexpr float kFullStick_cd = 4500;
constexpr float kFar_m = 10000;      // farther than a stick is held
constexpr float kAhead_m = 10;       // no farther does the demand run before what can be flown
constexpr float kLevelOff_s = 0.8f;  // of the present climb, within which it ends

// The climb is flown as a change of height at a rate, which guidance knows: from_height_m moves.
void climb(PathDemand& demand, float rate_mps, float lowest_m) {
    const float height_m = vehicle.estimate.height_m;
    const float from_m =
        core::isPositive(demand.climb_rate_mps) ? demand.from_height_m : demand.height_m;
    demand.from_height_m = core::limit(from_m, height_m - kAhead_m, height_m + kAhead_m);
    demand.height_m = core::isPositive(rate_mps) ? kFar_m : lowest_m;
    demand.climb_rate_mps = fabsf(rate_mps);
}

void hold(PathDemand& demand, float lowest_m) {
    const auto& now = core::based(vehicle.estimate);
    if (core::isPositive(demand.climb_rate_mps))
        demand.height_m = now.height_m + now.climb_mps * kLevelOff_s;
    demand.climb_rate_mps = 0;
    if (demand.height_m < lowest_m) demand.height_m = lowest_m;
}

}  // namespace

EntryResult startFbwb() {
    demandLevel(vehicle.estimate.height_m);
    return EntryResult::entered;
}

void runFbwb() { demandRoll(stickRoll_rad()); }

void demandFbwb() {
    const int16_t stick_cd = vehicle.radio.pitch_cd;
    const int16_t pulled_cd = parameters.fbwb_elevator_reverse != 0 ? -stick_cd : stick_cd;
    const float lowest_m =
        parameters.fbwb_lowest_cm > 0 ? core::hundredths(parameters.fbwb_lowest_cm) : -kFar_m;
    PathDemand& demand = changePath();
    if (pulled_cd == 0)
        hold(demand, lowest_m);
    else
        climb(demand, core::real(pulled_cd) * (1 / kFullStick_cd) * parameters.fbwb_climb_mps,
              lowest_m);
    if (!vehicle.radio.lost)
        demand.airspeed_mps = core::lerp(speedMin_mps(), speedMax_mps(), stickThrottle().toFloat());
}

}  // namespace modes
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// CONDITIONs: what the commands behind them wait for.
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/seldom.hpp"
#include "firmware/guidance/demand.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace mission {

using namespace state;
using namespace guidance;

namespace {

struct Delay {
    uint32_t since_ms;
};
core::FileState<Delay> delay{};

// A height that a CHANGE_ALT demands until the next NAV loads.
struct Climb {
    float goal_m;
    float rate_mps;  // 0: none
    bool from_below;
};
core::FileState<Climb> climb{};

SELDOM Progress delayed(uint32_t delay_s) {
    return (hal::now_ms() - delay.since_ms) / 1000 >= delay_s ? Progress::done : Progress::running;
}

}  // namespace

void startDelay(const Record&) { delay.since_ms = hal::now_ms(); }
Progress delayDoneP1(const Record& record) { return delayed(record.p1); }
Progress delayDoneP3(const Record& record) { return delayed(static_cast<uint32_t>(record.p3)); }

int32_t climbRate_cms(const Record& record) { return record.p3 != 0 ? record.p3 : record.p1; }

void startChangeAltitude(const Record& record) {
    climb.goal_m = heightOf_m(record);
    climb.rate_mps = core::hundredths(climbRate_cms(record));
    climb.from_below = vehicle.estimate.height_m < climb.goal_m;
    goOnClimbing();
}

Progress changeAltitudeDone(const Record&) {
    constexpr float kNear_m = 2;
    const float left_m = climb.goal_m - vehicle.estimate.height_m;
    return (climb.from_below ? left_m <= kNear_m : left_m >= -kNear_m) ? Progress::done
                                                                       : Progress::running;
}

// Not in a landing: the demanded height is the ground's there.
void goOnClimbing() {
    PathDemand& demand = changePath();
    if (core::isZero(climb.rate_mps) || demand.path == Path::land) return;
    demand.from_height_m = demand.height_m = vehicle.estimate.height_m;
    demand.sloped = false;
    demand.climb_rate_mps = climb.rate_mps;
}

void stepClimb() {
    if (core::isZero(vehicle.demand.climb_rate_mps)) return;
    PathDemand& demand = changePath();
    const float step_m = demand.climb_rate_mps * 0.1f;
    demand.height_m += core::limit(climb.goal_m - demand.height_m, -step_m, step_m);
}

void shiftClimb(float by_m) { climb.goal_m += by_m; }

void forgetClimb() { climb.rate_mps = 0; }

void startDistance(const Record&) {}

Progress distanceDone(const Record& record) {
    // a path that guidance has not seen has no distance yet
    if (placeless() || vehicle.demand.new_path) return Progress::running;
    return vehicle.progress.distance_m < static_cast<float>(record.p3) ? Progress::done
                                                                       : Progress::running;
}

}  // namespace mission
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// CONDITIONs: what the commands behind them wait for.
#include "firmware/mission/handlers.hpp"
#include "firmware/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace {

uint32_t since_ms;
bool from_below;

Progress delayed(uint32_t delay_s) {
    return (hal::now_ms() - since_ms) / 1000 >= delay_s ? Progress::done : Progress::running;
}

}  // namespace

void startDelay(const Record&) { since_ms = hal::now_ms(); }
Progress delayDoneP1(const Record& record) { return delayed(record.p1); }
Progress delayDoneP3(const Record& record) { return delayed(static_cast<uint32_t>(record.p3)); }

int32_t climbRate_cms(const Record& record) { return record.p3 != 0 ? record.p3 : record.p1; }

// The target starts at the airplane and moves at the rate; guidance moves it.
void startChangeAltitude(const Record& record) {
    auto& demand = vehicle.demand;
    demand.from_height_m = vehicle.estimate.height_m;
    demand.height_m = heightOf_m(record);
    demand.sloped = false;
    demand.climb_rate_mps = static_cast<float>(climbRate_cms(record)) * 0.01f;
    from_below = demand.from_height_m < demand.height_m;
}

Progress changeAltitudeDone(const Record&) {
    constexpr float kNear_m = 2;
    const float left_m = vehicle.demand.height_m - vehicle.estimate.height_m;
    return (from_below ? left_m <= kNear_m : left_m >= -kNear_m) ? Progress::done
                                                                 : Progress::running;
}

void startDistance(const Record&) {}

Progress distanceDone(const Record& record) {
    const bool has_place =
        vehicle.demand.path != Path::takeoff && vehicle.demand.path != Path::none;
    // a path that guidance has not seen has no distance yet
    if (!has_place || vehicle.demand.new_path) return Progress::running;
    return vehicle.progress.distance_m < static_cast<float>(record.p3) ? Progress::done
                                                                       : Progress::running;
}

}  // namespace firmware

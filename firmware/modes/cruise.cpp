// SPDX-License-Identifier: GPL-3.0-or-later
// CRUISE: FBWB that keeps its track. With roll and yaw sticks centred for half a second the course
// over ground is locked, and the line along it is flown; either stick unlocks it.
#include "core/file_state.hpp"
#include "firmware/guidance/demand.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace modes {

using namespace state;
using namespace guidance;

namespace {

constexpr uint8_t kCentred = 10;   // demands, 20 a second
constexpr float kSlowest_mps = 3;  // a slower course is noise
constexpr float kAhead_m = 1000;
constexpr float kMoveOn_m = kAhead_m / 2;

struct RollStick {
    uint8_t centred;
};
core::FileState<RollStick> roll_stick{};

bool turning() { return vehicle.radio.roll_cd != 0 || vehicle.radio.yaw_cd != 0; }

void lock() {
    PathDemand& demand = beginPath();
    const auto& now = vehicle.estimate;
    const float share = kAhead_m / now.ground_speed_mps;
    demand.path = Path::leg;
    demand.from = now.position;
    demand.to = geo::moved(now.position, {now.velocity_mps.x * share, now.velocity_mps.y * share});
}

void shift(geo::Position& place, int32_t up_e7, int32_t eastward_e7) {
    place.latitude_e7 += up_e7;
    place.longitude_e7 = geo::eastward_e7(0, place.longitude_e7 + eastward_e7);
}

// Both ends by the same whole steps: the line stays what it is.
void moveOn() {
    PathDemand& demand = beginPath();
    const int32_t up_e7 = (demand.to.latitude_e7 - demand.from.latitude_e7) / 2;
    const int32_t eastward_e7 =
        geo::eastward_e7(demand.from.longitude_e7, demand.to.longitude_e7) / 2;
    shift(demand.from, up_e7, eastward_e7);
    shift(demand.to, up_e7, eastward_e7);
}

void unlock() {
    changePath().path = Path::none;
    roll_stick.centred = 0;
}

}  // namespace

EntryResult startCruise() {
    roll_stick.centred = 0;
    return startFbwb();
}

void runCruise() {
    if (turning()) unlock();
    if (vehicle.demand.path == Path::none) runFbwb();
}

void demandCruise() {
    demandFbwb();
    const auto& now = vehicle.estimate;
    if (vehicle.demand.path == Path::leg) {
        if (!now.known)
            unlock();
        else if (!vehicle.demand.new_path && vehicle.progress.distance_m < kMoveOn_m)
            moveOn();
    } else if (!turning() && now.known && now.ground_speed_mps >= kSlowest_mps &&
               ++roll_stick.centred > kCentred) {
        lock();
    }
}

}  // namespace modes
}  // namespace firmware

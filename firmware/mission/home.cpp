// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/home.hpp"

#include <math.h>

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/guidance/guidance.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/state/published.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<HomeState> : Writable<HomeState> {
    using Writable::state;
};
}  // namespace state

namespace mission {

using namespace state;
using namespace estimator;
using namespace guidance;

namespace {

constexpr HomeState& published = Publisher<HomeState>::state();

struct Refining {
    uint8_t waited;  // 0.1 s
};
core::FileState<Refining> refining{};

void setWhereItStands() {
    resumeHome(vehicle.estimate.position, vehicle.gps.altitude_cm);
    zeroHeight();
}

// More than a fix wanders within some seconds.
bool movedClearly() {
    constexpr float kMoved_m = 3, kDrifted_m = 1.5f;
    constexpr int32_t kMoved_cm = 300;
    const int32_t higher_cm = vehicle.gps.altitude_cm - vehicle.home.altitude_cm;
    return fabsf(vehicle.estimate.height_m) > kDrifted_m || higher_cm > kMoved_cm ||
           higher_cm < -kMoved_cm ||
           geo::distance_m(vehicle.home.position, vehicle.estimate.position) > kMoved_m;
}

}  // namespace

bool setHomeHere() {
    if (vehicle.gps.fix != GpsFix::three_d || !vehicle.estimate.known) return false;
    if (vehicle.estimate.flying && vehicle.home.set) {
        // the barometer's height is steadier than the receiver's
        const int32_t above_cm = core::inHundredths(vehicle.estimate.height_m);
        setHome(vehicle.estimate.position, vehicle.home.altitude_cm + above_cm);
        return true;
    }
    setWhereItStands();
    return true;
}

void setHome(const geo::Position& position, int32_t altitude_cm) {
    if (published.set) {
        // what is being flown stays where it is
        const float by_m = core::hundredths(published.altitude_cm - altitude_cm);
        shiftHeight(by_m);
        shiftDemands(by_m);
        missionShiftHeights(by_m);
    }
    resumeHome(position, altitude_cm);
}

void resumeHome(const geo::Position& position, int32_t altitude_cm) {
    published.position = position;
    published.altitude_cm = altitude_cm;
    published.set = published.ordered = true;
    ++published.changes;
}

bool setHomeOfFlight() {
    const bool done = setHomeHere();
    published.ordered = false;
    return done;
}

void refineHome() {
    constexpr float kStands_mps = 3;  // carried it may be
    constexpr uint8_t kEvery = 50;
    if (published.ordered || vehicle.estimate.ground_speed_mps > kStands_mps) return;
    if (published.set && ++refining.waited < kEvery) return;
    refining.waited = 0;
    if (published.set && !movedClearly()) return;
    setWhereItStands();
    published.ordered = false;
}

}  // namespace mission
}  // namespace firmware

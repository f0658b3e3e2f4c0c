// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/home.hpp"

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

}  // namespace

bool setHomeHere() {
    if (vehicle.gps.fix != GpsFix::three_d || !vehicle.estimate.known) return false;
    if (vehicle.estimate.flying && vehicle.home.set) {
        // the barometer's height is steadier than the receiver's
        const int32_t above_cm = core::rounded(vehicle.estimate.height_m * 100.0f);
        setHome(vehicle.estimate.position, vehicle.home.altitude_cm + above_cm);
        return true;
    }
    published.set = false;
    setHome(vehicle.estimate.position, vehicle.gps.altitude_cm);
    zeroHeight();
    return true;
}

void setHome(const geo::Position& position, int32_t altitude_cm) {
    if (published.set) {
        // what is being flown stays where it is
        const float by_m = (published.altitude_cm - altitude_cm) * 0.01f;
        shiftHeight(by_m);
        shiftDemands(by_m);
        missionShiftHeights(by_m);
    }
    published = {position, altitude_cm, true};
}

void resumeHome(const geo::Position& position, int32_t altitude_cm) {
    published = {position, altitude_cm, true};
}

}  // namespace mission
}  // namespace firmware

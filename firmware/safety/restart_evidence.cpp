// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/restart_evidence.hpp"

#include "firmware/estimator/estimator.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace safety {

using namespace state;

bool measuredInTheAir(float home_height_m) {
    constexpr float kOutOfReach_m = 10, kFarOutOfReach_m = 30;
    // 0: it has not been read since the start
    const bool read = vehicle.baro.healthy && vehicle.estimate.baro_height_m != 0;
    const float height_m = read ? vehicle.estimate.baro_height_m - home_height_m : 0;
    if (height_m > kFarOutOfReach_m) return true;
    if (vehicle.airspeed.healthy)
        return vehicle.airspeed.speed_mps > estimator::flyingAirspeed_mps();
    return height_m > kOutOfReach_m;
}

}  // namespace safety
}  // namespace firmware

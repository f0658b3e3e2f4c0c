// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/restart_evidence.hpp"

#include "firmware/estimator/estimator.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace safety {

using namespace state;

namespace {

// 0: it has not been read since the start
bool barometerRead() { return vehicle.baro.healthy && vehicle.estimate.baro_height_m != 0; }

}  // namespace

bool measuredInTheAir(float home_height_m) {
    constexpr float kOutOfReach_m = 10, kFarOutOfReach_m = 30;
    const float height_m = barometerRead() ? vehicle.estimate.baro_height_m - home_height_m : 0;
    if (height_m > kFarOutOfReach_m) return true;
    if (vehicle.airspeed.healthy)
        return vehicle.airspeed.speed_mps > estimator::flyingAirspeed_mps();
    return height_m > kOutOfReach_m;
}

uint16_t evidenceComesWithin_ms() {
    constexpr uint16_t kRead_ms = 2000, kBlind_ms = 30000;
    return barometerRead() || vehicle.airspeed.healthy ? kRead_ms : kBlind_ms;
}

}  // namespace safety
}  // namespace firmware

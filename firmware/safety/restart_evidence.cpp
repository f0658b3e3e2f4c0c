// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/restart_evidence.hpp"

#include <math.h>

#include "core/file_state.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace safety {

using namespace state;

namespace {

struct Blind {
    uint16_t until_ms;  // since the start, no sensor was read that can see it in the air
};
core::FileState<Blind> blind{};

constexpr uint8_t kEnoughFixes = 6;

// 0: it has not been read since the start
bool barometerRead() { return vehicle.baro.healthy && vehicle.estimate.baro_height_m != 0; }

}  // namespace

bool measuredInTheAir(float field_height_m) {
    constexpr float kOutOfReach_m = 10, kFarOutOfReach_m = 30;
    const float height_m =
        barometerRead() ? fabsf(vehicle.estimate.baro_height_m - field_height_m) : 0;
    if (height_m > kFarOutOfReach_m) return true;
    sensors::workOutAirspeed();  // the estimator does not while it has no attitude
    if (vehicle.airspeed.healthy)
        return vehicle.airspeed.speed_mps > estimator::flyingAirspeed_mps();
    return height_m > kOutOfReach_m;
}

bool sensorsHadTheirTime() {
    constexpr uint16_t kLeast_ms = 2000, kReads_ms = 1000, kBlind_ms = 30000;
    const uint32_t now_ms = hal::now_ms();
    const bool read = barometerRead() || vehicle.airspeed.healthy;
    if (!read && now_ms < kBlind_ms) blind.until_ms = static_cast<uint16_t>(now_ms);
    return now_ms >= kLeast_ms && now_ms - blind.until_ms >= kReads_ms;
}

// The first fixes of a receiver that has just been switched on may be far off, and one may fit the
// estimate by chance: it is to have accepted them, and all but the last have been looked at.
bool receiverSeesItMove() {
    const auto& estimate = vehicle.estimate;
    return vehicle.gps.healthy && vehicle.gps.fixes >= kEnoughFixes && !estimate.fix_refused &&
           !estimate.reckoned && vehicle.gps.ground_speed_mps > estimator::flyingAirspeed_mps();
}

// The place of the record may have been refused, too, and the first fix that is compared with it.
bool receiverRefused() { return vehicle.gps.fixes > 2 && vehicle.estimate.fix_refused; }

bool receiverHadItsTime() {
    constexpr uint16_t kStarts_ms = 30000;
    return hal::now_ms() >= kStarts_ms || vehicle.gps.fixes >= kEnoughFixes;
}

}  // namespace safety
}  // namespace firmware

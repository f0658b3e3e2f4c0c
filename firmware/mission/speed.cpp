// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/speed.hpp"

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/guidance/demand.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace mission {

using namespace state;
using namespace guidance;

namespace {

constexpr float kStep_s = 0.1f;
constexpr float kGroundSpeedGain = 0.3f;  // of the error, each second: slower than the throttle

struct Speed {
    int16_t air_cms;           // 0: the parameter's
    int16_t ground_cms;        // 0: none demanded
    int8_t throttle_pct = -1;  // -1: the parameter's
};
core::FileState<Speed> speed{};

float cruise_mps() {
    return core::hundredths(speed.air_cms != 0 ? speed.air_cms : parameters.cruise_speed_cms);
}

}  // namespace

void resetSpeed() {
    speed.air_cms = speed.ground_cms = 0;
    speed.throttle_pct = -1;
}

void setAirSpeed(int32_t speed_cms) {
    speed.air_cms = static_cast<int16_t>(speed_cms);
    speed.ground_cms = 0;
    demandSpeed();
}

void setGroundSpeed(int32_t speed_cms) { speed.ground_cms = static_cast<int16_t>(speed_cms); }

void setCruiseThrottle(int8_t throttle_pct) {
    speed.throttle_pct = throttle_pct;
    demandSpeed();
}

void demandSpeed() {
    PathDemand& demand = changePath();
    // a ground speed goes on from the air speed it had come to
    if (speed.ground_cms == 0 || !core::isPositive(demand.airspeed_mps))
        demand.airspeed_mps = cruise_mps();
    demand.throttle_pct =
        speed.throttle_pct >= 0 ? speed.throttle_pct : parameters.cruise_throttle_pct;
}

void stepSpeed() {
    if (speed.ground_cms == 0) return;
    const float error_mps = core::hundredths(speed.ground_cms) - vehicle.estimate.ground_speed_mps;
    PathDemand& demand = changePath();
    demand.airspeed_mps =
        core::limit(demand.airspeed_mps + error_mps * (kGroundSpeedGain * kStep_s), speedMin_mps(),
                    speedMax_mps());
}

}  // namespace mission
}  // namespace firmware

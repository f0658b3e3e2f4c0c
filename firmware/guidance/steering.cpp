// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/steering.hpp"

#include "core/maths.hpp"
#include "firmware/control/attitude_demand.hpp"
#include "firmware/guidance/path_state.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

using namespace state;
using namespace control;

namespace {

constexpr float kPerRadian = 0.6f;
constexpr float kPerRate_s = 0.12f;
// A wheel turns the airplane the quicker, the faster it rolls: small ones with slow servos swung
// from side to side, and over.
constexpr float kFast_mps = 5, kWhenFast = 0.3f;
constexpr float kMax = 0.35f;  // a wheel at full lock overturns the airplane

void steer(float error_rad) {
    progress.steering = true;
    const float wanted =
        error_rad * kPerRadian - vehicle.attitude.rate_rads.z.toFloat() * kPerRate_s;
    const float fast = vehicle.estimate.ground_speed_mps > kFast_mps ? kWhenFast : 1;
    demandRudder(core::Ratio(core::limit(wanted * fast, -kMax, kMax)));
}

}  // namespace

void steerNowhere() {
    progress.steering = false;
    demandRudder(core::Ratio::fromRaw(0));
}

// While the airplane gains speed the compass heading is not steady enough to be held.
void steadyNose() { steer(0); }

void steerTowards(float heading_rad) {
    steer(core::wrapPi(heading_rad - vehicle.attitude.yaw_rad.toFloat()));
}

}  // namespace guidance
}  // namespace firmware

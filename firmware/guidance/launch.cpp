// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/launch.hpp"

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/guidance/path_state.hpp"
#include "firmware/guidance/plan.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "navigation/takeoff.hpp"

namespace firmware {
namespace guidance {

using namespace notify;
using namespace state;

namespace {

constexpr float kUnlaunchedHeight_m = 10;  // farther from home's height the airplane must fly
constexpr float kFlyingSpeed_mps = 5, kStandingSpeed_mps = 2;
constexpr uint8_t kStands = 20;  // looks, 1 s

core::FileState<navigation::Launch> launch{};

struct OnTheGround {
    uint8_t looks;  // in a row
};
core::FileState<OnTheGround> on_the_ground{};

bool flies() {
    const auto& estimate = vehicle.estimate;
    const bool fast = vehicle.gps.fix >= GpsFix::two_d &&
                      estimate.ground_speed_mps >= kFlyingSpeed_mps &&
                      (!vehicle.airspeed.healthy || estimate.airspeed_mps >= kFlyingSpeed_mps);
    return fast || estimate.height_m > kUnlaunchedHeight_m ||
           estimate.height_m < -kUnlaunchedHeight_m;
}

bool launched() {
    if (vehicle.gps.fix != GpsFix::three_d) return false;
    const navigation::LaunchSettings settings = {parameters.takeoff_min_speed_mps,
                                                 parameters.takeoff_min_accel_mss,
                                                 parameters.takeoff_delay_ds};
    const navigation::LaunchState now = {
        vehicle.imu.accel_mss.x.toFloat() -
            core::kGravity_mss * vehicle.attitude.sin_pitch.toFloat(),
        vehicle.estimate.ground_speed_mps, vehicle.attitude.roll_rad.toFloat(),
        vehicle.attitude.pitch_rad.toFloat(), kGuidancePeriod_s};
    const navigation::Launch::Result result = launch.run(settings, now);
    if (result == navigation::Launch::tilted)
        sendStatusText(Severity::warning, ROM_TEXT("Bad launch AUTO"));
    if (result == navigation::Launch::slow)
        sendStatusText(Severity::warning, ROM_TEXT("Timeout AUTO"));
    return result == navigation::Launch::flies;
}

// With the motor turning, elsewhere than in a take-off: it came down, or never left the ground.
bool stands() {
    const bool now = !vehicle.estimate.flying && vehicle.demand.path != Path::takeoff &&
                     vehicle.estimate.ground_speed_mps < kStandingSpeed_mps &&
                     estimator::slowThroughTheAir() && !flies();
    on_the_ground.looks = now ? on_the_ground.looks + 1 : 0;
    return on_the_ground.looks >= kStands;
}

}  // namespace

void suppressThrottle() {
    progress.throttle_suppressed = true;
    on_the_ground.looks = 0;
}

void beginLaunch() { launch.start(); }

void waitForLaunch() {
    if (!vehicle.armed || stands()) return suppressThrottle();
    if (!vehicle.progress.throttle_suppressed) return;
    if (vehicle.demand.path == Path::takeoff ? launched() : flies())
        progress.throttle_suppressed = false;
}

}  // namespace guidance
}  // namespace firmware

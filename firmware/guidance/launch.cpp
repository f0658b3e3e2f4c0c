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
constexpr float kFlyingSpeed_mps = 5;

core::FileState<navigation::Launch> launch{};

struct LastFlight {
    bool flew;  // with the motor turning
};
core::FileState<LastFlight> last_flight{};

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

// It came down elsewhere than at the end of a landing, and nobody asked for another take-off.
bool cameDown() {
    if (vehicle.estimate.flying) last_flight.flew = true;
    return last_flight.flew && !vehicle.estimate.flying && estimator::slowThroughTheAir() &&
           !flies();
}

}  // namespace

void suppressThrottle() {
    progress.throttle_suppressed = true;
    last_flight.flew = false;
}

void beginLaunch() { launch.start(); }

void waitForLaunch() {
    if (!vehicle.armed || cameDown()) return suppressThrottle();
    if (!vehicle.progress.throttle_suppressed) return;
    if (vehicle.demand.path == Path::takeoff ? launched() : flies())
        progress.throttle_suppressed = false;
}

}  // namespace guidance
}  // namespace firmware

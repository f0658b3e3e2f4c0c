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

constexpr float kUnlaunchedHeight_m = 10;  // farther from the ground's height it must fly
constexpr float kFlyingSpeed_mps = 5, kStandingSpeed_mps = 2;
constexpr uint8_t kStands = 20;  // looks, 1 s

core::FileState<navigation::Launch> launch{};

struct OnTheGround {
    uint8_t looks;  // in a row
    bool known, stands;
    int32_t altitude_cm;  // above sea level; home may be moved, and lie at another height
};
core::FileState<OnTheGround> on_the_ground{};

bool fast() {
    const auto& estimate = vehicle.estimate;
    return vehicle.gps.fix >= GpsFix::two_d && estimate.ground_speed_mps >= kFlyingSpeed_mps &&
           (!vehicle.airspeed.healthy || estimate.airspeed_mps >= kFlyingSpeed_mps);
}

int32_t altitude_cm() {
    return vehicle.home.altitude_cm + core::rounded(vehicle.estimate.height_m * 100.0f);
}

float aboveGround_m() {
    if (!on_the_ground.known) return vehicle.estimate.height_m;
    return (altitude_cm() - on_the_ground.altitude_cm) * 0.01f;
}

bool faraway(float height_m) {
    return height_m > kUnlaunchedHeight_m || height_m < -kUnlaunchedHeight_m;
}

bool flies() { return fast() || faraway(aboveGround_m()); }

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
// Near the height of home alone: an airplane that hovers in a strong wind is slow as well.
bool stands() {
    const bool now = !vehicle.estimate.flying && vehicle.demand.path != Path::takeoff &&
                     vehicle.estimate.ground_speed_mps < kStandingSpeed_mps &&
                     estimator::slowThroughTheAir() && !fast() &&
                     !faraway(vehicle.estimate.height_m);
    on_the_ground.looks = now ? on_the_ground.looks + 1 : 0;
    return on_the_ground.looks >= kStands;
}

}  // namespace

void suppressThrottle() {
    progress.throttle_suppressed = true;
    on_the_ground.looks = 0;
}

void beginLaunch() { launch.start(); }

void noteGround() {
    const bool stands_now = vehicle.armed && !vehicle.estimate.flying;
    if (stands_now && !on_the_ground.stands && vehicle.home.set) {
        on_the_ground.known = true;
        on_the_ground.altitude_cm = altitude_cm();
    }
    if (!vehicle.armed) on_the_ground.known = false;
    on_the_ground.stands = stands_now;
}

void waitForLaunch() {
    if (!vehicle.armed || stands()) return suppressThrottle();
    if (!vehicle.progress.throttle_suppressed) return;
    if (vehicle.demand.path == Path::takeoff ? launched() : flies())
        progress.throttle_suppressed = false;
}

}  // namespace guidance
}  // namespace firmware

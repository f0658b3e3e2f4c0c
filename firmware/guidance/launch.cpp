// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/launch.hpp"

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/guidance/path_state.hpp"
#include "firmware/guidance/plan.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "navigation/takeoff.hpp"

namespace firmware {
namespace guidance {

using namespace notify;
using namespace state;

namespace {

constexpr int32_t kUnlaunchedHeight_cm = 1000;  // farther from the ground's height it must fly
constexpr float kFlyingSpeed_mps = 5, kStandingSpeed_mps = 2;
constexpr uint8_t kStands = 20;  // looks, 1 s
// Two sensors that both send nonsense agree for a moment. What has flown before flies at once.
constexpr uint8_t kFlies = 8;

core::FileState<navigation::Launch> launch{};

struct OnTheGround {
    uint8_t looks;  // in a row that show the other
    bool known, stands;
    int32_t altitude_cm;  // above sea level; home may be moved, and lie at another height
};
core::FileState<OnTheGround> on_the_ground{};

int32_t altitude_cm() {
    return vehicle.home.altitude_cm + core::inHundredths(vehicle.estimate.height_m);
}

// Of where it stood armed.
int32_t ground_cm() {
    return on_the_ground.known ? on_the_ground.altitude_cm : vehicle.home.altitude_cm;
}

bool faraway(int32_t altitude_cm, int32_t from_cm) {
    const int32_t height_cm = altitude_cm - from_cm;
    return height_cm > kUnlaunchedHeight_cm || height_cm < -kUnlaunchedHeight_cm;
}

// Where a fix is refused neither its place nor its speed is evidence of anything.
bool located() {
    const auto& estimate = vehicle.estimate;
    return !estimate.reckoned && !estimate.fix_refused && vehicle.gps.fix >= GpsFix::two_d;
}
bool slow() { return vehicle.estimate.ground_speed_mps < kStandingSpeed_mps; }

// Both heights: one that says otherwise may be wrong.
bool highAbove(int32_t from_cm) {
    return faraway(altitude_cm(), from_cm) && faraway(vehicle.gps.altitude_cm, from_cm);
}
bool seenToStand(int32_t from_cm) { return located() && slow() && !highAbove(from_cm); }

// On the ground each sensor alone has been wrong: a barometer that breaks, wind in the tube, a
// receiver whose fixes hop. So two must see it fly, and a receiver must not see it stand. Where
// there is one sensor alone the gyros must see it turn, or it must have flown before.
bool flies() {
    if (seenToStand(ground_cm())) return false;
    const bool has_tube = vehicle.airspeed.healthy;
    const bool in_the_wind = has_tube && vehicle.estimate.airspeed_mps >= kFlyingSpeed_mps;
    const bool fast = located() && (estimator::measuredGroundSpeed_mps() >= kFlyingSpeed_mps ||
                                    faraway(vehicle.gps.altitude_cm, ground_cm()));
    const bool high = faraway(altitude_cm(), ground_cm());
    if (in_the_wind + fast + high >= 2) return true;
    const bool turning = !has_tube && sensors::turns();
    if (located()) return fast && turning;
    return high && (turning || vehicle.estimate.flying);
}

// A take-off that a restart has cut short: there is no push any more, and no fix yet.
bool climbsAlready() {
    return vehicle.estimate.flying && faraway(altitude_cm(), ground_cm()) && flies();
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
        sendStatusText(Severity::warning, STATUS_TEXT("Bad launch AUTO"));
    if (result == navigation::Launch::slow)
        sendStatusText(Severity::warning, STATUS_TEXT("Timeout AUTO"));
    return result == navigation::Launch::flies;
}

// By a receiver that sees it stand, or without one. Near the height of the field alone: an airplane
// that hovers in a strong wind is slow as well. Home may have been set in the air.
bool standsOnTheField() {
    const int32_t here_cm = altitude_cm();
    const int32_t field_cm = here_cm - core::inHundredths(estimator::aboveField_m());
    return seenToStand(field_cm) ||
           (slow() && estimator::slowThroughTheAir() && !faraway(here_cm, field_cm));
}

// With the motor turning, elsewhere than in a take-off: it came down, or never left the ground.
bool stands() {
    return !vehicle.estimate.flying && vehicle.demand.path != Path::takeoff && !flies() &&
           standsOnTheField();
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
    if (!vehicle.armed) return suppressThrottle();
    const bool waits = vehicle.progress.throttle_suppressed;
    if (waits && vehicle.demand.path == Path::takeoff) {
        on_the_ground.looks = 0;
        progress.throttle_suppressed = !launched() && !climbsAlready();
        return;
    }
    const uint8_t enough = !waits ? kStands : vehicle.estimate.flying ? 1 : kFlies;
    on_the_ground.looks = (waits ? flies() : stands()) ? on_the_ground.looks + 1 : 0;
    if (on_the_ground.looks < enough) return;
    on_the_ground.looks = 0;
    progress.throttle_suppressed = !waits;
}

}  // namespace guidance
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/guidance.hpp"

#include <math.h>

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/guidance/bank.hpp"
#include "firmware/guidance/flights.hpp"
#include "firmware/guidance/height.hpp"
#include "firmware/guidance/host.hpp"
#include "firmware/guidance/lateral.hpp"
#include "firmware/guidance/launch.hpp"
#include "firmware/guidance/path_state.hpp"
#include "firmware/guidance/plan.hpp"
#include "firmware/guidance/steering.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

using namespace state;

namespace {

struct LastRun {
    Plan plan;     // of the last runGuidance
    bool guiding;  // in the run before as well
};
core::FileState<LastRun> last_run{};

constexpr float kSlowest_mps = 3;  // below, nothing is known of the air's direction

// In the order of Path.
using Flight = Plan (*)();
constexpr Flight kFlights[] ROM = {levelPlan, flyLeg, flyCircle, flyTakeoff, flyLanding};

void takeOver() {
    beginHeight();
    beginBanking();
    beginLateral();
    suppressThrottle();
}

void beginPath() {
    path_demand.new_path = false;
    progress.passed = progress.captured = progress.flaring = false;
    progress.turned_rad = 0;
    planLateral();
    beginCircling();
    beginLanding();
    if (vehicle.demand.path != Path::takeoff) return;
    beginLaunch();
    beginTakeoff();
}

// Into the wind as much faster through the air as the speed over ground is short of MIN_GNDSPD_CM,
// up to ARSPD_FBW_MAX.
void keepGroundSpeed(Plan& plan) {
    constexpr int16_t kLeast_cms = 300;
    constexpr uint16_t kBreeze_mps = core::sizeOfPower(2) + 0x40;  // 6, by the upper bits
    const int16_t least_cms = parameters.min_ground_speed_cms;
    const auto& estimate = core::based(vehicle.estimate);
    progress.blown_back = false;
    if (least_cms == 0) return;
    // 130 us of 20 runs a second, which no frame has to spare: not in a breeze, which leaves what
    // carries an airplane forward speed enough
    if (least_cms <= kLeast_cms && core::sizeOf(estimate.wind_mps.x) < kBreeze_mps &&
        core::sizeOf(estimate.wind_mps.y) < kBreeze_mps)
        return;
    if (progress.flaring || estimate.airspeed_mps < kSlowest_mps) return;
    const core::Vector3 air_mps = estimate.velocity_mps - estimate.wind_mps;
    const float forward_mps =
        (estimate.velocity_mps.x * air_mps.x + estimate.velocity_mps.y * air_mps.y) /
        estimate.airspeed_mps;
    progress.blown_back = core::isNegative(forward_mps);
    const float short_mps = core::hundredths(least_cms) - forward_mps;
    const float needed_mps =
        estimate.equivalent_airspeed_mps * (1 + short_mps / estimate.airspeed_mps);
    plan.airspeed_mps = fmaxf(plan.airspeed_mps, fminf(needed_mps, speedMax_mps()));
}

bool followsPath() {
    return last_run.guiding && guidesItself() && vehicle.demand.path != Path::none;
}

}  // namespace

void runGuidance() {
    noteGround();
    if (!guidesItself()) {
        last_run.guiding = false;
        steerNowhere();
        progress.throttle_suppressed = progress.flaring = progress.blown_back = false;
        return;
    }
    if (!last_run.guiding) takeOver();
    last_run.guiding = true;
    host.demandOfMode();
    if (vehicle.demand.new_path) beginPath();
    steerNowhere();
    last_run.plan = core::romRead(kFlights[static_cast<uint8_t>(vehicle.demand.path)])();
    keepGroundSpeed(last_run.plan);
    waitForLaunch();
    progress.height_error_m = last_run.plan.height.height_m - vehicle.estimate.height_m;
    progress.airspeed_error_mps =
        last_run.plan.airspeed_mps - vehicle.estimate.equivalent_airspeed_mps;
}

void runSpeedHeight() {
    if (!last_run.guiding || !guidesItself()) return;
    weighBank();
    if (vehicle.progress.throttle_suppressed)
        waitWithHeight(last_run.plan);
    else
        flyHeight(last_run.plan);
}

void runTargetBearing() {
    if (followsPath()) reportTargetBearing();
}
void runNavBearing() {
    if (followsPath()) reportCourse();
}
void runLateralGains() {
    if (followsPath()) beginLateral();
}

float demandedAirspeed_mps() { return last_run.plan.airspeed_mps; }

void shiftDemands(float by_m) {
    static constexpr float* kHeights[] ROM = {&path_demand.from_height_m, &path_demand.height_m,
                                              &last_run.plan.height.height_m};
    for (float* const& height_m : kHeights) *core::romRead(height_m) += by_m;
    shiftHeightFlown(by_m);
}

}  // namespace guidance
}  // namespace firmware

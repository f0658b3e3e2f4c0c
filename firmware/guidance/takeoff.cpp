// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/takeoff.hpp"

#include "core/file_state.hpp"
#include "firmware/guidance/bank.hpp"
#include "firmware/guidance/flights.hpp"
#include "firmware/guidance/lateral.hpp"
#include "firmware/guidance/steering.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

using namespace state;

namespace {

constexpr float kRunway_m = 1.5f;  // the barometer is not more certain of the ground

core::FileState<navigation::TakeoffCourse> course{};

float pitch_rad() {
    const bool measured = vehicle.airspeed.healthy;
    const float speed_mps =
        measured ? vehicle.estimate.equivalent_airspeed_mps : vehicle.estimate.ground_speed_mps;
    const navigation::TakeoffPitch pitch = {vehicle.demand.takeoff_pitch_rad,
                                            parameters.takeoff_rotate_mps, speedMin_mps(),
                                            vehicle.demand.airspeed_mps};
    return navigation::takeoffPitch_rad(pitch, speed_mps, measured);
}

}  // namespace

void beginTakeoff() { course.start(vehicle.attitude.yaw_rad.toFloat()); }

Plan flyTakeoff() {
    const auto now = motion();
    course.run(now.velocity_mps, vehicle.estimate.ground_speed_mps,
               vehicle.attitude.yaw_rad.toFloat(), kGuidancePeriod_s);
    float accel_mss = 0;
    if (course.locked())
        accel_mss = navigation::followCourse(lateralGains(), now, course.course()).bank_accel_mss;
    demandBank(accel_mss, BankLimit::level);
    const bool thrown = core::isPositive(parameters.takeoff_min_accel_mss);
    if (!thrown && vehicle.estimate.height_m < kRunway_m) steadyNose();
    Plan to_fly = levelPlan();
    to_fly.phase = ::control::Phase::climb_out;
    to_fly.pitch_min_rad = pitch_rad();
    return to_fly;
}

}  // namespace guidance
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance.hpp"

#include <math.h>

#include "control/slew.hpp"
#include "control/speed_height.hpp"
#include "core/rom.hpp"
#include "firmware/modes.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"
#include "navigation/l1.hpp"
#include "navigation/landing.hpp"
#include "navigation/takeoff.hpp"

namespace firmware {
namespace {

constexpr float kPeriod_s = 0.05f;       // 20 Hz
constexpr float kHeightPeriod_s = 0.1f;  // 10 Hz
constexpr float kBankLoop_s = 0.1f;      // what servo and airframe add to RLL2SRV_TCONST
constexpr float kTurnShare = 0.7f;       // of the bank limit, for planned turns
constexpr float kSlowBank_mss = 0.4663f * core::kGravity_mss;  // 25 degrees below flying speed
constexpr float kUnlaunchedHeight_m = 10;  // farther from home's height the airplane must fly
constexpr float kFlyingSpeed_mps = 5;
constexpr float kMostForHeadwind_mps = 3;
constexpr float kApproachShare = 0.65f;    // of the way from the lowest speed to cruise
constexpr float kLandingAlpha_rad = 0.2f;  // no more angle of attack near the ground

control::SpeedHeight speed_height;
navigation::Landing landing;
navigation::Launch launch;
navigation::TakeoffCourse takeoff_course;
navigation::TurnCount turns;
navigation::BankTrim bank_trim;
bool guiding;  // in the run before as well
bool bearing_turn;
geo::Offset nav_course;
float carried_bank_mss;  // see carriedBank_mss
float turn_accel_mss;    // of planned turns

struct Plan {  // what lateral guidance leaves for the height
    navigation::HeightDemand height;
    control::Phase phase;
    float pitch_min_rad;
    float airspeed_mps;
};

Plan plan;  // of the last runGuidance

float cruisePitchMin_rad() { return core::radiansFromCentidegrees(parameters.pitch_min_cd); }

float bankLimit_rad(bool level) {
    return level ? core::radians(parameters.level_roll_limit_deg)
                 : core::radiansFromCentidegrees(parameters.roll_limit_cd);
}

// The bank whose load the wings still carry at this speed: lift grows with its square.
float carriedBank_mss() {
    if (!vehicle.airspeed.healthy) return 1e3f;
    const float ratio = vehicle.estimate.equivalent_airspeed_mps / parameters.speed_min_mps;
    const float load = core::square(ratio);
    const float tangent2 = load * load - 1;
    const float accel_mss = tangent2 > 0 ? core::kGravity_mss * sqrtf(tangent2) : 0;
    return accel_mss > kSlowBank_mss ? accel_mss : kSlowBank_mss;
}

float presentBank_mss() {
    const float cosine = core::limit(vehicle.attitude.cos_roll, 0.3f, 1.0f);
    return core::kGravity_mss * core::limit(vehicle.attitude.sin_roll / cosine, -2.0f, 2.0f);
}

navigation::Motion motion() {
    const auto& estimate = vehicle.estimate;
    navigation::Motion motion;
    motion.position = estimate.position;
    motion.velocity_mps = {estimate.velocity_mps.x, estimate.velocity_mps.y};
    motion.wind_mps = {estimate.wind_mps.x, estimate.wind_mps.y};
    motion.bank_accel_mss = presentBank_mss() - bank_trim.accel_mss();
    motion.bank_lag_s = parameters.roll.axis.time_constant_s + kBankLoop_s;
    motion.turn_accel_mss = turn_accel_mss;
    return motion;
}

float dot(const geo::Offset& a, const geo::Offset& b) {
    return a.north_m * b.north_m + a.east_m * b.east_m;
}

void bank(float bank_accel_mss, bool level) {
    const float limit_rad = bankLimit_rad(level);
    const float accel_mss =
        core::limit(bank_accel_mss + bank_trim.accel_mss(), -carried_bank_mss, carried_bank_mss);
    vehicle.roll_demand_rad =
        core::limit(navigation::bankFor_rad(accel_mss), -limit_rad, limit_rad);
}

// In turns, each five times a second.
void tellBearings() {
    auto& progress = vehicle.progress;
    bearing_turn = !bearing_turn;
    if (bearing_turn)
        progress.target_bearing_cd = geo::bearing_cd(vehicle.estimate.position, vehicle.demand.to);
    else
        progress.nav_bearing_cd =
            core::wrap360_cd(core::rounded(core::centidegrees(geo::bearing_rad(nav_course))));
}

void tellLateral(const navigation::Lateral& lateral) {
    auto& progress = vehicle.progress;
    progress.distance_m = lateral.distance_m;
    progress.crosstrack_m = lateral.crosstrack_m;
    nav_course = lateral.course;
}

// CONDITION_CHANGE_ALT: from_height_m is what moves, as long as there is a rate.
navigation::HeightDemand changingHeight() {
    auto& demand = vehicle.demand;
    if (demand.climb_rate_mps <= 0) return {demand.height_m, 0};
    const float before_m = demand.from_height_m;
    demand.from_height_m =
        control::slewed(before_m, demand.height_m, demand.climb_rate_mps * kPeriod_s);
    return {demand.from_height_m, (demand.from_height_m - before_m) / kPeriod_s};
}

Plan levelPlan() {
    return {changingHeight(), control::Phase::cruise, cruisePitchMin_rad(),
            vehicle.demand.airspeed_mps};
}

navigation::Lateral fliesLeg(const navigation::Motion& now) {
    const auto& demand = vehicle.demand;
    const auto lateral = navigation::followLeg(parameters.lateral, now, demand.from, demand.to);
    tellLateral(lateral);
    vehicle.progress.passed = lateral.along_m >= lateral.length_m;
    if (!landing.flaring()) bank_trim.learn(-lateral.crosstrack_m, kPeriod_s);
    return lateral;
}

float along_mps(const navigation::Lateral& lateral, const navigation::Motion& now) {
    // close to the leg the demanded course is the leg's
    return core::limit(dot(lateral.course, now.velocity_mps), 0.0f, 100.0f);
}

Plan flyLeg() {
    const auto& demand = vehicle.demand;
    const auto now = motion();
    const auto lateral = fliesLeg(now);
    bank(lateral.bank_accel_mss, false);
    Plan to_fly = levelPlan();
    if (demand.sloped)
        to_fly.height =
            navigation::heightOnSlope(demand.from_height_m, demand.height_m, lateral.length_m,
                                      lateral.along_m, along_mps(lateral, now));
    return to_fly;
}

Plan flyCircle() {
    const auto& demand = vehicle.demand;
    const navigation::Circle circle = {demand.to, demand.radius_m, demand.counter_clockwise};
    const auto lateral = navigation::followCircle(parameters.lateral, motion(), circle);
    tellLateral(lateral);
    bank(lateral.bank_accel_mss, false);
    turns.update(circle, geo::offset(circle.centre, vehicle.estimate.position),
                 lateral.crosstrack_m);
    const float outside_m = lateral.crosstrack_m;
    bank_trim.learn(circle.counter_clockwise ? -outside_m : outside_m, kPeriod_s);
    vehicle.progress.captured = turns.captured();
    vehicle.progress.turned_rad = turns.turned_rad();
    return levelPlan();
}

Plan flyTakeoff() {
    const auto now = motion();
    takeoff_course.run(now.velocity_mps, vehicle.estimate.ground_speed_mps,
                       vehicle.attitude.yaw_rad, kPeriod_s);
    float accel_mss = 0;
    if (takeoff_course.locked())
        accel_mss = navigation::followCourse(parameters.lateral, now, takeoff_course.course())
                        .bank_accel_mss;
    bank(accel_mss, true);
    const bool measured = vehicle.airspeed.healthy;
    const float speed_mps =
        measured ? vehicle.estimate.equivalent_airspeed_mps : vehicle.estimate.ground_speed_mps;
    const navigation::TakeoffPitch pitch = {
        vehicle.demand.takeoff_pitch_rad, parameters.takeoff_rotate_mps,
        static_cast<float>(parameters.speed_min_mps), vehicle.demand.airspeed_mps};
    Plan to_fly = levelPlan();
    to_fly.phase = control::Phase::climb_out;
    to_fly.pitch_min_rad = navigation::takeoffPitch_rad(pitch, speed_mps, measured);
    return to_fly;
}

// Between the lowest speed and cruise: slow enough to land, fast enough to flare. Half the headwind
// is added, for near the ground it is gone.
float approachSpeed_mps(float cruise_mps, float along_mps) {
    const float headwind_mps = vehicle.estimate.airspeed_mps - along_mps;
    return parameters.speed_min_mps + kApproachShare * (cruise_mps - parameters.speed_min_mps) +
           core::limit(0.5f * headwind_mps, 0.0f, kMostForHeadwind_mps);
}

Plan flyLanding() {
    const auto& demand = vehicle.demand;
    const auto now = motion();
    const auto lateral = fliesLeg(now);
    const navigation::LandingSettings settings = {parameters.flare_height_m, parameters.flare_s,
                                                  parameters.speed_height.land_sink_mps};
    const navigation::Approach approach = {demand.from_height_m - demand.height_m,
                                           lateral.length_m,
                                           lateral.along_m,
                                           along_mps(lateral, now),
                                           vehicle.estimate.height_m - demand.height_m,
                                           -vehicle.estimate.climb_mps};
    const auto height = landing.run(settings, approach);
    vehicle.progress.flaring = landing.flaring();
    bank(lateral.bank_accel_mss, landing.flaring());
    Plan to_fly = levelPlan();
    to_fly.height = {height.height_m + demand.height_m, height.climb_mps};
    to_fly.airspeed_mps = approachSpeed_mps(to_fly.airspeed_mps, approach.along_mps);
    to_fly.phase = control::Phase::approach;
    if (landing.flaring()) {
        to_fly.phase = control::Phase::flare;
        to_fly.pitch_min_rad = core::radiansFromCentidegrees(parameters.land_pitch_cd);
    }
    return to_fly;
}

// In the order of Path.
using Flight = Plan (*)();
constexpr Flight kFlights[] ROM = {levelPlan, flyLeg, flyCircle, flyTakeoff, flyLanding};

float pathAngle_rad() {
    const auto& estimate = vehicle.estimate;
    const float airspeed_mps = core::limit(estimate.airspeed_mps, 3.0f, 100.0f);
    return core::limit(estimate.climb_mps / airspeed_mps, -0.8f, 0.8f);
}

// Along the path, from what the accelerometer feels: lift acts across the path, so only the angle
// of attack's share of it is left, and gravity's.
float pathAcceleration_mss() {
    const auto& attitude = vehicle.attitude;
    const float path_rad = pathAngle_rad();
    const float cosine = core::limit(attitude.cos_roll, 0.3f, 1.0f);
    const float alpha_rad = core::limit((attitude.pitch_rad - path_rad) / cosine, -0.3f, 0.3f);
    return vehicle.imu.accel_mss.x + vehicle.imu.accel_mss.z * alpha_rad -
           core::kGravity_mss * path_rad;
}

control::SpeedHeightMeasured measured() {
    const auto& estimate = vehicle.estimate;
    return {estimate.height_m,      estimate.climb_mps,        estimate.airspeed_mps,
            pathAcceleration_mss(), vehicle.attitude.cos_roll, vehicle.airspeed.healthy};
}

// Airspeeds are demanded as the wing feels them; energy is made of true ones.
float trueFromEquivalent() {
    const auto& estimate = vehicle.estimate;
    if (estimate.equivalent_airspeed_mps < kFlyingSpeed_mps) return 1;
    return core::limit(estimate.airspeed_mps / estimate.equivalent_airspeed_mps, 0.8f, 2.0f);
}

control::SpeedHeightLimits limits(float true_speed) {
    const bool climb_out = plan.phase == control::Phase::climb_out;
    const int8_t most_pct = climb_out && parameters.takeoff_throttle_max_pct > 0
                                ? parameters.takeoff_throttle_max_pct
                                : parameters.throttle_max_pct;
    control::SpeedHeightLimits limits;
    limits.pitch_min_rad = plan.pitch_min_rad;
    limits.pitch_max_rad = core::radiansFromCentidegrees(parameters.pitch_max_cd);
    const bool landing_now =
        plan.phase == control::Phase::approach || plan.phase == control::Phase::flare;
    if (landing_now)
        limits.pitch_max_rad =
            core::limit(pathAngle_rad() + kLandingAlpha_rad, 0.0f, limits.pitch_max_rad);
    if (limits.pitch_max_rad < limits.pitch_min_rad) limits.pitch_max_rad = limits.pitch_min_rad;
    // without the sensor there is no speed to fly: the pitch is the one of the take-off
    if (climb_out && !vehicle.airspeed.healthy) limits.pitch_max_rad = plan.pitch_min_rad;
    limits.throttle_min = parameters.throttle_min_pct * 0.01f;
    limits.throttle_max = most_pct * 0.01f;
    limits.throttle_cruise = vehicle.demand.throttle_pct * 0.01f;
    limits.throttle_slew =
        parameters.throttle_slew_pct > 0 ? parameters.throttle_slew_pct * 0.01f : 100.0f;
    limits.airspeed_min_mps = parameters.speed_min_mps * true_speed;
    limits.airspeed_max_mps = parameters.speed_max_mps * true_speed;
    return limits;
}

// A stick above its middle asks for more speed, all of it for the highest.
float nudged_mps(float airspeed_mps) {
    const int8_t above_pct = vehicle.radio.throttle_pct - 50;
    if (parameters.throttle_nudge == 0 || vehicle.radio.lost || above_pct <= 0) return airspeed_mps;
    return airspeed_mps + (parameters.speed_max_mps - airspeed_mps) * (above_pct * 0.02f);
}

bool launched() {
    const auto& estimate = vehicle.estimate;
    if (vehicle.demand.path != Path::takeoff) {
        const bool fast = vehicle.gps.fix >= GpsFix::two_d &&
                          estimate.ground_speed_mps >= kFlyingSpeed_mps &&
                          (!vehicle.airspeed.healthy || estimate.airspeed_mps >= kFlyingSpeed_mps);
        return fast || estimate.height_m > kUnlaunchedHeight_m ||
               estimate.height_m < -kUnlaunchedHeight_m;
    }
    if (vehicle.gps.fix != GpsFix::three_d) return false;
    const navigation::LaunchSettings settings = {parameters.takeoff_min_speed_mps,
                                                 parameters.takeoff_min_accel_mss,
                                                 parameters.takeoff_delay_ds};
    const navigation::LaunchState now = {
        vehicle.imu.accel_mss.x - core::kGravity_mss * vehicle.attitude.sin_pitch,
        estimate.ground_speed_mps, vehicle.attitude.roll_rad, vehicle.attitude.pitch_rad,
        kPeriod_s};
    return launch.run(settings, now);
}

void beginPath() {
    vehicle.demand.new_path = false;
    vehicle.progress.passed = vehicle.progress.captured = vehicle.progress.flaring = false;
    vehicle.progress.turned_rad = 0;
    turn_accel_mss = kTurnShare * core::kGravity_mss * tanf(bankLimit_rad(false));
    turns.start();
    landing.start();
    if (vehicle.demand.path != Path::takeoff) return;
    launch.start();
    takeoff_course.start(vehicle.attitude.yaw_rad);
}

void takeOver() {
    speed_height.start(measured(), vehicle.attitude.pitch_rad, vehicle.throttle_demand);
    bank_trim.start();
    carried_bank_mss = carriedBank_mss();
    vehicle.progress.throttle_suppressed = true;
}

// The motor waits for the launch: it does not start on the ground because a mode was chosen.
void waitForLaunch() {
    auto& suppressed = vehicle.progress.throttle_suppressed;
    if (!vehicle.armed) suppressed = true;
    if (suppressed && vehicle.armed && launched()) suppressed = false;
}

}  // namespace

void runGuidance() {
    if (!guidesItself()) {
        guiding = false;
        vehicle.progress.throttle_suppressed = false;
        return;
    }
    if (!guiding) takeOver();
    guiding = true;
    if (vehicle.demand.new_path) beginPath();
    plan = core::romRead(kFlights[static_cast<uint8_t>(vehicle.demand.path)])();
    waitForLaunch();
    vehicle.progress.height_error_m = plan.height.height_m - vehicle.estimate.height_m;
    vehicle.progress.airspeed_error_mps =
        plan.airspeed_mps - vehicle.estimate.equivalent_airspeed_mps;
}

void runSpeedHeight() {
    if (!guiding || !guidesItself()) return;
    if (vehicle.demand.path != Path::none) tellBearings();
    carried_bank_mss = carriedBank_mss();
    const auto now = measured();
    if (vehicle.progress.throttle_suppressed) {
        speed_height.start(now, 0, 0);
        vehicle.pitch_demand_rad = plan.phase == control::Phase::climb_out ? plan.pitch_min_rad : 0;
        vehicle.throttle_demand = 0;
        return;
    }
    const float true_speed = trueFromEquivalent();
    const control::SpeedHeightDemand demand = {plan.height.height_m, plan.height.climb_mps,
                                               nudged_mps(plan.airspeed_mps) * true_speed};
    const auto out = speed_height.run(parameters.speed_height, limits(true_speed), demand, now,
                                      plan.phase, kHeightPeriod_s);
    vehicle.pitch_demand_rad = out.pitch_rad;
    vehicle.throttle_demand = out.throttle;
}

}  // namespace firmware

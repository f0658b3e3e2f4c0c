// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/estimator.hpp"

#include "core/maths.hpp"
#include "estimation/arc.hpp"
#include "estimation/atmosphere.hpp"
#include "estimation/attitude.hpp"
#include "estimation/height.hpp"
#include "estimation/position.hpp"
#include "estimation/wind.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace {

using core::Vector3;

estimation::Attitude attitude;
estimation::Height height;
estimation::Position position;
estimation::Wind wind;

bool started;
bool height_started;
float home_height_m;  // of home above where the barometer was zeroed
float true_speed_ratio = 1.0f;
uint32_t baro_us, fix_ms, unfixed_ms;
uint8_t gathered;   // sample periods since motion was last carried on
float baro_sum_pa;  // of baro_readings
uint8_t baro_readings;

constexpr uint16_t kGpsSilent_ms = 500;
constexpr uint16_t kAirspeedHelps_ms = 200;
constexpr uint8_t kBeginsFlying = 13;  // looks of 40 ms at speed: half a second
constexpr uint8_t kEndsFlying = 75;    // looks without: three seconds
constexpr float kFlyingGroundSpeed_mps = 5.0f;
constexpr float kStandingSpeed_mps = 2.0f;

estimation::AttitudeSettings attitudeSettings() {
    estimation::AttitudeSettings settings;
    settings.declination_rad = parameters.compass_declination_rad;
    settings.use_compass = parameters.compass_use != 0;
    return settings;
}

// A fix costs too much for one frame: each of its uses gets one.
enum class FixUse : uint8_t { move, feel_wind, done };
FixUse fix_use = FixUse::done;
float since_fix_s;  // from the fix before

// Since its bytes arrived a fix has aged.
float gpsAge_s(float when_received_s, uint32_t now_ms) {
    return when_received_s + (now_ms - vehicle.gps.received_ms) * 0.001f;
}

void alignToFix(uint32_t now_ms) {
    vehicle.gps.fresh = false;
    if (vehicle.gps.fix != GpsFix::three_d) return;
    since_fix_s = (now_ms - fix_ms) * 0.001f;
    fix_ms = now_ms;
    estimation::AttitudeSettings settings = attitudeSettings();
    settings.gps_age_s = gpsAge_s(settings.gps_age_s, now_ms);
    attitude.useGps(vehicle.gps.velocity_mps, settings);
    fix_use = FixUse::move;
}

void moveToFix(uint32_t now_ms) {
    fix_use = FixUse::feel_wind;
    estimation::PositionSettings settings;
    settings.gps_age_s = gpsAge_s(settings.gps_age_s, now_ms);
    position.useGps(vehicle.gps.position, vehicle.gps.velocity_mps, attitude.gainedSinceFix_mps(),
                    settings);
}

void feelWind() {
    fix_use = FixUse::done;
    if (!vehicle.estimate.flying || since_fix_s > 1.0f) return;
    const float airspeed_mps = vehicle.airspeed.healthy ? vehicle.estimate.airspeed_mps : 0.0f;
    wind.update(vehicle.gps.velocity_mps, {attitude.noseNorth(), attitude.noseEast()}, airspeed_mps,
                since_fix_s);
    vehicle.estimate.wind_mps = wind.wind_mps();
}

void gatherBarometer() {
    if (!vehicle.baro.fresh) return;
    vehicle.baro.fresh = false;
    baro_sum_pa += vehicle.baro.pressure_pa;
    ++baro_readings;
}

// The mean of what came in four frames.
void useBarometer() {
    if (baro_readings == 0) return;
    const auto& baro = vehicle.baro;
    const float reading_m = estimation::pressureHeight_m(
        baro_sum_pa / baro_readings, baro.ground_pressure_pa, baro.ground_temperature_c);
    baro_sum_pa = 0;
    baro_readings = 0;
    vehicle.baro.height_m = reading_m;
    const uint32_t now_us = hal::now_us();
    if (height_started) {
        height.useBarometer(reading_m, (now_us - baro_us) * 1e-6f, estimation::HeightSettings());
    } else {
        height.start(reading_m);
        height_started = true;
    }
    baro_us = now_us;
}

// On the ground before the first fix 0 lets the filter settle; in flight it would hold the turn's
// acceleration for gravity.
float knownAirspeed_mps() {
    if (vehicle.airspeed.healthy) return vehicle.estimate.airspeed_mps;
    return vehicle.estimate.flying ? parameters.cruise_speed_cms * 0.01f : 0.0f;
}

// One a frame.
void useReference() {
    const uint32_t now_ms = hal::now_ms();
    if (vehicle.gps.fresh) {
        alignToFix(now_ms);
    } else if (fix_use == FixUse::move) {
        moveToFix(now_ms);
    } else if (fix_use == FixUse::feel_wind) {
        feelWind();
    } else if (vehicle.compass.fresh) {
        vehicle.compass.fresh = false;
        attitude.useCompass(vehicle.compass.field_mg, attitudeSettings());
    } else if (now_ms - fix_ms > kGpsSilent_ms && now_ms - unfixed_ms >= kAirspeedHelps_ms) {
        unfixed_ms = now_ms;
        attitude.useAirspeed(knownAirspeed_mps());
    }
}

// The attitude gives a new acceleration every fourth frame.
void propagateMotion() {
    const Vector3& acceleration_mss = attitude.acceleration_mss();
    const float dt_s = gathered * estimation::kSamplePeriod_s;
    position.propagate(acceleration_mss, dt_s);
    height.propagate(-acceleration_mss.z, dt_s);
    gathered = 0;
}

int16_t centimetres(float metres) { return core::narrowed(core::rounded(metres * 100.0f)); }
float metres(int16_t centimetres) { return centimetres * 0.01f; }

void publishAttitude() {
    const estimation::Angles& angles = attitude.angles();
    auto& to = vehicle.attitude;
    to.roll_rad = angles.roll_rad;
    to.pitch_rad = angles.pitch_rad;
    to.yaw_rad = angles.yaw_rad;
    to.sin_roll = angles.sin_roll;
    to.cos_roll = angles.cos_roll;
    to.sin_pitch = angles.sin_pitch;
    to.cos_pitch = angles.cos_pitch;
    to.rate_rads = attitude.rate_rads();
    to.aligned = attitude.aligned();
}

void publishMotion() {
    auto& to = vehicle.estimate;
    to.known = position.known();
    to.velocity_mps = position.velocity_mps();
    to.height_m = height.height_m() - home_height_m;
    to.climb_mps = height.climb_mps();
}

void publishSpeeds() {
    auto& to = vehicle.estimate;
    to.position = position.position();
    const Vector3& velocity = to.velocity_mps;
    to.ground_speed_mps = sqrtf(core::square(velocity.x) + core::square(velocity.y));
    if (to.ground_speed_mps > 0.01f) {
        const float inverse = 1.0f / to.ground_speed_mps;
        to.course_cd = core::wrap360_cd(core::rounded(
            core::centidegrees(estimation::arc_rad(velocity.y * inverse, velocity.x * inverse))));
    }
    if (vehicle.airspeed.healthy) {
        to.equivalent_airspeed_mps = vehicle.airspeed.speed_mps;
        to.airspeed_mps = vehicle.airspeed.speed_mps * true_speed_ratio;
    } else {
        to.airspeed_mps = wind.airspeed_mps(velocity);
        to.equivalent_airspeed_mps = to.airspeed_mps / true_speed_ratio;
    }
}

// Flying: armed, and fast enough for half a second; standing: slow for three seconds.
void judgeFlying() {
    static uint8_t looks;
    auto& estimate = vehicle.estimate;
    const bool fast = vehicle.airspeed.healthy
                          ? vehicle.airspeed.speed_mps > 0.75f * parameters.speed_min_mps
                          : estimate.ground_speed_mps > kFlyingGroundSpeed_mps;
    const bool slow =
        estimate.ground_speed_mps < kStandingSpeed_mps && fabsf(estimate.climb_mps) < 0.5f;
    const bool changes = estimate.flying ? slow || !vehicle.armed : fast && vehicle.armed;
    looks = changes ? looks + 1 : 0;
    if (looks < (estimate.flying ? kEndsFlying : kBeginsFlying)) return;
    estimate.flying = !estimate.flying;
    looks = 0;
}

}  // namespace

void runEstimator() {
    if (!vehicle.imu.calibrated || vehicle.imu.periods == 0) return;
    if (!started) {
        attitude.start();
        wind.start();
        started = true;
    }
    const auto& imu = vehicle.imu;
    attitude.propagate({imu.turned, imu.rate_rads, imu.accel_mss, imu.periods});
    publishAttitude();
    gathered = imu.periods > 0xFF - gathered ? 0xFF : gathered + imu.periods;
    gatherBarometer();
    switch (attitude.frame() & 3) {
        case 1:
            propagateMotion();
            publishMotion();
            break;
        case 3:
            useBarometer();
            publishMotion();
            publishSpeeds();
            judgeFlying();
            break;
        default:
            useReference();
    }
}

Vector3 gyroDrift_rads() { return attitude.bias_rads(); }

void zeroHeight() {
    home_height_m = height.height_m();
    vehicle.estimate.height_m = 0;
    true_speed_ratio =
        estimation::trueSpeedRatio(vehicle.baro.pressure_pa, vehicle.baro.temperature_c);
}

void shiftHeight(float by_m) {
    home_height_m -= by_m;
    vehicle.estimate.height_m += by_m;
}

// A place without a fix since then counts as one that is as old as the record.
void resumeEstimate(const SteadyRecord& steady, const MovingRecord& moving, float lost_s) {
    const auto& rate = moving.rate_rads;
    const Vector3 rate_rads = {rate.x, rate.y, rate.z};
    attitude.resume(moving.pose, steady.learnt, rate_rads * lost_s);
    home_height_m = steady.home_height_m;
    height.resume(home_height_m + moving.height_m, metres(moving.velocity_cms[2]));
    height_started = started = true;
    baro_us = hal::now_us();
    true_speed_ratio =
        estimation::trueSpeedRatio(steady.ground_pressure_pa, steady.ground_temperature_c);
    if (moving.wind_known) wind.resume(metres(steady.wind_cms[0]), metres(steady.wind_cms[1]));
    vehicle.estimate.wind_mps = wind.wind_mps();
    vehicle.estimate.flying = true;
    if (!moving.place_known) return;
    estimation::PositionSettings settings;
    settings.gps_age_s = lost_s;
    position.useGps(moving.position,
                    {metres(moving.velocity_cms[0]), metres(moving.velocity_cms[1]), 0}, {0, 0, 0},
                    settings);
}

void keepEstimate(SteadyRecord& to) {
    attitude.keep(to.learnt);
    to.home_height_m = home_height_m;
    const Vector3 wind_mps = wind.wind_mps();
    to.wind_cms[0] = centimetres(wind_mps.x);
    to.wind_cms[1] = centimetres(wind_mps.y);
}

void keepEstimate(MovingRecord& to) {
    const auto& estimate = vehicle.estimate;
    attitude.keep(to.pose);
    to.rate_rads = attitude.rate_rads();
    to.position = estimate.position;
    to.place_known = estimate.known;
    to.wind_known = wind.known();
    to.velocity_cms[0] = centimetres(estimate.velocity_mps.x);
    to.velocity_cms[1] = centimetres(estimate.velocity_mps.y);
    to.velocity_cms[2] = centimetres(estimate.climb_mps);
    to.height_m = estimate.height_m;
}

}  // namespace firmware

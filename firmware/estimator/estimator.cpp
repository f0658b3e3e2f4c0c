// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/estimator/estimator.hpp"

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/internal_error.hpp"
#include "core/maths.hpp"
#include "estimation/atan2_table.hpp"
#include "estimation/atmosphere.hpp"
#include "estimation/attitude.hpp"
#include "estimation/barometer_drift.hpp"
#include "estimation/gps_delay.hpp"
#include "estimation/height.hpp"
#include "estimation/position.hpp"
#include "estimation/wind.hpp"
#include "firmware/sensors/compass_learning.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/clock.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<AttitudeState> : Writable<AttitudeState> {
    using Writable::state;
};
template <>
struct Publisher<EstimateState> : Writable<EstimateState> {
    using Writable::state;
};
}  // namespace state

namespace estimator {

using namespace state;
using namespace sensors;

namespace {

constexpr AttitudeState& published_attitude = Publisher<AttitudeState>::state();
constexpr EstimateState& published = Publisher<EstimateState>::state();

using core::Vector3;

core::FileState<estimation::Attitude> attitude{};
core::FileState<estimation::Height> height{};
core::FileState<estimation::BarometerDrift> barometer_drift{};
core::FileState<estimation::Position> position{};
core::FileState<estimation::Wind> wind{};
core::FileState<estimation::FixComparison> fix_comparison{};
core::FileState<estimation::GpsDelay> gps_delay{};

struct Motion {
    bool started;
    uint8_t imu_gap;         // frames without its samples
    bool waits_for_imu;      // since a restart in the air
    uint8_t gathered;        // sample periods since motion was last carried on
    uint8_t flying_changes;  // looks in a row at which `flying` is wrong
    uint8_t compass_seen;    // of the compass' counter
    bool across_course;      // see liesAcrossCourse
};
core::FileState<Motion> motion{};

struct Heights {
    bool started;
    bool by_gps;        // started by the receiver: the barometer has not been heard yet
    bool heard;         // the barometer, since the start
    float home_m;       // of home above the barometer's zero, which drifts
    float gps_above_m;  // the receiver's heights over the estimate's; 0: no fix has been seen
    float home_above_field_m;  // home may be set in the air, the field is where it was zeroed
};
core::FileState<Heights> heights{};

struct Pressure {
    int32_t sum_pa;  // of the readings since it was last used
    uint8_t readings;
    uint8_t seen;  // of the sensor's counter
    uint16_t used_ms;
};
core::FileState<Pressure> pressure{};

// Apart from the zeros, which need no copy in flash.
struct TrueSpeed {
    float ratio = 1.0f;     // to the equivalent one
    float on_field = 1.0f;  // by the sensor's temperature, which a warm board makes too high
};
core::FileState<TrueSpeed> true_speed{};

// Frames without samples after which the attitude is lost: that long no airplane turns far. When
// the power was lost the sensor needs 0.2 s to start, and an attitude half a second old is better
// than one found anew in a turn, which takes seconds.
constexpr uint8_t kDead = 20, kDeadAfterRestart = 50;
constexpr uint8_t kFramePeriods = 2;  // of a sample
constexpr float kInconsistentAirspeed_mps = 4,
                kInconsistentAirspeed = 0.3f;  // and this share of what is expected
constexpr float kInconsistentHeight_m = 20;
constexpr float kPressureAge_s = 0.025f;  // the mean of what came in 50 ms
constexpr uint16_t kGoodHdop_c = 200;     // with fewer satellites heights are tens of metres off
constexpr float kSilentIntervals = 1.5f, kLeastInterval_s = 0.33f, kMaxInterval_s = 1.1f;
constexpr uint8_t kBeginsFlying = 5;  // looks of 100 ms at speed: half a second
constexpr uint8_t kEndsFlying = 30;   // looks without: three seconds
constexpr float kFlyingGroundSpeed_mps = 5.0f;
constexpr float kStandingSpeed_mps = 2.0f;
constexpr float kNearField_m = 10;
constexpr core::Ratio kClimbThrottle(0.3f);  // less holds no airplane at a height

estimation::AttitudeSettings attitudeSettings() {
    estimation::AttitudeSettings settings;
    settings.declination_rad = parameters.compass_declination_rad;
    settings.use_compass = parameters.compass_use != 0 && vehicle.compass.healthy;
    return settings;
}

// Each use of a fix has a row of its own, because all of them cost too much for one. True: this use
// has not been made of the newest fix.
struct FixUses {
    bool position, wind, height, delay;
};
core::FileState<FixUses> fix_for{};

struct NewestFix {
    uint32_t ms;
    float since_s;                 // from the fix before
    uint16_t latitude, longitude;  // their lower bits
    uint8_t seen;                  // of the receiver's counter
};
core::FileState<NewestFix> newest_fix{};

bool imuDead() { return motion.imu_gap >= (motion.waits_for_imu ? kDeadAfterRestart : kDead); }

// Rows of the schedule rest until the gyros' zero is known, and while it is measured again.
bool runs() { return motion.started && vehicle.imu.calibrated; }

// Since its bytes arrived a fix has aged.
float gpsAge_s(uint32_t now_ms) {
    const uint32_t waited_ms = now_ms - vehicle.gps.received_ms;
    if (parameters.gps_delay_ms > 0) return (waited_ms + parameters.gps_delay_ms) * 0.001f;
    return (waited_ms + vehicle.gps.age_ms) * 0.001f + gps_delay.correction_s();
}

// The last bits of the place change even while the velocity does not.
bool fixIsGood() {
    const auto& gps = vehicle.gps;
    const float sum_cms = (gps.velocity_mps.x + gps.velocity_mps.y) * 100;
    if (gps.fix != GpsFix::three_d || !acceptReading(Sensor::gps, core::toFixed(sum_cms, 0), true))
        return false;
    // a quiet receiver repeats its velocity in calm air, and one that is stuck its place as well
    const auto latitude = static_cast<uint16_t>(gps.position.latitude_e7);
    const auto longitude = static_cast<uint16_t>(gps.position.longitude_e7);
    if (latitude != newest_fix.latitude || longitude != newest_fix.longitude)
        reportChange(Sensor::gps);
    newest_fix.latitude = latitude;
    newest_fix.longitude = longitude;
    return !isFaulty(Sensor::gps);
}

// Without its compass the airplane points where it flies to through the air, as the wind was.
bool pointsByCourse() {
    if (parameters.compass_use == 0 || vehicle.compass.healthy) return false;
    attitude.useCourse(position.velocity_mps() - wind.wind_mps());
    return true;
}

// Nose down at full throttle no airplane stays slow: then the tube is clogged, which so slowly that
// the wind has been made to fit.
bool divesSlowly() {
    constexpr core::Ratio kDown(-0.14f);  // sine of 8 degrees
    constexpr int16_t kFullPerPercent = core::Ratio::kOne * 95 / 10000;
    return vehicle.airspeed.healthy && vehicle.estimate.flying &&
           vehicle.attitude.sin_pitch.raw < kDown.raw &&
           vehicle.throttle_demand.raw >= parameters.throttle_max_pct * kFullPerPercent &&
           vehicle.estimate.equivalent_airspeed_mps < speedMin_mps();
}

// A reading that stays while the speed by GPS and wind changes is stuck. A calm flight alone is no
// evidence: its speed may stay, too.
struct AirspeedChange {
    float reading_mps, expected_mps;  // when it changed last
};
core::FileState<AirspeedChange> airspeed_change{};

bool staysWrongly(float expected_mps) {
    constexpr float kChanged_mps = 1;
    if (vehicle.airspeed.speed_mps != airspeed_change.reading_mps)
        airspeed_change = {vehicle.airspeed.speed_mps, expected_mps};
    return fabsf(expected_mps - airspeed_change.expected_mps) > kChanged_mps;
}

// The sensor against ground speed and wind. Too slow to fly, on the ground, the wind comes from
// anywhere: nothing is compared.
struct AirspeedError {
    float odd_mps, limit_mps;
};
AirspeedError airspeedError(float expected_mps) {
    if (!wind.known() || expected_mps < speedMin_mps()) return {0, 1};
    return {fabsf(vehicle.airspeed.speed_mps * true_speed.ratio - expected_mps),
            kInconsistentAirspeed_mps + expected_mps * kInconsistentAirspeed};
}

// False when they contradict each other.
bool airspeedFits() {
    workOutAirspeed();
    const float expected_mps = wind.airspeed_mps(vehicle.gps.velocity_mps);
    const AirspeedError error = airspeedError(expected_mps);
    const bool odd = error.odd_mps >= error.limit_mps;
    const bool stuck = wind.known() && staysWrongly(expected_mps);
    if (odd || stuck) reportInconsistency(Sensor::airspeed);
    return !odd && !stuck && !divesSlowly();
}

// Without the inertial sensor the nose points where it did before.
void updateWind() {
    constexpr float kLevel_mps = 1;  // in a climb the wind changes with the height
    if (!vehicle.imu.healthy || newest_fix.since_s > 1.5f) return;
    if (!vehicle.estimate.flying) {
        // without power it stands, whatever the receiver shows; what is thrown has no wheels
        if (!vehicle.armed || vehicle.throttle_demand.raw < kClimbThrottle.raw) return;
        if (core::isZero(parameters.takeoff_min_accel_mss))
            attitude.pointAlong(vehicle.gps.velocity_mps);
        return;
    }
    if (pointsByCourse()) return;
    if (!airspeedFits() && vehicle.airspeed.healthy) return;
    const float airspeed_mps = vehicle.airspeed.healthy ? vehicle.estimate.airspeed_mps : 0.0f;
    const Vector3 ground_mps = position.velocity_mps();
    const estimation::Pointing nose = {attitude.noseNorth(), attitude.noseEast()};
    // what a speed near 0 lacks is a multiple of it; it is 0 where nothing measures it
    if (airspeed_mps >= flyingAirspeed_mps() && fabsf(published.climb_mps) < kLevel_mps)
        learnAirspeedRatio(wind.airspeedMissing_mps(ground_mps, nose, airspeed_mps) / airspeed_mps,
                           newest_fix.since_s);
    wind.update(ground_mps, nose, airspeed_mps, newest_fix.since_s);
    published.wind_mps = wind.wind_mps();
}

bool near(float a_m, float b_m) { return fabsf(a_m - b_m) < kInconsistentHeight_m; }

// Home was at the receiver's height. Before it is set the present height is what is known.
float gpsAbove_m(float gps_m, float height_m) {
    if (!vehicle.home.set) return gps_m - height_m;
    return core::hundredths(vehicle.home.altitude_cm) - heights.home_m;
}

// There has been no barometer since the start: heights are the receiver's, above home, or above
// where the first fix came while there is none.
void startHeightByGps(float gps_m) {
    heights.gps_above_m = gpsAbove_m(gps_m, heights.home_m);
    height.start(gps_m - heights.gps_above_m);
    heights.started = heights.by_gps = true;
}

// The barometer's zero was taken wherever the airplane was by then: the heights above home stay.
void moveHeightToBarometer(float reading_m) {
    const float by_m = reading_m - height.height_m();
    height.resume(reading_m, height.climb_mps());
    heights.home_m += by_m;
    heights.gps_above_m -= by_m;
    heights.by_gps = false;
    barometer_drift.pause();
}

// A barometer that insists on another height, of an armed airplane that stands: its zero has moved.
void keepHeightStanding(float by_m) {
    if (!vehicle.armed || vehicle.estimate.flying ||
        fabsf(by_m) < 0.5f * estimation::Height::kGlitch_m)
        return;
    heights.home_m += by_m;
    heights.gps_above_m -= by_m;
}

// The receiver's height stands in for the barometer's, whose zero it learns before; and says which
// of barometer and estimate is wrong where they differ.
void useGpsHeight() {
    const auto& baro = vehicle.baro;
    const float height_m = height.height_m();
    const float gps_m = core::hundredths(vehicle.gps.altitude_cm);
    if (!heights.started) {
        if (!baro.healthy) startHeightByGps(gps_m);
        return;
    }
    // Begun in the air there is no time to learn it slowly, and the height that a restart goes on
    // with may be long past.
    if (core::isZero(heights.gps_above_m)) heights.gps_above_m = gpsAbove_m(gps_m, height_m);
    const float fix_m = gps_m - heights.gps_above_m;
    if (!baro.healthy) {
        const bool comparable = !heights.by_gps;  // not yet while their zeros differ
        if (comparable && !near(vehicle.estimate.baro_height_m, height_m))
            reportInconsistency(Sensor::barometer);
        estimation::HeightSettings slow;
        slow.omega_rads = 0.7f;  // of five fixes a second
        return height.useBarometer(fix_m, 0.1f, slow);
    }
    if (height.lastReadingFarOff()) {
        if (near(fix_m, height_m)) reportInconsistency(Sensor::barometer);
        return;
    }
    heights.gps_above_m += (fix_m - height_m) * (vehicle.estimate.flying ? 0.002f : 0.02f);
    if (!near(fix_m, height_m) && vehicle.gps.hdop_c < kGoodHdop_c)
        reportInconsistency(Sensor::barometer);
    if (!vehicle.gps.measures_climb) return;  // from its own climb nothing is learnt
    // its climb is taken for the time half an interval before and after it
    const float interval_s = newest_fix.since_s;
    const float ago_s = gpsAge_s(hal::now_ms()) - kPressureAge_s - core::half(interval_s);
    const float end_m = height_m - height.climb_mps() * ago_s;
    heights.home_m += barometer_drift.useGps(end_m, -vehicle.gps.velocity_mps.z, interval_s);
    // heights go with the air's temperature, speeds with its square root
    true_speed.ratio = true_speed.on_field * core::half(1 + barometer_drift.scale());
}

// The mean of what has come since the last time.
void useBarometer() {
    if (pressure.readings == 0) return;
    const auto& baro = vehicle.baro;
    const float reading_m =
        estimation::pressureHeight_m(static_cast<float>(pressure.sum_pa) / pressure.readings,
                                     baro.ground_pressure_pa, baro.ground_temperature_c);
    pressure.sum_pa = 0;
    pressure.readings = 0;
    published.baro_height_m = reading_m;
    if (!baro.healthy) return;
    heights.heard = true;
    const uint16_t now_ms = static_cast<uint16_t>(hal::now_ms());
    if (heights.by_gps) moveHeightToBarometer(reading_m);
    if (heights.started) {
        const float before_m = height.height_m();
        height.useBarometer(reading_m, static_cast<uint16_t>(now_ms - pressure.used_ms) * 0.001f,
                            estimation::HeightSettings());
        keepHeightStanding(height.height_m() - before_m);
    } else {
        height.start(reading_m);
        heights.started = true;
    }
    pressure.used_ms = now_ms;
}

// On the ground before the first fix 0 lets the filter settle; in flight it would hold the turn's
// acceleration for gravity.
float knownAirspeed_mps() {
    if (vehicle.airspeed.healthy) return vehicle.estimate.airspeed_mps;
    return vehicle.estimate.flying ? core::hundredths(parameters.cruise_speed_cms) : 0.0f;
}

// Where nobody measures its airspeed, and a receiver may be lost or stuck: a motor that turns and a
// height that no field has.
bool climbsUnderPower() {
    return vehicle.baro.healthy && !height.lastReadingFarOff() &&
           vehicle.throttle_demand.raw > kClimbThrottle.raw && aboveField_m() > kNearField_m;
}

// By the airspeed sensor, else by the fixes, which a tube that is still covered does not belie when
// they are as fast as one flies. A speed from dead reckoning is no evidence.
bool fast() {
    const bool measured = vehicle.airspeed.healthy;
    if (measured && vehicle.airspeed.speed_mps > flyingAirspeed_mps()) return true;
    if (!measured && climbsUnderPower()) return true;
    const float least_mps = measured ? speedMin_mps() : kFlyingGroundSpeed_mps;
    return !position.reckoned() && measuredGroundSpeed_mps() > least_mps;
}

bool climbsOrSinks() { return fabsf(published.climb_mps) >= 0.5f; }
bool nearField() { return fabsf(aboveField_m()) < kNearField_m; }

// An airplane that flies against the wind is slow over the ground, too. It stands where two of
// three say so: its speed through the air, the height of the field, the gyros. None of them alone:
// a wind that was learnt in few turns may be half as strong as it is. A speed that nothing has
// measured is no evidence of flight.
bool stands() {
    const auto& estimate = vehicle.estimate;
    const bool measured = vehicle.airspeed.healthy || !estimate.reckoned;
    if (measured && estimate.ground_speed_mps >= kStandingSpeed_mps) return false;
    if (climbsOrSinks()) return false;
    const bool low = nearField();
    return slowThroughTheAir() + low + !turns() >= 2;
}

int16_t centimetres(float metres) { return core::narrowed(core::inHundredths(metres)); }
float metres(int16_t centimetres) { return core::hundredths(centimetres); }

void publishAngles() {
    const estimation::Angles& angles = attitude.angles();
    auto& to = published_attitude;
    to.roll_rad = angles.roll_rad;
    to.pitch_rad = angles.pitch_rad;
    to.yaw_rad = angles.yaw_rad;
    to.sin_roll = angles.sin_roll;
    to.cos_roll = angles.cos_roll;
    to.sin_pitch = angles.sin_pitch;
    to.cos_pitch = angles.cos_pitch;
}

void publishHeight() {
    auto& to = core::based(published);
    const float scale = barometer_drift.scale();
    to.height_m = (height.height_m() - heights.home_m) * scale;
    to.climb_mps = height.climb_mps() * scale;
    to.velocity_mps.z = -to.climb_mps;
    to.height_known = heights.started && height.healthy();
}

// The receiver's, counted as the estimate is.
float gpsHeight_m() { return core::hundredths(vehicle.gps.altitude_cm) - heights.gps_above_m; }

float heightTestRatio() {
    if (!vehicle.estimate.height_known) return 0;
    const float reading_m = vehicle.baro.healthy ? vehicle.estimate.baro_height_m : gpsHeight_m();
    return fabsf(reading_m - height.height_m()) * (1 / estimation::Height::kGlitch_m);
}

float airspeedTestRatio() {
    if (parameters.airspeed_enable == 0 || position.reckoned()) return 0;
    const AirspeedError error = airspeedError(wind.airspeed_mps(vehicle.gps.velocity_mps));
    return error.odd_mps / error.limit_mps;
}

// More than a wind explains: to fly 75 degrees across its nose, at such a speed over the ground, an
// airplane needs a wind of 97 % of its airspeed. (ArduPlane gives the compass up from 45 degrees
// on.) Once it does, until the heading by the course has come near: halfway the compass seems right
// again.
bool liesAcrossCourse() {
    constexpr float kFast_mps = 8;
    constexpr core::Angle kFar_rad(core::radians(75.0f)), kNear_rad(core::radians(20.0f));
    if (!vehicle.estimate.flying)
        motion.across_course = false;  // it may be set right on the ground
    if (!vehicle.estimate.flying || vehicle.gps.ground_speed_mps < kFast_mps ||
        isFaulty(Sensor::gps))
        return false;
    const core::Angle course_rad(
        core::radiansFromCentidegrees(core::wrap180_cd(vehicle.gps.course_cd)));
    const int16_t apart = static_cast<int16_t>(course_rad.raw - vehicle.attitude.yaw_rad.raw);
    const int16_t limit = motion.across_course ? kNear_rad.raw : kFar_rad.raw;
    motion.across_course = apart > limit || apart < -limit;
    return motion.across_course;
}

// Without the inertial sensor the attitude stands: what seems to be the airplane's own is not.
void moveOwnFieldToOffsets() {
    if (vehicle.imu.healthy && compassLearnsInFlight())
        takeCompassOffset(attitude.compassOffset_mg());
}

}  // namespace

// Without an inertial sensor the attitude stands, and is found anew when it is back.
void runAttitude() {
    const auto& imu = core::based(vehicle.imu);
    if (!imu.calibrated || (imu.periods == 0 && !motion.started)) return;
    if (!motion.started) {
        attitude.start();
        motion.started = true;
    }
    const uint8_t periods = imu.periods != 0 ? imu.periods : kFramePeriods;
    motion.gathered = periods > 0xFF - motion.gathered ? 0xFF : motion.gathered + periods;
    auto& to = published_attitude;
    if (imu.periods == 0) {
        if (!imuDead()) ++motion.imu_gap;
        to.aligned = !imuDead() && to.aligned;
        return;
    }
    if (imuDead()) {
        attitude.start();
        // learnt in flight from an attitude that was wrong before it was lost
        if (vehicle.armed) restoreStoredOffsets();
    }
    motion.imu_gap = 0;
    motion.waits_for_imu = false;
    attitude.propagate({imu.turned, imu.rate_rads, imu.accel_mss, imu.periods});
    to.roll_rad = attitude.angles().roll_rad;
    to.pitch_rad = attitude.angles().pitch_rad;
    to.rate_rads = attitude.rate_rads();
    to.aligned = attitude.aligned();
}

void alignAttitude() { attitude.align(); }

void rotateDcm() {
    if (!runs()) return;
    attitude.rotateDcm();
    publishAngles();
}

void orthonormalizeMatrix() { attitude.orthonormalize(); }
void pointYaw() { attitude.pointYaw(); }

void gatherPressure() {
    if (vehicle.baro.readings == pressure.seen || !runs()) return;
    pressure.seen = vehicle.baro.readings;
    pressure.sum_pa += vehicle.baro.pressure_pa;
    ++pressure.readings;
}

void propagateMotion() {
    if (!runs()) return;
    attitude.accelerate();
    const Vector3 acceleration_mss = imuDead() ? Vector3{0, 0, 0} : attitude.acceleration_mss();
    const float dt_s = core::real(motion.gathered) * estimation::kSamplePeriod_s;
    position.propagate(acceleration_mss, dt_s);
    height.propagate(-acceleration_mss.z, dt_s);
    motion.gathered = 0;
    auto& to = core::based(published);
    to.known = position.known();
    to.position = position.position();
    to.reckoned = position.reckoned();
    to.fix_refused = position.refuses();
    to.velocity_mps = position.velocity_mps();
    publishHeight();
}

void fusePressure() {
    if (!runs()) return;
    useBarometer();
    publishHeight();
}

void publishSpeeds() {
    if (!runs()) return;
    auto& to = core::based(published);
    const Vector3& velocity = to.velocity_mps;
    to.ground_speed_mps = sqrtf(core::squaredLength(velocity.x, velocity.y));
    if (to.ground_speed_mps > 0.01f) {
        const float inverse = core::inverse(to.ground_speed_mps);
        const core::Angle course_rad = estimation::tableAtan2(core::Ratio(velocity.y * inverse),
                                                              core::Ratio(velocity.x * inverse));
        to.course_cd = core::wrap360_cd(course_rad);
    }
    workOutAirspeed();
    if (vehicle.airspeed.healthy) {
        to.equivalent_airspeed_mps = vehicle.airspeed.speed_mps;
        to.airspeed_mps = vehicle.airspeed.speed_mps * true_speed.ratio;
    } else {
        const bool reckoned = position.reckoned();
        const float airspeed_mps =
            reckoned ? core::hundredths(parameters.cruise_speed_cms) : wind.airspeed_mps(velocity);
        to.airspeed_mps = reckoned && !to.flying ? 0 : airspeed_mps;
        to.equivalent_airspeed_mps = airspeed_mps / true_speed.ratio;  // the loops need some
    }
}

// The nose swings with each aileron, the course follows the lift: quickly by the accelerations, and
// within two seconds by the nose. By the nose alone the bank that is to hold a leg would swing,
// too.
void reckonPosition() {
    constexpr float kPeriod_s = 0.1f, kDrawn_s = 2, kShare = kPeriod_s / kDrawn_s;
    if (!runs() || position.age_s() < estimation::Position::kCarries_s) return;
    if (!vehicle.estimate.flying) return position.reckon(0, 0, 1);
    const float airspeed_mps = vehicle.estimate.airspeed_mps;
    const Vector3 wind_mps = wind.wind_mps();
    position.reckon(attitude.noseNorth() * airspeed_mps + wind_mps.x,
                    attitude.noseEast() * airspeed_mps + wind_mps.y, kShare);
}

// A number that is none spreads with every step of its filter: that one begins again.
void checkEstimate() {
    const bool height_good = isfinite(height.height_m()) && isfinite(height.climb_mps());
    if (!core::check(height_good, core::InternalError::height_not_finite, __LINE__)) {
        height.start(0);
        heights.started = false;
    }
    const core::Vector3 velocity_mps = position.velocity_mps();
    const bool position_good = isfinite(velocity_mps.x) && isfinite(velocity_mps.y);
    if (!core::check(position_good, core::InternalError::position_not_finite, __LINE__))
        position = estimation::Position();
}

void updateFlying() {
    if (!runs()) return;
    const bool changes =
        published.flying ? !vehicle.armed || stands() : vehicle.armed && fast() && !stands();
    motion.flying_changes = changes ? motion.flying_changes + 1 : 0;
    if (motion.flying_changes < (published.flying ? kEndsFlying : kBeginsFlying)) return;
    published.flying = !published.flying;
    motion.flying_changes = 0;
    // On the ground it is heard again, whatever it is wrong by: its zero is what is corrected.
    // After a restart it is only not heard yet.
    if (!published.flying && heights.heard && !vehicle.baro.healthy) heights.by_gps = true;
}

void fuseFixAttitude() {
    if (vehicle.gps.fixes == newest_fix.seen || !runs()) return;
    newest_fix.seen = vehicle.gps.fixes;
    if (!fixIsGood()) return;
    const uint32_t now_ms = hal::now_ms();
    newest_fix.since_s = (now_ms - newest_fix.ms) * 0.001f;
    newest_fix.ms = now_ms;
    estimation::AttitudeSettings settings = attitudeSettings();
    settings.gps_age_s = gpsAge_s(now_ms);
    attitude.useGps(vehicle.gps.velocity_mps, settings, fix_comparison);
    fix_for = {true, true, true, parameters.gps_delay_ms == 0};
}

void learnGpsDelay() {
    if (!fix_for.delay || !runs()) return;
    fix_for.delay = false;
    if (fix_comparison.whole()) gps_delay.learn(fix_comparison, gps_delay.correction_s());
}

void fuseFixPosition() {
    if (!fix_for.position || !runs()) return;
    fix_for.position = false;
    estimation::PositionSettings settings;
    settings.gps_age_s = gpsAge_s(hal::now_ms());
    position.useGps(vehicle.gps.position, vehicle.gps.velocity_mps, attitude.gainedSinceFix_mps(),
                    settings);
}

void fuseFixWind() {
    if (!fix_for.wind || !runs()) return;
    fix_for.wind = false;
    updateWind();
}

void fuseFixHeight() {
    if (!fix_for.height || !runs()) return;
    fix_for.height = false;
    useGpsHeight();
}

void fuseCompass() {
    const auto& compass = vehicle.compass;
    if (!compass.accepted || compass.readings == motion.compass_seen || !runs()) return;
    motion.compass_seen = compass.readings;
    if (parameters.compass_use == 0) return;
    const bool across = liesAcrossCourse();
    if (!attitude.useCompass(compass.field_mg, attitudeSettings()) || across)
        reportInconsistency(Sensor::compass);
}

// A slow receiver is not silent between two of its fixes.
void fuseAirspeed() {
    moveOwnFieldToOffsets();                                   // fuseCompass has no time left
    if (divesSlowly()) reportInconsistency(Sensor::airspeed);  // also when there are no fixes
    const float interval_s = core::limit(newest_fix.since_s, kLeastInterval_s, kMaxInterval_s);
    const uint16_t silent_ms = static_cast<uint16_t>(interval_s * (kSilentIntervals * 1000));
    if (runs() && hal::now_ms() - newest_fix.ms > silent_ms)
        attitude.useAirspeed(knownAirspeed_mps());
}

Vector3 gyroDrift_rads() { return attitude.bias_rads(); }

TestRatios testRatios() {
    return {position.fixTestRatio(), heightTestRatio(), attitude.compassTestRatio(),
            airspeedTestRatio()};
}

float flyingAirspeed_mps() {
    constexpr float kShare = 0.75f, kMax_mps = 10;
    return fminf(kShare * speedMin_mps(), kMax_mps);
}

float measuredGroundSpeed_mps() {
    return fminf(vehicle.estimate.ground_speed_mps, vehicle.gps.ground_speed_mps);
}

bool slowThroughTheAir() {
    const bool known = vehicle.airspeed.healthy || wind.known();
    return known && vehicle.estimate.airspeed_mps < flyingAirspeed_mps();
}

bool barometerSteady() {
    return !height.lastReadingFarOff() &&
           (core::isZero(heights.gps_above_m) || near(gpsHeight_m(), height.height_m()));
}

void zeroHeight() {
    barometer_drift.zero();
    heights.home_above_field_m = 0;
    published.height_m = 0;
    if (vehicle.baro.healthy) {
        if (height.lastReadingFarOff()) height.resume(vehicle.estimate.baro_height_m, 0);
        true_speed.ratio = true_speed.on_field = estimation::trueSpeedRatio(
            static_cast<float>(vehicle.baro.pressure_pa), vehicle.baro.ground_temperature_c);
    }
    heights.home_m = height.height_m();
}

float aboveField_m() { return published.height_m + heights.home_above_field_m; }
bool mayRoll() { return nearField() && !climbsOrSinks(); }

void shiftHeight(float by_m) {
    heights.home_m -= by_m / barometer_drift.scale();
    heights.home_above_field_m -= by_m;
    published.height_m += by_m;
}

// A place without a fix since then counts as one that is as old as the record.
void resumeEstimate(const SlowRecord& slow, const FastRecord& fast, const Vector3& turned_rad,
                    float lost_s) {
    attitude.resume(fast.pose, slow.learnt, turned_rad);
    motion.waits_for_imu = true;
    heights.home_m = slow.home_height_m;
    heights.home_above_field_m = slow.home_above_field_m;
    barometer_drift.resumeScale(slow.height_scale);
    height.resume(heights.home_m + fast.height_m / barometer_drift.scale(), fast.climb_mps);
    heights.started = motion.started = true;
    pressure.used_ms = static_cast<uint16_t>(hal::now_ms());
    true_speed.ratio = true_speed.on_field =
        estimation::trueSpeedRatio(slow.ground_pressure_pa, slow.ground_temperature_c);
    if (fast.wind_known) wind.resume(metres(slow.wind_cms[0]), metres(slow.wind_cms[1]));
    published.wind_mps = wind.wind_mps();
    published.flying = true;
    if (!fast.place_known) return;
    setDeclination(fast.position);  // the compass is used before a fix comes
    estimation::PositionSettings settings;
    settings.gps_age_s = lost_s;
    position.useGps(fast.position, {fast.north_mps, fast.east_mps, 0}, {0, 0, 0}, settings);
}

void saveEstimate(SlowRecord& to) {
    attitude.save(to.learnt);
    addOffsetsNotStored(to.learnt.field.own);  // after a restart they are as stored
    to.home_height_m = heights.home_m;
    to.home_above_field_m = heights.home_above_field_m;
    to.height_scale = barometer_drift.scale();
    const Vector3 wind_mps = wind.wind_mps();
    to.wind_cms[0] = centimetres(wind_mps.x);
    to.wind_cms[1] = centimetres(wind_mps.y);
}

void saveEstimate(FastRecord& to) {
    const auto& estimate = core::based(vehicle.estimate);
    attitude.save(to.pose);
    to.rate_rads = attitude.rate_rads();
    to.position = estimate.position;
    to.place_known = estimate.known;
    to.wind_known = wind.known();
    to.north_mps = estimate.velocity_mps.x;
    to.east_mps = estimate.velocity_mps.y;
    to.climb_mps = estimate.climb_mps;
    to.height_m = estimate.height_m;
}

}  // namespace estimator
}  // namespace firmware

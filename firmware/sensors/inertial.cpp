// SPDX-License-Identifier: GPL-3.0-or-later
// Gyros and accelerometers. The gyros' zero is measured once at start while the airplane stands
// still: moved, the measurement begins again.
#include "board.hpp"
#include "core/file_state.hpp"
#include "core/fixed.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "core/seldom.hpp"
#include "estimation/gyro_bias_init.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/sensors/dead_gyros.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/clock.hpp"
#include "hal/imu_interrupt.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<ImuState> : Writable<ImuState> {
    using Writable::state;
};
}  // namespace state

namespace sensors {

using namespace notify;
using namespace state;

namespace {

constexpr ImuState& published = Publisher<ImuState>::state();

using estimation::DeltaAngle;
using estimation::SavedDeltaAngle;

// How an axis of the accelerometers reads: from twice the sum of two samples to a Force.
using Force = core::Fixed<9>;  // m/s2; sums of it in 32 bits
struct Reading {
    int16_t factor;
    Force offset_mss;
};
using Trim = core::Fixed<15>;

// Apart, as its volatile members, shared with the interrupt, are no constants to start with.
core::FileState<board::Inertial> imu{};

// Of the specific force: its slow part, and the mean size of the rest.
struct Vibration {
    core::Acceleration slow_mss, size_mss;
};
struct Vibrations {
    Vibration axes[3];
    uint8_t axis, clips;
};
core::FileState<Vibrations> vibration{};

struct Inertial {
    estimation::GyroBiasInit bias_init;
    DeltaAngle zero;  // of the gyros, in a sample period
    DeadGyros dead_gyros;
    bool yaw_reported;
    uint8_t last_force_z;  // the lowest byte of its reading
    Reading readings[3];
    Trim trim_x_rad, trim_y_rad;  // AHRS_TRIM
    ParameterWatch watch;
};
core::FileState<Inertial> inertial{};

SELDOM Trim trim(float rad) {
    constexpr float kMax_rad = 0.2f;
    return Trim::fromRaw(
        static_cast<int16_t>(core::limit(rad, -kMax_rad, kMax_rad) * Trim::kSteps));
}
void takeTrim() {
    inertial.trim_x_rad = trim(parameters.level_trim_rad[0]);
    inertial.trim_y_rad = trim(parameters.level_trim_rad[1]);
}
void takeReading(uint8_t axis) {
    constexpr float kFactor = drivers::kForceStep_mss / 4 * Force::kSteps * 65536;
    const float scale = core::limit(parameters.accel_scale[axis], -1.5f, 1.5f);
    const Force offset_mss(parameters.accel_offset_mss[axis] * scale);
    inertial.readings[axis] = {static_cast<int16_t>(core::rounded(scale * kFactor)), offset_mss};
}

// In two periods.
int32_t turned(int32_t two, int32_t zero_here) {
    constexpr float kFactor =
        drivers::kRateStep_rads * estimation::kSamplePeriod_s * DeltaAngle::kSteps;
    return two * static_cast<int32_t>(kFactor + 0.5f) - zero_here * 2;
}

core::BodyRate rate_rads(int32_t turned_in_two) {
    constexpr float kFactor =
        core::BodyRate::kSteps / (2 * estimation::kSamplePeriod_s) / DeltaAngle::kSteps * 4096;
    const int32_t rate = core::times16(turned_in_two, static_cast<int16_t>(kFactor * 65536 + 0.5f));
    return core::BodyRate::fromRaw(
        core::upperOf16(core::limit(rate, -core::kMaxOf16, core::kMaxOf16)));
}

// A Force's steps.
int32_t force(int32_t two, const Reading& reading) {
    return core::times16(two * 2, reading.factor) - reading.offset_mss.raw;
}

core::Acceleration force_mss(int32_t force) {
    return core::Acceleration::fromRaw((force + 1) >> 1);
}

// AHRS_TRIM: how the board sits in the airplane, a small rotation taken back.
void level(DeltaAngle& v) {
    const DeltaAngle old = v;
    v.of[0] += 2 * core::times16(old.of[2], inertial.trim_y_rad.raw);
    v.of[1] -= 2 * core::times16(old.of[2], inertial.trim_x_rad.raw);
    v.of[2] += 2 * (core::times16(old.of[1], inertial.trim_x_rad.raw) -
                    core::times16(old.of[0], inertial.trim_y_rad.raw));
}

// Of two samples, as there nearly always are.
SELDOM void makeTwo(drivers::ImuSums& sums) {
    for (uint8_t i = 0; i < 3; ++i) {
        sums.rate[i] = sums.rate[i] * 2 / sums.count;
        sums.force[i] = sums.force[i] * 2 / sums.count;
    }
}

// After a longer gap nobody knows.
SELDOM void stretch(DeltaAngle& turn, uint8_t periods) {
    constexpr uint8_t kMax = 4;
    if (periods > kMax) periods = kMax;
    for (int32_t& axis : turn.of) axis = axis / 2 * periods;
}

core::Vector3 mean(const int32_t (&sums)[3], float a_step) {
    return core::Vector3{static_cast<float>(sums[0]), static_cast<float>(sums[1]),
                         static_cast<float>(sums[2])} *
           a_step;
}

SELDOM void findZero(const drivers::ImuSums& sums) {
    const bool found =
        inertial.bias_init.update(mean(sums.rate, drivers::kRateStep_rads / sums.count),
                                  mean(sums.force, drivers::kForceStep_mss / sums.count),
                                  sums.periods * estimation::kSamplePeriod_s);
    if (!found) return;
    const core::Vector3 in_period =
        inertial.bias_init.zero_rads() * (estimation::kSamplePeriod_s * DeltaAngle::kSteps);
    inertial.zero = {
        {core::rounded(in_period.x), core::rounded(in_period.y), core::rounded(in_period.z)}};
}

// The wind alone moves it, as far as can be seen.
bool mayRock() {
    constexpr float kStanding_mps = 3;
    return !vehicle.armed && vehicle.estimate.ground_speed_mps < kStanding_mps;
}

bool possible(const core::BodyRates& rate) {
    const int32_t sum = int32_t{rate.x.raw} + rate.y.raw + rate.z.raw;
    return acceptReading(Sensor::inertial, static_cast<int16_t>(sum), true);
}

// Gyros may be quiet. Accelerometers never are in flight: even a calm one shows each tremor of 0.2
// mg.
void watchForces(const drivers::ImuSums& sums) {
    const uint8_t z = static_cast<uint8_t>(sums.force[2]);
    if (z != inertial.last_force_z) reportChange(Sensor::inertial);
    inertial.last_force_z = z;
}

// Without the gyro of yaw, compass and fixes are enough to fly on.
void watchGyros(const drivers::ImuSums& sums) {
    const uint8_t dead = inertial.dead_gyros.look(sums.rate);
    if ((dead & (kRollGyro | kPitchGyro)) != 0) reportInconsistency(Sensor::inertial);
    const bool blind = (dead & kYawGyro) != 0 && vehicle.estimate.flying;
    if (blind && !inertial.yaw_reported)
        sendStatusText(Severity::critical, STATUS_TEXT("Yaw gyro stuck"));
    inertial.yaw_reported = blind;
}

// Another axis in each frame: it takes some of the samples to know how large all are.
void watchVibration(const core::Accelerations& accel_mss) {
    constexpr core::Acceleration kRange_mss(0.95f * board::Inertial::kRange_g * core::kGravity_mss);
    if (++vibration.axis == core::count(vibration.axes)) vibration.axis = 0;
    Vibration& axis = vibration.axes[vibration.axis];
    const int16_t force = (&accel_mss.x)[vibration.axis].raw;
    int16_t rest = static_cast<int16_t>(force - axis.slow_mss.raw);
    axis.slow_mss.raw = static_cast<int16_t>(axis.slow_mss.raw + (rest >> 1));  // 4 Hz
    if (rest < 0) rest = static_cast<int16_t>(-rest);
    axis.size_mss.raw =
        static_cast<int16_t>(axis.size_mss.raw + ((rest - axis.size_mss.raw) >> 2));  // 2 Hz
    if ((force > kRange_mss.raw || force < -kRange_mss.raw) && vibration.clips != 0xFF)
        ++vibration.clips;
}

void use(drivers::ImuSums& sums) {
    watchGyros(sums);
    watchForces(sums);
    if (sums.count != 2) makeTwo(sums);
    DeltaAngle turn, specific_force;
    for (uint8_t i = 0; i < 3; ++i) {
        turn.of[i] = turned(sums.rate[i], inertial.zero.of[i]);
        specific_force.of[i] = force(sums.force[i], inertial.readings[i]);
    }
    const bool trimmed = inertial.trim_x_rad.raw != 0 || inertial.trim_y_rad.raw != 0;
    if (trimmed) level(turn);
    const core::BodyRates rates = {rate_rads(turn.of[0]), rate_rads(turn.of[1]),
                                   rate_rads(turn.of[2])};
    if (!possible(rates)) return;
    published.rate_rads = rates;
    if (sums.periods != 2) stretch(turn, sums.periods);
    published.turned = turn;
    if (trimmed) level(specific_force);
    published.accel_mss = {force_mss(specific_force.of[0]), force_mss(specific_force.of[1]),
                           force_mss(specific_force.of[2])};
    watchVibration(published.accel_mss);
}

// A chip that talks nonsense is started anew, but has time to win trust before that comes again.
SELDOM void restartSensor() {
    if ((hal::now_ms() & 4095) < 10) imu.start();
    published.healthy = false;
    published.periods = 0;
}

}  // namespace

void startInertial() {
    imu.start();
    runInertialSettings();
}

void saveGyroZero(SavedDeltaAngle (&to_rad)[3]) {
    for (uint8_t i = 0; i < 3; ++i)
        to_rad[i] =
            SavedDeltaAngle::fromRaw(inertial.zero.of[i] / estimation::kSavedDeltaAngleSteps);
}

void saveHangTurn(HangDeltaAngle& to) { to.periods = imu.peek(to.turned); }

core::Vector3 hangTurn_rad(const HangDeltaAngle& turn) {
    constexpr float kStep = 1.0f / DeltaAngle::kSteps;
    const core::Vector3 zeros = {static_cast<float>(inertial.zero.of[0]),
                                 static_cast<float>(inertial.zero.of[1]),
                                 static_cast<float>(inertial.zero.of[2])};
    return board::Inertial::peeked(turn.turned) - zeros * (kStep * turn.periods);
}

void resumeInertial(const SavedDeltaAngle (&gyro_zero_rad)[3]) {
    imu.resume();
    for (uint8_t i = 0; i < 3; ++i)
        inertial.zero.of[i] = gyro_zero_rad[i].raw * estimation::kSavedDeltaAngleSteps;
    inertial.bias_init.forgo();
}

void calibrateGyros() {
    if (vehicle.armed) return;
    published.calibrated = false;
    inertial.bias_init.start();
    inertial.zero = {};
}

core::Vector3 restForce_mss() { return inertial.bias_init.force_mss(); }

uint8_t inertialSamplesWaiting() { return imu.waiting(); }
uint16_t inertialErrors() { return imu.badReads(); }

// The root of the mean square is 1.11 times the mean size of a sine, and 1.25 times that of noise.
uint16_t vibration_cmss(uint8_t axis) {
    constexpr uint8_t kFactor = 118;
    static_assert(core::Acceleration::kOne == 256, "a byte less");
    return static_cast<uint16_t>(core::product(vibration.axes[axis].size_mss.raw, kFactor) >> 8);
}

uint8_t accelerometerClips() { return vibration.clips; }

void runInertialSettings() {
    if (!inertial.watch.changed()) return;
    for (uint8_t axis = 0; axis < core::count(inertial.readings); ++axis) takeReading(axis);
    takeTrim();
}

void runInertial() {
    imu.step(hal::frame_ms());
    published.healthy = imu.healthy();
    drivers::ImuSums sums;
    if (!imu.take(sums)) {
        published.periods = 0;
        return;
    }
    published.periods = sums.periods;
    if (!inertial.bias_init.done() || (mayRock() && !inertial.bias_init.settled())) findZero(sums);
    published.calibrated = inertial.bias_init.done();
    use(sums);
    if (isFaulty(Sensor::inertial)) restartSensor();
}

}  // namespace sensors
}  // namespace firmware

namespace hal {

bool imuDataReady() {
    firmware::sensors::imu.onDataReady();
    return firmware::sensors::imu.waiting() >= firmware::sensors::kSamplesPerFrame;
}

}  // namespace hal

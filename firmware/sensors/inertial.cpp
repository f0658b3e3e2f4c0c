// SPDX-License-Identifier: GPL-3.0-or-later
// Gyros and accelerometers. The gyros' zero is measured once at start while the airplane stands
// still: moved, the measurement begins again.
#include "board.hpp"
#include "core/maths.hpp"
#include "drivers/mpu6000.hpp"
#include "firmware/parameters.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/vehicle.hpp"
#include "hal/clock.hpp"
#include "hal/imu_interrupt.hpp"

namespace firmware {
namespace {

using core::Vector3;

drivers::Mpu6000<board::SensorBus, board::ImuSelect> imu;

constexpr uint8_t kStillFrames = 200;  // 2 s
constexpr uint8_t kSettleFrames = 10;
constexpr float kStillRate_rads = 0.035f;  // 2 deg/s about the running mean
constexpr float kZeroLimit_rads = 0.52f;   // data sheet: zero within 20 deg/s; half as much again

struct GyroZero {
    Vector3 sum;
    uint8_t frames;
};
GyroZero zeroing;
Vector3 zero_rads;

bool within(const Vector3& v, float limit) {
    return fabsf(v.x) < limit && fabsf(v.y) < limit && fabsf(v.z) < limit;
}

void zeroGyros(const Vector3& rate_rads) {
    if (zeroing.frames > kSettleFrames) {
        const float frames = zeroing.frames - kSettleFrames;
        const Vector3 mean = zeroing.sum * (1.0f / frames);
        if (!within(rate_rads - mean, kStillRate_rads) || !within(mean, kZeroLimit_rads)) {
            zeroing = {};
            return;
        }
    }
    if (zeroing.frames >= kSettleFrames) zeroing.sum = zeroing.sum + rate_rads;
    if (++zeroing.frames < kStillFrames) return;
    zero_rads = zeroing.sum * (1.0f / (kStillFrames - kSettleFrames));
    vehicle.imu.calibrated = true;
}

Vector3 corrected(const Vector3& force_mss) {
    const float* offset = parameters.accel_offset_mss;
    const float* scale = parameters.accel_scale;
    return {(force_mss.x - offset[0]) * scale[0], (force_mss.y - offset[1]) * scale[1],
            (force_mss.z - offset[2]) * scale[2]};
}

}  // namespace

void startInertial() { imu.start(); }

void calibrateGyros() {
    if (vehicle.armed) return;
    vehicle.imu.calibrated = false;
    zeroing = {};
}

uint8_t inertialSamplesWaiting() { return imu.waiting(); }
uint16_t inertialErrors() { return imu.badReads(); }

void runInertial() {
    imu.step(hal::now_ms());
    vehicle.imu.healthy = imu.healthy();
    drivers::ImuSample sample;
    if (!imu.take(sample)) {
        vehicle.imu.dt_s = 0;
        return;
    }
    vehicle.imu.dt_s = sample.periods * (imu.kPeriod_us * 1e-6f);
    if (!vehicle.imu.calibrated) zeroGyros(sample.rate_rads);
    vehicle.imu.rate_rads = sample.rate_rads - zero_rads;
    vehicle.imu.accel_mss = corrected(sample.force_mss);
}

}  // namespace firmware

namespace hal {

void imuDataReady() { firmware::imu.onDataReady(); }

}  // namespace hal

// SPDX-License-Identifier: GPL-3.0-or-later
// Gyros and accelerometers. The gyros' zero is measured once at start while the airplane stands
// still: moved, the measurement begins again.
#include "board.hpp"
#include "core/maths.hpp"
#include "drivers/mpu6000.hpp"
#include "estimation/still.hpp"
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

estimation::Still still;

// AHRS_TRIM: how the board sits in the airplane, a small rotation taken back.
Vector3 levelled(const Vector3& board) {
    const Vector3 trim = {parameters.level_trim_rad[0], parameters.level_trim_rad[1], 0};
    return trim.x == 0 && trim.y == 0 ? board : board + core::cross(trim, board);
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
    still.start();
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
    if (!still.done()) still.update(sample.rate_rads, sample.force_mss, vehicle.imu.dt_s);
    vehicle.imu.calibrated = still.done();
    vehicle.imu.rate_rads = levelled(sample.rate_rads - still.zero_rads());
    vehicle.imu.accel_mss = levelled(corrected(sample.force_mss));
}

}  // namespace firmware

namespace hal {

void imuDataReady() { firmware::imu.onDataReady(); }

}  // namespace hal

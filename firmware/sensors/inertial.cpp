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
void level(Vector3& rate_rads, Vector3& force_mss) {
    const float* by_rad = parameters.level_trim_rad;
    if (by_rad[0] == 0 && by_rad[1] == 0) return;
    const Vector3 trim = {by_rad[0], by_rad[1], 0};
    rate_rads = rate_rads + core::cross(trim, rate_rads);
    force_mss = force_mss + core::cross(trim, force_mss);
}

void correct(Vector3& force_mss) {
    const float* offset = parameters.accel_offset_mss;
    const float* scale = parameters.accel_scale;
    force_mss.x = (force_mss.x - offset[0]) * scale[0];
    force_mss.y = (force_mss.y - offset[1]) * scale[1];
    force_mss.z = (force_mss.z - offset[2]) * scale[2];
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
    auto& to = vehicle.imu;
    imu.step(hal::now_ms());
    to.healthy = imu.healthy();
    drivers::ImuSample sample;
    if (!imu.take(sample)) {
        to.dt_s = 0;
        return;
    }
    to.dt_s = sample.periods * (imu.kPeriod_us * 1e-6f);
    if (!still.done()) still.update(sample.rate_rads, sample.force_mss, to.dt_s);
    to.calibrated = still.done();
    to.rate_rads = sample.rate_rads - still.zero_rads();
    to.accel_mss = sample.force_mss;
    correct(to.accel_mss);
    level(to.rate_rads, to.accel_mss);
}

}  // namespace firmware

namespace hal {

void imuDataReady() { firmware::imu.onDataReady(); }

}  // namespace hal

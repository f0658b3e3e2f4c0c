// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/estimator.hpp"

#include "bench.hpp"
#include "hal/clock.hpp"

namespace {

using firmware::vehicle;

constexpr float kGpsAge_s = 0.243f;  // when its bytes have arrived

// Along a meridian, wings level, nose to the north: every sensor at its own rate.
class Estimator : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        vehicle.imu.healthy = vehicle.imu.calibrated = vehicle.gps.healthy = true;
        vehicle.baro.ground_pressure_pa = vehicle.baro.pressure_pa = 101325;
        vehicle.baro.ground_temperature_c = 15;
        firmware::parameters.compass_use = 1;
        firmware::parameters.compass_declination_rad = 0;
        for (int i = 0; i < 1500; ++i) frame(0);
    }
    void frame(float acceleration_mss) {
        speed_mps_ += acceleration_mss * 0.01f;
        travelled_m_ += speed_mps_ * 0.01f;
        vehicle.imu.dt_s = 0.01f;
        vehicle.imu.accel_mss = {acceleration_mss, 0, -core::kGravity_mss};
        ++frame_;
        if (frame_ % 2 == 0) {
            vehicle.compass.field_mg = {210, 0, 430};
            vehicle.compass.fresh = true;
        }
        vehicle.baro.fresh = true;
        if (frame_ % 20 == late_) fix(acceleration_mss);
        fakes::advance_ms(10);
        firmware::runEstimator();
    }
    void fix(float acceleration_mss) {
        auto& gps = vehicle.gps;
        const float then_mps = speed_mps_ - acceleration_mss * kGpsAge_s;
        const float then_m = travelled_m_ - (speed_mps_ + then_mps) / 2 * kGpsAge_s;
        gps.fix = firmware::GpsFix::three_d;
        gps.position = geo::moved({470000000, 80000000}, {then_m, 0});
        gps.velocity_mps = {then_mps, 0, 0};
        gps.received_ms = hal::now_ms();
        gps.fresh = true;
    }

    float speed_mps_ = 0, travelled_m_ = 0;
    int frame_ = 0, late_ = 7;
};

TEST_F(Estimator, does_not_lead_nor_lag_while_the_airplane_gains_speed) {
    for (int i = 0; i < 300; ++i) frame(0);
    for (int i = 0; i < 600; ++i) {
        frame(2);
        if (i < 200 || i % 4 != 3) continue;
        ASSERT_NEAR(vehicle.estimate.velocity_mps.x, speed_mps_, 0.25) << "after " << i;
        const geo::Offset off = geo::offset({470000000, 80000000}, vehicle.estimate.position);
        ASSERT_NEAR(off.north_m, travelled_m_, 0.6) << "after " << i;
    }
    EXPECT_NEAR(vehicle.attitude.pitch_rad, 0, 0.02);
    EXPECT_NEAR(vehicle.attitude.yaw_rad, 0, 0.02);
}

TEST_F(Estimator, uses_every_fix_and_reading_whatever_frame_they_come_in) {
    for (late_ = 0; late_ < 8; ++late_) {
        for (int i = 0; i < 60; ++i) frame(0);
        EXPECT_FALSE(vehicle.gps.fresh) << late_;
        EXPECT_TRUE(vehicle.estimate.known) << late_;
    }
    vehicle.baro.pressure_pa -= 60;  // five metres
    for (int i = 0; i < 800; ++i) frame(0);
    EXPECT_NEAR(vehicle.estimate.height_m, 5, 0.2);
}

}  // namespace

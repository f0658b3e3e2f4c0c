// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/home.hpp"

#include "firmware/guidance/guidance.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::vehicle;

constexpr geo::Position kHome = {470000000, 80000000};

class Home : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        mutable_vehicle.attitude.cos_roll = mutable_vehicle.attitude.cos_pitch = core::Ratio(1);
        mutable_vehicle.imu.accel_mss = core::Accelerations::from(0, 0, -core::kGravity_mss);
        mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d;
        mutable_vehicle.airspeed.healthy = true;
        mutable_vehicle.estimate.velocity_mps = {13, 0, 0};
        mutable_vehicle.estimate.ground_speed_mps = 13;
        mutable_vehicle.estimate.airspeed_mps = mutable_vehicle.estimate.equivalent_airspeed_mps =
            13;
        mutable_vehicle.home.position = mutable_vehicle.estimate.position = kHome;
        mutable_vehicle.home.altitude_cm = 40000;
    }
    void guide(int tenths) {
        for (int i = 0; i < tenths; ++i) {
            firmware::modes::runMode();
            firmware::guidance::runGuidance();
            firmware::guidance::runSpeedHeight();
            firmware::guidance::runGuidance();
        }
    }
    float demandedAltitude_m() {
        return vehicle.home.altitude_cm * 0.01f + vehicle.demand.height_m;
    }
};

TEST_F(Home, set_elsewhere_in_flight_leaves_the_altitude_that_is_flown) {
    fly(Mode::loiter);
    const float before_m = demandedAltitude_m();
    firmware::mission::setHome(kHome, 42000);
    EXPECT_FLOAT_EQ(vehicle.estimate.height_m, 60);
    EXPECT_FLOAT_EQ(demandedAltitude_m(), before_m);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 60);
    EXPECT_FLOAT_EQ(vehicle.demand.from_height_m, 60);
}

TEST_F(Home, set_elsewhere_in_flight_moves_neither_nose_nor_throttle) {
    fly(Mode::loiter);
    guide(100);
    const float pitch_rad = vehicle.pitch_demand_rad.toFloat(),
                throttle = vehicle.throttle_demand.toFloat();
    firmware::mission::setHome(kHome, 45000);
    firmware::guidance::runSpeedHeight();  // between two looks of guidance
    guide(1);
    EXPECT_NEAR(vehicle.pitch_demand_rad.toFloat(), pitch_rad, 0.002f);
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), throttle, 0.01f);
    EXPECT_NEAR(vehicle.progress.height_error_m, 0, 0.01f);
}

TEST_F(Home, set_here_in_flight_makes_its_height_zero_and_flies_on_as_high) {
    fly(Mode::loiter);
    mutable_vehicle.estimate.position = geo::moved(kHome, {500, 0});
    ASSERT_TRUE(firmware::mission::setHomeHere());
    EXPECT_EQ(vehicle.home.position, vehicle.estimate.position);
    EXPECT_EQ(vehicle.home.altitude_cm, 48000);
    EXPECT_FLOAT_EQ(vehicle.estimate.height_m, 0);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 0);
}

}  // namespace

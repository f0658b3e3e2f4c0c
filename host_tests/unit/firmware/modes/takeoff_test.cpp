// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/takeoff.hpp"

#include <cmath>

#include "host_tests/support/fakes/vehicle.hpp"
#include "modes_bench.hpp"

namespace {

using namespace modes_bench;
using firmware::mission::MissionItem;
using firmware::mission::MissionResult;
using firmware::modes::ModeReason;
using firmware::modes::requestMode;

class Takeoff : public ModesBench {
protected:
    void SetUp() override {
        ModesBench::SetUp();
        auto& estimate = mutable_vehicle.estimate;
        estimate.known = mutable_vehicle.home.set = true;
        estimate.airspeed_mps = estimate.equivalent_airspeed_mps = 0;
        mutable_vehicle.home.altitude_cm = 40000;
        course(0, 0);
    }
    static void climbTo(float height_m) {
        mutable_vehicle.estimate.flying = true;
        mutable_vehicle.estimate.height_m = height_m;
        guide();
    }
    static MissionResult order(float height_m, float pitch_deg = 0, uint8_t frame = 3) {
        MissionItem item = {22, frame, pitch_deg, 0, 0, 0, INT32_MAX, INT32_MAX, height_m};
        return firmware::modes::takeOff(item);
    }
};

TEST_F(Takeoff, waits_with_the_motor_off_until_it_is_armed) {
    ASSERT_TRUE(requestMode(Mode::takeoff, ModeReason::ground));
    EXPECT_TRUE(firmware::state::autoThrottle());
    guide(10);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    EXPECT_EQ(vehicle.throttle_demand.toFloat(), 0);
    mutable_vehicle.armed = true;
    guide(10);
    EXPECT_EQ(vehicle.demand.path, Path::takeoff);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
    EXPECT_GT(vehicle.throttle_demand.toFloat(), 0.5f) << "rises at THR_SLEWRATE";
}

TEST_F(Takeoff, waits_for_the_launch_as_a_mission_does) {
    parameters.takeoff_min_accel_mss = 8;
    mutable_vehicle.armed = true;
    ASSERT_TRUE(requestMode(Mode::takeoff, ModeReason::ground));
    guide(20);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    mutable_vehicle.imu.accel_mss = core::Accelerations::from(12, 0, -core::kGravity_mss);
    guide(10);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
}

TEST_F(Takeoff, climbs_to_its_height_and_circles_there) {
    parameters.takeoff_height_m = 40;
    parameters.takeoff_level_pitch_deg = 12;
    mutable_vehicle.armed = true;
    ASSERT_TRUE(requestMode(Mode::takeoff, ModeReason::ground));
    guide(2);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 40);
    EXPECT_NEAR(vehicle.demand.takeoff_pitch_rad, core::radians(12), 1e-4);
    climbTo(38);
    EXPECT_EQ(vehicle.demand.path, Path::takeoff);
    const geo::Position there = {470010000, 80010000};
    mutable_vehicle.estimate.position = there;
    climbTo(39.5f);
    EXPECT_EQ(vehicle.demand.path, Path::circle);
    EXPECT_EQ(vehicle.demand.to, there);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 40);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
}

TEST_F(Takeoff, chosen_in_the_air_circles_and_never_descends) {
    for (const float height_m : {30.0f, 80.0f}) {
        fly(Mode::fbwa);
        mutable_vehicle.estimate.height_m = height_m;
        ASSERT_TRUE(requestMode(Mode::takeoff, ModeReason::pilot));
        guide(10);
        EXPECT_EQ(vehicle.demand.path, Path::circle);
        EXPECT_FLOAT_EQ(vehicle.demand.height_m, std::max(50.0f, height_m));
    }
}

TEST_F(Takeoff, takes_off_again_after_it_was_disarmed) {
    mutable_vehicle.armed = true;
    ASSERT_TRUE(requestMode(Mode::takeoff, ModeReason::ground));
    guide(2);
    climbTo(50);
    ASSERT_EQ(vehicle.demand.path, Path::circle);
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = false;
    mutable_vehicle.estimate.height_m = 0;
    guide(2);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    mutable_vehicle.armed = true;
    guide(2);
    EXPECT_EQ(vehicle.demand.path, Path::takeoff);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 50);
}

TEST_F(Takeoff, armed_in_the_air_after_a_restart_goes_on_flying) {
    fly(Mode::fbwa);
    mutable_vehicle.armed = false;
    ASSERT_TRUE(requestMode(Mode::takeoff, ModeReason::restart));
    guide(1);
    mutable_vehicle.armed = true;
    guide(2);
    EXPECT_EQ(vehicle.demand.path, Path::circle);
}

TEST_F(Takeoff, is_not_entered_without_a_position) {
    mutable_vehicle.estimate.known = false;
    EXPECT_FALSE(requestMode(Mode::takeoff, ModeReason::ground));
    EXPECT_EQ(order(50), MissionResult::error);
    EXPECT_EQ(vehicle.mode, Mode::manual);
}

TEST_F(Takeoff, the_ground_gives_height_and_pitch) {
    EXPECT_EQ(order(60, 20), MissionResult::accepted);
    EXPECT_EQ(vehicle.mode, Mode::takeoff);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 60);
    EXPECT_NEAR(vehicle.demand.takeoff_pitch_rad, core::radians(20), 1e-4);
    mutable_vehicle.armed = true;
    guide(2);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 60) << "as ordered before it was armed";
}

TEST_F(Takeoff, what_the_ground_leaves_out_is_a_parameter) {
    for (const float out : {0.0f, static_cast<float>(NAN)}) {
        EXPECT_EQ(order(out, out), MissionResult::accepted);
        EXPECT_FLOAT_EQ(vehicle.demand.height_m, 50);
        EXPECT_NEAR(vehicle.demand.takeoff_pitch_rad, core::radians(15), 1e-4);
    }
}

TEST_F(Takeoff, the_height_is_in_the_frame_that_the_ground_names) {
    EXPECT_EQ(order(470, 0, 0), MissionResult::accepted);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70);
}

TEST_F(Takeoff, what_cannot_be_flown_is_refused_and_changes_nothing) {
    EXPECT_EQ(order(50, 0, 10), MissionResult::unsupported_frame);
    EXPECT_EQ(order(50, 61), MissionResult::invalid_param1);
    EXPECT_NE(order(1e9f), MissionResult::accepted);
    EXPECT_EQ(vehicle.mode, Mode::manual);
}

}  // namespace

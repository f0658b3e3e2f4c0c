// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/guidance.hpp"

#include <algorithm>

#include "firmware/estimator/estimator.hpp"
#include "firmware/guidance/launch.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::Path;
using firmware::state::vehicle;

constexpr geo::Position kHere = {470000000, 80000000};

class Guidance : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        mutable_vehicle.attitude.cos_roll = mutable_vehicle.attitude.cos_pitch = core::Ratio(1);
        mutable_vehicle.imu.accel_mss = core::Accelerations::from(0, 0, -core::kGravity_mss);
        mutable_vehicle.home.position = mutable_vehicle.estimate.position = kHere;
        mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d;
        mutable_vehicle.airspeed.healthy = true;
    }
    void standing() {
        move(0, 0);
        mutable_vehicle.estimate.airspeed_mps = mutable_vehicle.estimate.equivalent_airspeed_mps =
            0;
    }
    void cruising() {
        move(13, 0);
        mutable_vehicle.estimate.airspeed_mps = mutable_vehicle.estimate.equivalent_airspeed_mps =
            13;
    }
    void move(float north_mps, float east_mps) {
        mutable_vehicle.estimate.velocity_mps = {north_mps, east_mps, 0};
        mutable_vehicle.estimate.ground_speed_mps = mutable_vehicle.gps.ground_speed_mps =
            std::hypot(north_mps, east_mps);
    }
    // By both that measure it, above home, which is at sea level.
    void rise(float height_m) {
        mutable_vehicle.estimate.height_m = height_m;
        mutable_vehicle.gps.altitude_cm = static_cast<int32_t>(height_m * 100);
    }
    void bank(float roll_rad) {
        mutable_vehicle.attitude.roll_rad = core::Angle(roll_rad);
        mutable_vehicle.attitude.sin_roll = core::Ratio(std::sin(roll_rad));
        mutable_vehicle.attitude.cos_roll = core::Ratio(std::cos(roll_rad));
    }
    void place(float north_m, float east_m) {
        mutable_vehicle.estimate.position = geo::moved(kHere, {north_m, east_m});
    }
    // Tenths of a second, as the schedule runs the two.
    void guide(int tenths = 1) {
        for (int i = 0; i < tenths; ++i) {
            firmware::modes::runMode();
            firmware::guidance::runGuidance();
            firmware::guidance::runSpeedHeight();
            firmware::guidance::runGuidance();
        }
    }
    // LOITER lends its automatic throttle and guidance to any path.
    void demand(Path path) {
        auto& to_fly = mutable_vehicle.demand;
        to_fly.path = path;
        to_fly.from = kHere;
        to_fly.to = geo::moved(kHere, {500, 0});
        to_fly.from_height_m = to_fly.height_m = vehicle.estimate.height_m;
        to_fly.takeoff_pitch_rad = core::radians(15);
        to_fly.airspeed_mps = 13;
        to_fly.new_path = true;
    }
    void onTheGround(Mode mode) {
        fly(mode);
        mutable_vehicle.estimate.flying = false;
        mutable_vehicle.estimate.height_m = 0;
        standing();
    }
    void inTheAir() {
        cruising();
        fly(Mode::loiter);
        mutable_vehicle.demand.height_m = 80;
        guide(20);
        ASSERT_FALSE(vehicle.progress.throttle_suppressed);
    }
    // On a final of 300 m from 30 m, `left_m` before its end.
    void onFinal(float height_m, float left_m, float crosstrack_m = 0) {
        demand(Path::land);
        mutable_vehicle.demand.to = geo::moved(kHere, {300, 0});
        mutable_vehicle.demand.from_height_m = 30;
        mutable_vehicle.demand.height_m = 0;
        mutable_vehicle.estimate.height_m = height_m;
        mutable_vehicle.estimate.climb_mps = -1;
        place(300 - left_m, crosstrack_m);
    }
};

TEST_F(Guidance, does_nothing_in_a_mode_that_does_not_guide_itself) {
    mutable_vehicle.roll_demand_rad = core::Angle(0.1f);
    mutable_vehicle.throttle_demand = core::Ratio(0.2f);
    demand(Path::leg);
    firmware::guidance::runGuidance();
    firmware::guidance::runSpeedHeight();
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), 0.1f, 1e-4);
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), 0.2f, 1e-4);
    EXPECT_TRUE(vehicle.demand.new_path);
}

TEST_F(Guidance, holds_the_motor_on_the_ground_though_an_automatic_mode_is_chosen) {
    onTheGround(Mode::loiter);
    mutable_vehicle.demand.height_m = 50;
    guide(50);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    EXPECT_EQ(vehicle.throttle_demand.toFloat(), 0);
}

TEST_F(Guidance, lets_the_motor_turn_once_it_is_thrown) {
    onTheGround(Mode::loiter);
    mutable_vehicle.demand.height_m = 50;
    guide(5);
    cruising();
    guide(4);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
    guide(30);
    EXPECT_GT(vehicle.throttle_demand.toFloat(), 0.3f);
}

// In the hand: a receiver and an airspeed sensor that both send nonsense.
TEST_F(Guidance, takes_no_sensors_that_agree_for_a_moment_for_a_launch) {
    onTheGround(Mode::loiter);
    for (int times = 0; times < 5; ++times) {
        cruising();
        guide(3);
        EXPECT_TRUE(vehicle.progress.throttle_suppressed) << times;
        standing();
        guide(1);
    }
}

TEST_F(Guidance, begins_to_look_for_a_launch_anew_when_a_take_off_comes_between) {
    onTheGround(Mode::loiter);
    parameters.takeoff_min_accel_mss = 8;
    cruising();
    guide(3);
    demand(Path::takeoff);
    guide(1);
    demand(Path::leg);
    guide(1);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    parameters.takeoff_min_accel_mss = 0;
}

TEST_F(Guidance, takes_sensors_that_agree_for_a_moment_for_a_launch_when_it_has_flown) {
    onTheGround(Mode::loiter);
    mutable_vehicle.estimate.flying = true;
    cruising();
    guide(1);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
}

TEST_F(Guidance, does_not_take_a_fast_position_alone_for_a_launch) {
    onTheGround(Mode::loiter);
    move(9, 0);  // carried, or the receiver's mistake: no air flows
    guide(20);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    cruising();
    mutable_vehicle.gps.fix = firmware::state::GpsFix::none;
    guide(20);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
}

TEST_F(Guidance, holds_the_motor_after_it_came_down_outside_a_landing_until_it_is_thrown_again) {
    inTheAir();
    mutable_vehicle.estimate.flying = true;
    mutable_vehicle.estimate.height_m = 0;
    standing();
    guide(20);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed) << "not yet known to stand";
    mutable_vehicle.estimate.flying = false;
    guide(9);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed) << "for less than a second";
    guide(3);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    EXPECT_EQ(vehicle.throttle_demand.toFloat(), 0);
    cruising();
    guide(4);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
}

TEST_F(Guidance, holds_the_motor_after_it_came_down_though_home_was_set_in_the_air) {
    inTheAir();
    mutable_vehicle.estimate.flying = true;
    mutable_vehicle.home.altitude_cm += 6000;  // where it flies, 60 m above the field
    mutable_vehicle.gps.altitude_cm = mutable_vehicle.home.altitude_cm;
    firmware::estimator::shiftHeight(-60);
    mutable_vehicle.estimate.height_m = -60;
    mutable_vehicle.gps.altitude_cm -= 6000;
    standing();
    guide(20);
    mutable_vehicle.estimate.flying = false;
    guide(12);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    EXPECT_EQ(vehicle.throttle_demand.toFloat(), 0);
    firmware::estimator::shiftHeight(60);
}

TEST_F(Guidance, holds_the_motor_when_the_take_off_was_left_on_the_ground) {
    onTheGround(Mode::loiter);
    demand(Path::takeoff);
    mutable_vehicle.progress.throttle_suppressed = false;
    guide(30);
    ASSERT_FALSE(vehicle.progress.throttle_suppressed) << "it stands until it rolls";
    demand(Path::leg);
    guide(12);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
}

TEST_F(Guidance, does_not_take_a_slow_airplane_high_above_home_for_one_that_came_down) {
    inTheAir();
    mutable_vehicle.estimate.flying = true;
    rise(11);
    standing();
    guide(2);
    mutable_vehicle.estimate.flying = false;
    guide(20);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
}

TEST_F(Guidance, holds_the_motor_in_a_new_mode_where_it_landed_far_below_home) {
    inTheAir();
    mutable_vehicle.estimate.flying = true;
    guide(1);
    demand(Path::land);
    rise(-45);  // home was set in the air
    standing();
    guide(1);
    mutable_vehicle.estimate.flying = false;
    guide(1);
    using namespace firmware::modes;
    requestMode(Mode::manual, ModeReason::ground);
    guide(1);
    requestMode(Mode::loiter, ModeReason::ground);
    guide(20);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    rise(-34);
    guide(4);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed) << "11 m above where it stood";
}

TEST_F(Guidance, takes_less_than_10_m_of_height_for_no_launch) {
    onTheGround(Mode::loiter);
    guide(1);
    mutable_vehicle.estimate.height_m = 9;
    guide(20);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    mutable_vehicle.estimate.height_m = -9;
    guide(20);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
}

TEST_F(Guidance, takes_no_barometer_alone_for_a_launch) {
    onTheGround(Mode::loiter);
    guide(1);
    for (const float height_m : {200.0f, -200.0f}) {
        mutable_vehicle.estimate.height_m = height_m;
        guide(20);
        EXPECT_TRUE(vehicle.progress.throttle_suppressed) << height_m;
    }
}

TEST_F(Guidance, stops_the_motor_where_it_stands_whatever_the_barometer_says) {
    for (const bool tube : {true, false}) {
        onTheGround(Mode::loiter);
        guide(1);
        mutable_vehicle.airspeed.healthy = tube;
        mutable_vehicle.estimate.height_m = 200;
        mutable_vehicle.progress.throttle_suppressed = false;
        guide(12);
        EXPECT_TRUE(vehicle.progress.throttle_suppressed) << tube;
    }
}

// What each sensor shows of a flight, standing armed before.
struct Seen {
    const char* what;
    float ground_mps, air_mps, height_m, gps_height_m;
    bool fix, tube, turns, flew;
    bool flies;
};
constexpr Seen kSeen[] = {
    {"standing", 0, 0, 0, 0, true, true, false, false, false},
    {"wind in the tube", 0, 12, 0, 0, true, true, true, true, false},
    {"wind in the tube, and a broken barometer", 0, 12, 500, 0, true, true, true, true, false},
    {"wind in the tube, and a fix too high", 0, 12, 0, 50, true, true, true, true, false},
    {"carried fast", 9, 0, 0, 0, true, true, true, false, false},
    {"thrown", 9, 9, 0, 0, true, true, false, false, true},
    {"as slow as a flight begins", 5, 5, 0, 0, true, true, false, false, true},
    {"carried at a walk, wind and a broken barometer", 2, 12, 500, 0, true, true, false, false,
     true},
    {"10 m high, no more", 0, 12, 10, 10, true, true, false, false, false},
    {"10 m deep, no more", 0, 12, -10, -10, true, true, false, false, false},
    {"the tube clogged", 9, 0, 30, 30, true, true, false, false, true},
    {"hovering high in the wind", 0, 12, 30, 30, true, true, false, false, true},
    {"hovering, the tube clogged", 0, 0, 30, 30, true, true, false, false, true},
    {"the barometer at rest", 9, 9, 0, 30, true, true, false, false, true},
    {"the receiver's height at rest", 9, 9, 30, 0, true, true, false, false, true},
    {"no tube, the receiver hops", 9, 0, 0, 0, true, false, false, false, false},
    {"no tube, a broken barometer, rocked", 0, 0, 500, 0, true, false, true, false, false},
    {"no tube, a broken barometer, carried", 3, 0, 500, 0, true, false, true, false, false},
    {"no tube, thrown", 9, 0, 0, 0, true, false, true, false, true},
    {"no tube, high", 9, 0, 30, 30, true, false, false, false, true},
    {"no receiver, wind in the tube", 0, 12, 0, 0, false, true, true, true, false},
    {"no receiver, a broken barometer", 0, 0, 500, 0, false, true, true, false, false},
    {"no receiver, high", 0, 12, 30, 0, false, true, false, false, true},
    {"no receiver, high, the tube clogged", 0, 0, 30, 0, false, true, false, true, true},
    {"neither, standing", 0, 0, 0, 0, false, false, true, false, false},
    {"neither, a broken barometer", 0, 0, 500, 0, false, false, false, false, false},
    {"neither, high", 0, 0, 30, 0, false, false, true, false, true},
    {"neither, high, after a restart", 0, 0, 30, 0, false, false, false, true, true},
};

TEST_F(Guidance, takes_two_sensors_that_agree_for_a_launch) {
    for (const Seen& seen : kSeen) {
        onTheGround(Mode::loiter);
        rise(0);
        mutable_vehicle.imu.rate_rads.y = core::BodyRate(0.0f);
        mutable_vehicle.gps.fix = firmware::state::GpsFix::three_d;
        mutable_vehicle.airspeed.healthy = true;
        firmware::guidance::suppressThrottle();
        guide(2);
        ASSERT_TRUE(vehicle.progress.throttle_suppressed) << seen.what;
        move(seen.ground_mps, 0);
        rise(seen.gps_height_m);
        mutable_vehicle.estimate.height_m = seen.height_m;
        mutable_vehicle.estimate.airspeed_mps = seen.air_mps;
        mutable_vehicle.estimate.flying = seen.flew;
        mutable_vehicle.airspeed.healthy = seen.tube;
        if (!seen.fix) mutable_vehicle.gps.fix = firmware::state::GpsFix::none;
        if (seen.turns) mutable_vehicle.imu.rate_rads.y = core::BodyRate(0.3f);
        guide(4);
        EXPECT_EQ(vehicle.progress.throttle_suppressed, !seen.flies) << seen.what;
    }
}

TEST_F(Guidance, takes_a_fix_without_a_height_for_evidence_of_a_launch) {
    onTheGround(Mode::loiter);
    mutable_vehicle.gps.fix = firmware::state::GpsFix::two_d;
    cruising();
    guide(5);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
}

// Held with its nose up its weight acts from behind; level, the same is a push.
TEST_F(Guidance, takes_no_weight_for_a_push_of_the_launch) {
    constexpr float kNoseUp_rad = core::radians(40);
    for (const bool nose_up : {true, false}) {
        onTheGround(Mode::loiter);
        firmware::state::parameters.takeoff_min_accel_mss = 4;
        firmware::state::parameters.takeoff_min_speed_mps = 0;
        demand(Path::takeoff);
        mutable_vehicle.progress.throttle_suppressed = true;
        firmware::guidance::beginLaunch();
        mutable_vehicle.attitude.pitch_rad = core::Angle(nose_up ? kNoseUp_rad : 0);
        mutable_vehicle.attitude.sin_pitch = core::Ratio(nose_up ? std::sin(kNoseUp_rad) : 0);
        const float weight_mss = core::kGravity_mss * std::sin(kNoseUp_rad);
        mutable_vehicle.imu.accel_mss = core::Accelerations::from(weight_mss, 0, -7);
        guide(5);
        EXPECT_EQ(vehicle.progress.throttle_suppressed, nose_up);
    }
}

// The accelerometers move the estimate; an inertial sensor gone mad turns as well.
TEST_F(Guidance, takes_no_speed_for_a_launch_that_the_receiver_does_not_measure) {
    onTheGround(Mode::loiter);
    mutable_vehicle.airspeed.healthy = false;
    mutable_vehicle.imu.rate_rads.y = core::BodyRate(0.3f);
    move(9, 0);
    mutable_vehicle.gps.ground_speed_mps = 0.2f;
    guide(20);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    mutable_vehicle.gps.ground_speed_mps = 9;
    guide(4);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
}

// A receiver with noise of 20 m/s and a tube that sends nonsense, both fast at once.
TEST_F(Guidance, takes_no_speed_for_a_launch_of_a_receiver_whose_last_fix_was_refused) {
    for (const bool refused : {true, false}) {
        onTheGround(Mode::loiter);
        mutable_vehicle.airspeed.healthy = true;
        firmware::guidance::suppressThrottle();
        move(12, 0);
        mutable_vehicle.estimate.airspeed_mps = 12;
        mutable_vehicle.estimate.fix_refused = refused;
        guide(20);
        EXPECT_EQ(vehicle.progress.throttle_suppressed, refused);
    }
}

TEST_F(Guidance, leaves_the_motor_to_an_airplane_that_still_moves) {
    inTheAir();
    mutable_vehicle.estimate.height_m = 0;
    mutable_vehicle.estimate.flying = false;
    standing();
    move(3, 0);
    guide(30);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
}

TEST_F(Guidance, counts_the_height_of_a_launch_from_home_before_it_has_stood_armed) {
    inTheAir();
    mutable_vehicle.armed = false;
    mutable_vehicle.estimate.flying = false;
    mutable_vehicle.estimate.height_m = 3;
    guide(1);
    mutable_vehicle.estimate.flying = true;  // resumes, after a restart in the air
    mutable_vehicle.armed = true;
    standing();
    rise(11);
    guide(1);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
}

TEST_F(Guidance, does_not_take_another_home_for_a_launch) {
    onTheGround(Mode::loiter);
    guide(1);
    mutable_vehicle.home.altitude_cm -= 10000;
    mutable_vehicle.estimate.height_m += 100;
    guide(20);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
}

TEST_F(Guidance, never_lets_the_motor_turn_while_disarmed) {
    inTheAir();
    ASSERT_GT(vehicle.throttle_demand.toFloat(), 0);
    mutable_vehicle.armed = false;
    guide(1);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    guide(30);
    EXPECT_EQ(vehicle.throttle_demand.toFloat(), 0);
}

TEST_F(Guidance, takes_off_with_all_its_throttle_and_the_nose_up) {
    onTheGround(Mode::loiter);
    demand(Path::takeoff);
    mutable_vehicle.demand.height_m = 50;
    guide(2);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed) << "TKOFF_THR_DELAY has not passed";
    guide(20);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
    EXPECT_FLOAT_EQ(vehicle.throttle_demand.toFloat(), 1);
    EXPECT_EQ(vehicle.roll_demand_rad.toFloat(), 0);
    cruising();
    guide(20);
    EXPECT_GE(vehicle.pitch_demand_rad.toFloat(), core::radians(14.9f));
}

// What rolls gathers speed first; what is thrown sinks until there is thrust.
TEST_F(Guidance, has_all_its_throttle_at_once_where_it_is_thrown) {
    for (const bool thrown : {false, true}) {
        onTheGround(Mode::loiter);
        parameters.takeoff_min_accel_mss = thrown ? 15 : 0;
        demand(Path::takeoff);
        mutable_vehicle.demand.height_m = 50;
        mutable_vehicle.imu.accel_mss.x = core::Acceleration(20);
        while (vehicle.progress.throttle_suppressed) guide();
        guide();
        EXPECT_EQ(vehicle.throttle_demand.toFloat() > 0.99f, thrown);
    }
}

TEST_F(Guidance,
       takes_the_pitch_of_a_take_off_for_the_least_with_an_airspeed_sensor_else_as_it_is) {
    for (const bool sensor : {true, false}) {
        onTheGround(Mode::loiter);
        demand(Path::takeoff);
        mutable_vehicle.demand.height_m = 50;
        guide(22);
        cruising();
        mutable_vehicle.estimate.height_m = 10;
        mutable_vehicle.airspeed.healthy = sensor;
        mutable_vehicle.estimate.equivalent_airspeed_mps = mutable_vehicle.estimate.airspeed_mps =
            19;
        guide(60);  // far too fast: the nose may come up more
        const float pitch_deg = vehicle.pitch_demand_rad.toFloat() * 180 / core::kPi;
        if (sensor) {
            EXPECT_GT(pitch_deg, 16);
        } else {
            EXPECT_NEAR(pitch_deg, 15, 0.1);
        }
    }
}

TEST_F(Guidance, goes_on_with_a_take_off_that_a_restart_has_cut_short) {
    onTheGround(Mode::loiter);
    demand(Path::takeoff);
    mutable_vehicle.airspeed.healthy = false;
    mutable_vehicle.gps.fix = firmware::state::GpsFix::none;
    guide(1);
    mutable_vehicle.estimate.height_m = 30;
    guide(20);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed) << "a broken barometer";
    mutable_vehicle.estimate.flying = true;
    mutable_vehicle.estimate.height_m = 8;
    guide(20);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed) << "within reach of a hand";
    mutable_vehicle.estimate.height_m = 30;
    guide(1);
    EXPECT_FALSE(vehicle.progress.throttle_suppressed);
}

TEST_F(Guidance, waits_for_a_three_dimensional_fix_before_a_take_off) {
    onTheGround(Mode::loiter);
    demand(Path::takeoff);
    mutable_vehicle.gps.fix = firmware::state::GpsFix::two_d;
    guide(30);
    EXPECT_TRUE(vehicle.progress.throttle_suppressed);
    EXPECT_EQ(vehicle.throttle_demand.toFloat(), 0);
}

TEST_F(Guidance, banks_towards_the_leg) {
    inTheAir();
    for (float side_m : {-40.0f, 40.0f}) {
        demand(Path::leg);
        place(100, side_m);
        guide();
        EXPECT_GT(vehicle.roll_demand_rad.toFloat() * -side_m, 0) << side_m;
        EXPECT_NEAR(vehicle.progress.crosstrack_m, side_m, 0.2);
    }
}

TEST_F(Guidance, reports_the_leg_passed_and_begins_the_next_one_afresh) {
    inTheAir();
    demand(Path::leg);
    place(499, 0);
    guide();
    EXPECT_FALSE(vehicle.progress.passed);
    place(501, 0);
    guide();
    EXPECT_TRUE(vehicle.progress.passed);
    demand(Path::leg);
    mutable_vehicle.demand.to = geo::moved(kHere, {1000, 0});
    guide();
    EXPECT_FALSE(vehicle.progress.passed);
}

// A climb of 100 m along 500 m.
TEST_F(Guidance, begins_the_slope_anew_where_it_is_when_it_is_too_high_above_one_upwards) {
    inTheAir();
    demand(Path::leg);
    mutable_vehicle.demand.height_m = 180;
    mutable_vehicle.demand.sloped = true;
    parameters.glide_slope_threshold_m = 5;
    const auto planned_m = [&](float north_m, float height_m) {
        place(north_m, 0);
        mutable_vehicle.estimate.height_m = height_m;
        guide();
        return vehicle.progress.height_error_m + height_m;
    };
    EXPECT_NEAR(planned_m(100, 104.5f), 100, 0.1);
    EXPECT_NEAR(planned_m(200, 140), 140, 0.1);
    EXPECT_NEAR(planned_m(350, 150), 160, 0.1) << "half of what was left";
    EXPECT_NEAR(planned_m(400, 200), 180, 0.1) << "never higher than its end";
    EXPECT_NEAR(planned_m(490, 180), 180, 0.1);
}

TEST_F(Guidance, comes_down_to_a_descending_slope_or_on_command) {
    inTheAir();
    demand(Path::leg);
    mutable_vehicle.demand.height_m = 30;
    mutable_vehicle.demand.sloped = true;
    place(200, 0);
    guide(2);
    EXPECT_NEAR(vehicle.progress.height_error_m, -20, 0.1);
    demand(Path::leg);
    mutable_vehicle.demand.height_m = 130;
    parameters.glide_slope_threshold_m = 0;
    mutable_vehicle.estimate.height_m = 110;
    guide(2);
    EXPECT_NEAR(vehicle.progress.height_error_m, -10, 0.1);
}

TEST_F(Guidance, circles_in_the_demanded_direction) {
    const float tangent = 13 * 13 / 60.0f / core::kGravity_mss;
    for (bool counter_clockwise : {false, true}) {
        inTheAir();
        bank(counter_clockwise ? -std::atan(tangent) : std::atan(tangent));
        demand(Path::circle);
        mutable_vehicle.demand.to = kHere;
        mutable_vehicle.demand.radius_m = 60;
        mutable_vehicle.demand.counter_clockwise = counter_clockwise;
        place(0, counter_clockwise ? 60 : -60);  // so that north is along the circle
        guide(20);
        EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), vehicle.attitude.roll_rad.toFloat(), 0.05);
        firmware::modes::requestMode(Mode::manual, firmware::modes::ModeReason::ground);
    }
}

// 45 degrees take 17 m/s and 10 m/s of wind from behind around a circle of 74.3 m.
TEST_F(Guidance, widens_a_circle_that_is_too_tight_for_the_bank_limit_and_reports_it_once) {
    const std::string text = "4 Circle widened";
    for (const float wind_mps : {0.0f, 7.0f, 10.0f}) {
        inTheAir();
        demand(Path::circle);
        mutable_vehicle.demand.to = kHere;
        mutable_vehicle.demand.radius_m = 60;
        mutable_vehicle.demand.airspeed_mps = 17;
        mutable_vehicle.estimate.wind_mps = {0, wind_mps, 0};
        place(0, -80);
        bench::statusTexts();
        guide(20);
        const auto texts = bench::statusTexts();
        EXPECT_NEAR(vehicle.progress.crosstrack_m, wind_mps < 10 ? 20 : 5.7, 0.1) << wind_mps;
        EXPECT_EQ(std::count(texts.begin(), texts.end(), text), wind_mps < 10 ? 0 : 1);
        firmware::modes::requestMode(Mode::manual, firmware::modes::ModeReason::ground);
    }
}

// Long wings bank 0.4 s after the demand, and then with a lag of 0.3 s.
TEST_F(Guidance, a_leg_is_joined_without_swinging_by_wings_that_roll_slowly) {
    constexpr float kStep_s = 0.05f, kLag_s = 0.3f;
    parameters.lateral.period_s = 4;
    inTheAir();
    demand(Path::leg);
    mutable_vehicle.demand.to = geo::moved(kHere, {2000, 0});
    float north_m = 0, east_m = 30, course_rad = 0, bank_rad = 0;
    float demanded_rad[8] = {};
    int changes = 0, side = 0;
    for (int i = 0; i < 600; ++i) {
        move(13 * std::cos(course_rad), 13 * std::sin(course_rad));
        place(north_m, east_m);
        bank(bank_rad);
        firmware::modes::runMode();
        firmware::guidance::runGuidance();
        std::copy(demanded_rad + 1, demanded_rad + 8, demanded_rad);
        demanded_rad[7] = vehicle.roll_demand_rad.toFloat();
        bank_rad += (demanded_rad[0] - bank_rad) * kStep_s / kLag_s;
        course_rad += core::kGravity_mss * std::tan(bank_rad) / 13 * kStep_s;
        north_m += 13 * std::cos(course_rad) * kStep_s;
        east_m += 13 * std::sin(course_rad) * kStep_s;
        const int now = bank_rad > core::radians(3) ? 1 : bank_rad < -core::radians(3) ? -1 : side;
        changes += now != side;
        side = now;
    }
    EXPECT_LE(changes, 3);
    EXPECT_NEAR(east_m, 0, 1);
}

TEST_F(Guidance, the_sign_of_the_loiter_radius_is_its_direction) {
    for (int16_t radius_m : {60, -60}) {
        parameters.loiter_radius_m = radius_m;
        fly(Mode::loiter);
        EXPECT_EQ(vehicle.demand.counter_clockwise, radius_m < 0);
        EXPECT_EQ(vehicle.demand.radius_m, 60);
        firmware::modes::requestMode(Mode::manual, firmware::modes::ModeReason::ground);
    }
}

TEST_F(Guidance, counts_turns_from_the_moment_it_is_on_the_circle) {
    inTheAir();
    demand(Path::circle);
    mutable_vehicle.demand.to = kHere;
    mutable_vehicle.demand.radius_m = 60;
    place(-120, 0);
    guide();
    EXPECT_FALSE(vehicle.progress.captured);
    for (int degrees = 0; degrees <= 450; degrees += 3) {
        const float angle_rad = core::radians(degrees);
        place(60 * std::cos(angle_rad), 60 * std::sin(angle_rad));
        move(-13 * std::sin(angle_rad), 13 * std::cos(angle_rad));
        guide();
    }
    EXPECT_TRUE(vehicle.progress.captured);
    EXPECT_NEAR(vehicle.progress.turned_rad, core::radians(450), 0.05);
}

TEST_F(Guidance, flares_without_throttle_in_calm_air_and_with_level_wings) {
    inTheAir();
    onFinal(20, 200, 10);
    guide(10);
    ASSERT_FALSE(vehicle.progress.flaring);
    EXPECT_LT(vehicle.roll_demand_rad.toFloat(), -core::radians(parameters.level_roll_limit_deg));

    mutable_vehicle.estimate.height_m = 1;
    place(290, 10);
    guide(11);
    EXPECT_TRUE(vehicle.progress.flaring);
    EXPECT_EQ(vehicle.throttle_demand.toFloat(), 0);
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), -core::radians(parameters.level_roll_limit_deg),
                1e-4);
}

TEST_F(Guidance, approaches_faster_in_gusts_and_no_slower_in_a_lull) {
    inTheAir();
    onFinal(20, 200);
    mutable_vehicle.estimate.wind_mps = {-5, 0, 0};
    move(8, 0);
    const auto planned_mps = [this](float gust_mps) {
        auto& estimate = mutable_vehicle.estimate;
        estimate.airspeed_mps = estimate.equivalent_airspeed_mps = 13 + gust_mps;
        firmware::guidance::runGuidance();
        return vehicle.progress.airspeed_error_mps + estimate.equivalent_airspeed_mps;
    };
    const float steady_mps =
        parameters.speed_min_mps + 0.55f * (13 - parameters.speed_min_mps) + 0.6f * 5;
    EXPECT_NEAR(planned_mps(0), steady_mps, 0.01);
    EXPECT_NEAR(planned_mps(-3), steady_mps, 0.01) << "a lull";
    for (const float gust_mps : {0.7f, 1.2f, 4.0f}) {
        for (int i = 0; i < 600; ++i) planned_mps(i % 2 == 0 ? gust_mps : -gust_mps);
        const float faster_mps = core::limit(3 * (gust_mps - 0.6f), 0.0f, 4.0f);
        EXPECT_NEAR(planned_mps(gust_mps), steady_mps + faster_mps, 0.2) << gust_mps;
    }
    mutable_vehicle.estimate.wind_mps = {2, 0, 0};
    move(15, 0);
    EXPECT_NEAR(planned_mps(0), steady_mps - 0.6f * 5 + 4, 0.2)
        << "gusts count as much with the wind from behind";
}

TEST_F(Guidance, is_not_sped_up_by_a_gust_just_above_the_ground) {
    inTheAir();
    onFinal(3.9f, 60);
    guide();
    EXPECT_FALSE(vehicle.progress.flaring);
    const float before_mps = vehicle.progress.airspeed_error_mps;
    move(18, 0);  // a wind from behind, of which the estimate does not know yet
    guide(40);
    EXPECT_FALSE(vehicle.progress.flaring);
    EXPECT_NEAR(vehicle.progress.airspeed_error_mps, before_mps, 0.2);
}

TEST_F(Guidance, takes_no_turn_onto_the_last_leg_for_gusts) {
    inTheAir();
    onFinal(20, 200);
    guide();
    const float calm_mps = vehicle.progress.airspeed_error_mps;
    move(0, 13);
    guide(20);
    move(13, 0);
    guide();
    EXPECT_NEAR(vehicle.progress.airspeed_error_mps, calm_mps, 0.2);
}

TEST_F(Guidance, what_the_ground_speed_is_short_of_keeps_power_in_the_flare) {
    const float calm_mps = parameters.speed_min_mps + 0.55f * (13 - parameters.speed_min_mps);
    const auto throttle = [&](float short_mps, float height_m, float left_m) {
        inTheAir();
        onFinal(height_m, left_m);
        move(calm_mps - short_mps, 0);
        guide(15);
        EXPECT_TRUE(vehicle.progress.flaring);
        return vehicle.throttle_demand.toFloat();
    };
    const float cruise = parameters.cruise_throttle_pct * 0.01f;
    EXPECT_NEAR(throttle(3, 1.2f, 12), 1.4f * cruise, 0.01);
    EXPECT_NEAR(throttle(0.4f, 1.2f, 12), 0.3f * 1.4f * cruise, 0.01);
    EXPECT_NEAR(throttle(3, 0.3f, 12), 1.4f / 3 * cruise, 0.01);
    EXPECT_EQ(throttle(3, 0, 12), 0);
    EXPECT_EQ(throttle(3, 1.2f, -16), 0) << "it stands on the ground, and the height is wrong";
    EXPECT_EQ(throttle(-2, 1.2f, 12), 0) << "fast enough";
    ASSERT_EQ(throttle(0, 1.2f, 12), 0);
    auto& estimate = mutable_vehicle.estimate;
    estimate.airspeed_mps = 1.15f * estimate.equivalent_airspeed_mps;  // 2,800 m above the sea
    guide(15);
    EXPECT_GT(vehicle.throttle_demand.toFloat(), 0.5f * cruise) << "in thin air it flies faster";
}

TEST_F(Guidance, what_a_lull_takes_below_the_lowest_speed_opens_the_throttle_in_the_flare) {
    inTheAir();
    onFinal(1.2f, 12);
    const auto throttle = [this](float below_mps) {
        auto& estimate = mutable_vehicle.estimate;
        estimate.airspeed_mps = estimate.equivalent_airspeed_mps =
            parameters.speed_min_mps - below_mps;
        guide(15);
        EXPECT_TRUE(vehicle.progress.flaring);
        return vehicle.throttle_demand.toFloat();
    };
    const float cruise = parameters.cruise_throttle_pct * 0.01f;
    EXPECT_EQ(throttle(0), 0);
    EXPECT_NEAR(throttle(0.4f), 0.3f * 1.4f * cruise, 0.01);
    EXPECT_NEAR(throttle(2), 1.4f * cruise, 0.01);
    mutable_vehicle.estimate.height_m = 0;
    EXPECT_EQ(throttle(2), 0) << "on the ground it is to become slower";
}

TEST_F(Guidance, the_nose_may_be_lower_in_the_flare_than_at_the_ground) {
    const auto pitch_rad = [this](float height_m) {
        inTheAir();
        onFinal(height_m, 12);
        mutable_vehicle.estimate.climb_mps = 0.8f;
        guide(15);
        return vehicle.pitch_demand_rad.toFloat();
    };
    EXPECT_NEAR(pitch_rad(0), core::radiansFromCentidegrees(parameters.land_pitch_cd), 0.001);
    EXPECT_LT(pitch_rad(1), core::radians(-3));
}

TEST_F(Guidance, gives_up_a_flare_high_above_the_field_at_the_height_where_it_is) {
    inTheAir();
    firmware::estimator::shiftHeight(-50);  // home was set in the air
    onFinal(1, 10);
    guide(2);
    ASSERT_TRUE(vehicle.progress.flaring);
    mutable_vehicle.estimate.height_m = -3.5f;
    place(310, 0);
    firmware::guidance::runGuidance();
    EXPECT_FALSE(vehicle.progress.flaring);
    EXPECT_NEAR(vehicle.progress.height_error_m, 0, 0.5);
    guide();
    EXPECT_LT(vehicle.progress.height_error_m, -3) << "and comes down to the field";

    mutable_vehicle.estimate.height_m = -49;
    guide();
    EXPECT_TRUE(vehicle.progress.flaring);
}

TEST_F(Guidance, does_not_flare_in_pilot_modes) {
    inTheAir();
    onFinal(0.5f, 10);
    guide(2);
    ASSERT_TRUE(vehicle.progress.flaring);
    firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
    guide();
    EXPECT_FALSE(vehicle.progress.flaring) << "its pitch is not twice as fast";
}

TEST_F(Guidance, steers_along_the_runway_from_the_flare_on) {
    inTheAir();
    onFinal(20, 200);
    mutable_vehicle.attitude.yaw_rad = core::Angle(0.2f);
    guide(5);
    EXPECT_EQ(vehicle.rudder_demand.toFloat(), 0) << "in the air the wings do that";
    EXPECT_FALSE(vehicle.progress.steering);

    mutable_vehicle.estimate.height_m = 0.5f;
    guide(2);
    EXPECT_LT(vehicle.rudder_demand.toFloat(), -0.03f) << "the nose points right of the runway";
    EXPECT_TRUE(vehicle.progress.steering);
    mutable_vehicle.attitude.yaw_rad = core::Angle(-0.2f);
    guide();
    EXPECT_GT(vehicle.rudder_demand.toFloat(), 0.03f);
    mutable_vehicle.attitude.yaw_rad = core::Angle(0);
    place(290, 3);
    guide();
    EXPECT_LT(vehicle.rudder_demand.toFloat(), -0.01f) << "beside its middle";
    mutable_vehicle.attitude.yaw_rad = core::Angle(3);
    mutable_vehicle.estimate.ground_speed_mps = 4;
    guide();
    EXPECT_GE(vehicle.rudder_demand.toFloat(), -0.35f)
        << "a wheel at full lock overturns the airplane";
}

TEST_F(Guidance, steers_less_where_the_wheel_turns_it_quickly) {
    inTheAir();
    onFinal(20, 200);
    mutable_vehicle.estimate.height_m = 0.5f;
    mutable_vehicle.attitude.yaw_rad = core::Angle(0.2f);
    guide(2);
    ASSERT_GT(vehicle.estimate.ground_speed_mps, 8);
    const float fast = vehicle.rudder_demand.toFloat();
    mutable_vehicle.estimate.ground_speed_mps = 4;
    guide();
    EXPECT_NEAR(vehicle.rudder_demand.toFloat(), fast / 0.3f, 0.005);
}

TEST_F(Guidance, keeps_the_nose_from_swinging_in_the_take_off_run) {
    onTheGround(Mode::loiter);
    demand(Path::takeoff);
    guide(20);
    EXPECT_EQ(vehicle.rudder_demand.toFloat(), 0);
    EXPECT_TRUE(vehicle.progress.steering);
    mutable_vehicle.attitude.rate_rads.z = core::BodyRate(0.6f);
    guide();
    EXPECT_LT(vehicle.rudder_demand.toFloat(), -0.05f);
    mutable_vehicle.estimate.height_m = 5;
    guide();
    EXPECT_EQ(vehicle.rudder_demand.toFloat(), 0) << "airborne";
    EXPECT_FALSE(vehicle.progress.steering);
}

// It has no wheel on the ground, and needs its rudder to fly.
TEST_F(Guidance, does_not_steer_what_is_thrown) {
    onTheGround(Mode::loiter);
    parameters.takeoff_min_accel_mss = 15;
    demand(Path::takeoff);
    mutable_vehicle.attitude.rate_rads.z = core::BodyRate(0.6f);
    guide(2);
    EXPECT_FALSE(vehicle.progress.steering);
    EXPECT_EQ(vehicle.rudder_demand.toFloat(), 0);
}

// The nose would go down first, and come up again while the airplane sinks.
TEST_F(Guidance, goes_on_from_the_nose_of_the_throw) {
    onTheGround(Mode::loiter);
    parameters.takeoff_min_accel_mss = 15;
    mutable_vehicle.attitude.pitch_rad = core::Angle(core::radians(15));
    demand(Path::takeoff);
    mutable_vehicle.demand.height_m = 50;
    guide(5);
    ASSERT_TRUE(vehicle.progress.throttle_suppressed);
    cruising();
    mutable_vehicle.imu.accel_mss.x = core::Acceleration(20);
    while (vehicle.progress.throttle_suppressed) guide();
    EXPECT_GT(vehicle.pitch_demand_rad.toFloat(), core::radians(10));
}

TEST_F(Guidance, stops_steering_once_the_pilot_flies) {
    inTheAir();
    onFinal(0.5f, 10);
    mutable_vehicle.attitude.yaw_rad = core::Angle(0.2f);
    guide(2);
    ASSERT_NE(vehicle.rudder_demand.toFloat(), 0);
    firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
    guide();
    EXPECT_EQ(vehicle.rudder_demand.toFloat(), 0);
    EXPECT_FALSE(vehicle.progress.steering);
}

TEST_F(Guidance, gives_up_height_and_opens_the_throttle_below_the_lowest_speed) {
    inTheAir();
    guide(50);
    const float level_rad = vehicle.pitch_demand_rad.toFloat();
    mutable_vehicle.estimate.airspeed_mps = mutable_vehicle.estimate.equivalent_airspeed_mps = 7;
    mutable_vehicle.imu.accel_mss.x = core::Acceleration(-2);
    guide(30);
    EXPECT_LT(vehicle.pitch_demand_rad.toFloat(), level_rad - 0.1f);
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), parameters.throttle_max_pct * 0.01f, 0.01);
}

TEST_F(Guidance, banks_no_more_than_the_wings_carry_when_it_is_slow) {
    inTheAir();
    demand(Path::leg);
    place(100, -200);
    guide();
    const float most_rad = core::radiansFromCentidegrees(parameters.roll_limit_cd);
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), most_rad, 1e-4);
    mutable_vehicle.estimate.equivalent_airspeed_mps = parameters.speed_min_mps;
    guide();
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), core::radians(25), 0.01);
}

TEST_F(Guidance, lets_the_throttle_follow_the_pitch_without_an_airspeed_sensor) {
    mutable_vehicle.airspeed.healthy = false;
    inTheAir();
    mutable_vehicle.demand.height_m = 80;
    guide(50);
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), parameters.cruise_throttle_pct * 0.01f, 0.1);
    mutable_vehicle.demand.height_m = 120;
    guide(20);
    EXPECT_GT(vehicle.pitch_demand_rad.toFloat(), 0.1f);
    EXPECT_GT(vehicle.throttle_demand.toFloat(), 0.6f);
}

TEST_F(Guidance, keeps_away_from_the_stall_without_an_airspeed_sensor) {
    mutable_vehicle.airspeed.healthy = false;
    inTheAir();
    mutable_vehicle.estimate.height_m = 65;  // far too low: all the pitch there is is asked for
    guide(40);
    EXPECT_NEAR(vehicle.pitch_demand_rad.toFloat(), 0.2f, 0.001)
        << "of angle of attack, on a level path";
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), parameters.throttle_max_pct * 0.01f, 0.01);

    mutable_vehicle.estimate.climb_mps = -1.3f;  // and sinking on: the path itself points down
    guide(20);
    EXPECT_NEAR(vehicle.pitch_demand_rad.toFloat(), 0.1f, 0.001);
}

TEST_F(Guidance, closes_the_throttle_little_on_a_gentle_descent_without_an_airspeed_sensor) {
    mutable_vehicle.airspeed.healthy = false;
    inTheAir();
    demand(Path::leg);
    mutable_vehicle.demand.height_m = 60;
    mutable_vehicle.demand.climb_rate_mps = 0.8f;
    mutable_vehicle.estimate.climb_mps = -0.8f;
    for (int i = 0; i < 100; ++i) {
        mutable_vehicle.estimate.height_m = vehicle.demand.from_height_m;
        guide();
    }
    EXPECT_GT(vehicle.throttle_demand.toFloat(), 0.25f);
    EXPECT_LT(vehicle.throttle_demand.toFloat(), parameters.cruise_throttle_pct * 0.01f);
}

TEST_F(Guidance, is_not_misled_by_a_low_ground_speed_without_an_airspeed_sensor) {
    mutable_vehicle.airspeed.healthy = false;
    inTheAir();
    guide(20);
    const float pitch_rad = vehicle.pitch_demand_rad.toFloat();
    move(4, 0);  // into the wind: flying all the same
    mutable_vehicle.estimate.airspeed_mps = mutable_vehicle.estimate.equivalent_airspeed_mps = 4;
    mutable_vehicle.estimate.climb_mps = 0.3f;
    guide(20);
    EXPECT_NEAR(vehicle.pitch_demand_rad.toFloat(), pitch_rad, 0.06);
}

TEST_F(Guidance, flies_faster_into_a_wind_that_leaves_less_than_the_least_ground_speed) {
    inTheAir();
    const auto demanded_mps = [&](int16_t least_cms, float wind_mps) {
        parameters.min_ground_speed_cms = least_cms;
        mutable_vehicle.estimate.wind_mps = {wind_mps, 0, 0};
        move(13 + wind_mps, 0);
        guide();
        return firmware::guidance::demandedAirspeed_mps();
    };
    EXPECT_EQ(demanded_mps(0, -10), 13) << "none is set";
    EXPECT_EQ(demanded_mps(500, -7), 13) << "fast enough";
    EXPECT_EQ(demanded_mps(500, 10), 13) << "down the wind";
    EXPECT_NEAR(demanded_mps(500, -10), 15, 0.01);
    EXPECT_NEAR(demanded_mps(500, -15), 20, 0.01) << "blown backwards";
    EXPECT_EQ(demanded_mps(500, -25), parameters.speed_max_mps);
    mutable_vehicle.demand.airspeed_mps = parameters.speed_max_mps + 1.0f;
    EXPECT_EQ(demanded_mps(500, -25), parameters.speed_max_mps + 1.0f) << "never slower for it";
}

// For no more than that it is not worked out in a breeze, which leaves it forward speed enough.
TEST_F(Guidance, keeps_3_mps_over_ground_if_nothing_else_is_set) {
    inTheAir();
    const auto demanded_mps = [&](float north_mps, float east_mps) {
        mutable_vehicle.estimate.wind_mps = {north_mps, east_mps, 0};
        move(13 + north_mps, east_mps);
        guide();
        return firmware::guidance::demandedAirspeed_mps();
    };
    EXPECT_EQ(demanded_mps(-5.9f, 5.9f), 13);
    EXPECT_EQ(demanded_mps(-8, 0), 13) << "5 m/s are left";
    EXPECT_NEAR(demanded_mps(-16, 0), 19, 0.01);
    EXPECT_NEAR(demanded_mps(-16, 5), 19, 0.01);
    EXPECT_EQ(demanded_mps(-25, 0), parameters.speed_max_mps);
}

TEST_F(Guidance, is_blown_back_where_the_wind_is_faster_than_it) {
    const auto blown_back = [&](float wind_mps, int16_t least_cms) {
        parameters.min_ground_speed_cms = least_cms;
        mutable_vehicle.estimate.wind_mps = {wind_mps, 0, 0};
        move(13 + wind_mps, 0);
        guide();
        return vehicle.progress.blown_back;
    };
    inTheAir();
    EXPECT_FALSE(blown_back(-12.9f, 300)) << "it flies 13 m/s";
    EXPECT_TRUE(blown_back(-13.1f, 300));
    EXPECT_FALSE(blown_back(-5, 300)) << "a breeze";
    EXPECT_TRUE(blown_back(-13.1f, 500));
    EXPECT_FALSE(blown_back(-12.9f, 500));
    EXPECT_FALSE(blown_back(-30, 0)) << "nobody asks";
    EXPECT_TRUE(blown_back(-30, 300));
    firmware::modes::requestMode(Mode::manual, firmware::modes::ModeReason::ground);
    guide();
    EXPECT_FALSE(vehicle.progress.blown_back) << "the pilot flies";
}

// The speed over ground is the one ahead: a crab sideways brings it nowhere.
TEST_F(Guidance, counts_the_ground_speed_along_the_nose_and_true) {
    inTheAir();
    parameters.min_ground_speed_cms = 500;
    mutable_vehicle.estimate.wind_mps = {-13, 9, 0};
    move(0, 9);
    guide();
    EXPECT_NEAR(firmware::guidance::demandedAirspeed_mps(), 18, 0.01);
    mutable_vehicle.estimate.equivalent_airspeed_mps = 13 / 1.2f;  // 3,600 m above the sea
    guide();
    EXPECT_NEAR(firmware::guidance::demandedAirspeed_mps(), 18 / 1.2f, 0.01);
}

TEST_F(Guidance, a_stick_above_its_middle_asks_for_more_speed_if_nudging_is_on) {
    inTheAir();
    guide(50);
    const float unmoved = vehicle.throttle_demand.toFloat();
    mutable_vehicle.radio.throttle_pct = 100;
    parameters.throttle_nudge = 0;
    guide(5);
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), unmoved, 0.05);
    parameters.throttle_nudge = 1;
    guide(20);
    EXPECT_GT(vehicle.throttle_demand.toFloat(), unmoved + 0.1f);
}

TEST_F(Guidance, moves_the_height_at_the_rate_a_condition_asks_for) {
    inTheAir();
    demand(Path::leg);
    mutable_vehicle.demand.height_m = 100;
    mutable_vehicle.demand.climb_rate_mps = 2;
    guide(30);
    EXPECT_NEAR(vehicle.demand.from_height_m, 80 + 6, 0.2);
}

}  // namespace

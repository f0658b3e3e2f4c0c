// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/stall.hpp"

#include <cmath>

#include "core/maths.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using core::radians;
using firmware::control::surfaces;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::Path;
using Phase = control::Stall::Phase;

constexpr float kUp = 0.5f;  // of the elevator, where a loop pulls

class StallInFlight : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        auto& estimate = mutable_vehicle.estimate;
        mutable_vehicle.imu.periods = 2;
        estimate.equivalent_airspeed_mps = parameters.scaling_speed_mps;
        estimate.climb_mps = -8;
        fall(15, -35);
        fly(Mode::fbwa);
    }
    static void fall(float roll_deg, float pitch_deg) {
        auto& attitude = mutable_vehicle.attitude;
        const float roll_rad = radians(roll_deg), pitch_rad = radians(pitch_deg);
        attitude.roll_rad = core::Angle(roll_rad);
        attitude.pitch_rad = core::Angle(pitch_rad);
        attitude.sin_roll = core::Ratio(std::sin(roll_rad));
        attitude.cos_roll = core::Ratio(std::cos(roll_rad));
        attitude.sin_pitch = core::Ratio(std::sin(pitch_rad));
        attitude.cos_pitch = core::Ratio(std::cos(pitch_rad));
    }
    // With the rows as often as the schedule has them.
    static Phase after(float seconds) {
        prepareControl();
        for (int i = 0; i < seconds * 100; ++i) {
            firmware::modes::runMode();
            firmware::control::runAttitudeControl();
            if (i % 5 == 3) firmware::control::runStall();
        }
        return firmware::control::stall_recovery.phase;
    }
    void guide(Path path) {
        fly(Mode::loiter);
        mutable_vehicle.demand.path = path;
        mutable_vehicle.pitch_demand_rad = core::Angle(0.1f);
    }
};

TEST_F(StallInFlight, lets_the_elevator_go) {
    after(0.2f);
    EXPECT_GT(surfaces.elevator.toFloat(), kUp);
    ASSERT_EQ(after(0.4f), Phase::breaking);
    EXPECT_NEAR(surfaces.elevator.toFloat(), -0.1f, 0.01);
}

// As fast as it cruises, its nose 12 degrees up where the height is demanded, it falls with 33
// degrees of angle of attack: by full throttle and a quarter of the elevator, down to the ground.
struct NoseUp : StallInFlight {
    void SetUp() override {
        StallInFlight::SetUp();
        guide(Path::leg);
        fall(0, 12);
        mutable_vehicle.pitch_demand_rad = core::Angle(radians(20));
        auto& estimate = mutable_vehicle.estimate;
        estimate.airspeed_mps = estimate.equivalent_airspeed_mps = 13;
        estimate.climb_mps = -4.5f;
    }
};

TEST_F(NoseUp, is_a_stall_where_the_airplane_falls) {
    ASSERT_GT(parameters.speed_min_mps, 8);
    after(0.2f);
    EXPECT_GT(surfaces.elevator.toFloat(), 0.15f);
    EXPECT_LT(surfaces.elevator.toFloat(), 0.35f) << "less than where the nose does not follow";
    EXPECT_EQ(after(0.6f), Phase::breaking);
    EXPECT_NEAR(surfaces.throttle.toFloat(), parameters.throttle_max_pct * 0.01f, 0.01);
}

TEST_F(NoseUp, keeps_low_until_it_falls_no_longer) {
    ASSERT_EQ(after(2.2f), Phase::pulling_out);
    fall(0, -4);
    mutable_vehicle.estimate.climb_mps = -7;
    after(0.1f);
    EXPECT_LE(surfaces.elevator.toFloat(), 0.0f);
}

TEST_F(NoseUp, is_none_in_air_that_sinks) {
    mutable_vehicle.estimate.climb_mps = -2.5f;
    EXPECT_EQ(after(2), Phase::flying);
}

TEST_F(NoseUp, is_none_where_an_airspeed_sensor_that_reads_little_shows_one) {
    fall(0, -10);
    mutable_vehicle.pitch_demand_rad = core::Angle(radians(-5));
    mutable_vehicle.estimate.airspeed_mps = 3;
    EXPECT_EQ(after(2), Phase::flying);
}

// The body turns about its wings with the turn alone, while the nose stays where it is.
TEST_F(StallInFlight, is_found_in_a_turn_to_either_side) {
    for (const float side : {1.0f, -1.0f}) {
        SetUp();
        fall(45 * side, -35);
        auto& rate_rads = mutable_vehicle.attitude.rate_rads;
        rate_rads.y = core::BodyRate(0.5f);
        rate_rads.z = core::BodyRate(0.5f * side);
        EXPECT_EQ(after(0.6f), Phase::breaking) << side;
        rate_rads = core::BodyRates::from(0, 0, 0);
    }
}

TEST_F(StallInFlight, levels_the_wings_whatever_the_stick_demands_with_little_aileron) {
    settle(with(1, 1900));
    fall(30, -35);
    ASSERT_EQ(after(0.6f), Phase::breaking);
    EXPECT_LT(surfaces.aileron.toFloat(), -0.1f);
    fall(80, -35);
    after(0.05f);
    EXPECT_NEAR(surfaces.aileron.toFloat(), -0.4f, 0.01);
}

TEST_F(StallInFlight, pulls_out_gently) {
    ASSERT_EQ(after(0.8f), Phase::pulling_out);
    mutable_vehicle.attitude.rate_rads.y = core::BodyRate(radians(25));
    after(0.01f);
    EXPECT_LT(std::abs(surfaces.elevator.toFloat()), 0.25f);
}

TEST_F(StallInFlight, flies_on_when_the_nose_is_back) {
    ASSERT_EQ(after(0.8f), Phase::pulling_out);
    fall(0, 0);
    mutable_vehicle.estimate.climb_mps = -1;
    EXPECT_EQ(after(0.1f), Phase::flying);
}

TEST_F(StallInFlight, leaves_the_nose_low_while_it_is_slow) {
    mutable_vehicle.estimate.equivalent_airspeed_mps = 0.9f * parameters.speed_min_mps;
    ASSERT_EQ(after(2.0f), Phase::pulling_out);
    fall(0, -4);
    after(0.1f);
    EXPECT_LE(surfaces.elevator.toFloat(), 0.0f);
}

TEST_F(StallInFlight, opens_the_throttle_where_it_is_the_firmwares) {
    guide(Path::leg);
    mutable_vehicle.throttle_demand = core::Ratio(0.2f);
    ASSERT_EQ(after(0.6f), Phase::breaking);
    EXPECT_NEAR(surfaces.throttle.toFloat(), parameters.throttle_max_pct * 0.01f, 0.01);
}

TEST_F(StallInFlight, leaves_the_pilot_his_throttle) {
    ASSERT_EQ(after(0.6f), Phase::breaking);
    EXPECT_NEAR(surfaces.throttle.toFloat(), 0, 0.01);
}

TEST_F(StallInFlight, needs_neither_height_nor_sink_without_a_barometer) {
    mutable_vehicle.baro.healthy = false;
    mutable_vehicle.estimate.climb_mps = 0;
    mutable_vehicle.estimate.height_m = 0;
    EXPECT_EQ(after(0.6f), Phase::breaking);
}

// A mission may set home where the airplane is.
TEST_F(StallInFlight, is_looked_for_high_above_the_field_wherever_home_is) {
    mutable_vehicle.estimate.height_m = 80;
    firmware::estimator::shiftHeight(-75);
    EXPECT_EQ(after(0.6f), Phase::breaking);
}

TEST_F(StallInFlight, ends_with_what_made_it_possible) {
    ASSERT_EQ(after(0.6f), Phase::breaking);
    parameters.stall_prevention = 0;
    EXPECT_EQ(after(0.1f), Phase::flying);
}

TEST_F(StallInFlight, is_not_looked_for_where_it_would_be_in_the_way) {
    struct Case {
        const char* name;
        void (*set)();
    };
    const Case kCases[] = {
        {"not wanted", [] { parameters.stall_prevention = 0; }},
        {"disarmed", [] { mutable_vehicle.armed = false; }},
        {"standing", [] { mutable_vehicle.estimate.flying = false; }},
        {"no attitude", [] { mutable_vehicle.imu.healthy = false; }},
        {"upside down", [] { mutable_vehicle.inverted = true; }},
        {"a pilot's flare", [] { mutable_vehicle.estimate.height_m = 8; }},
        {"a flare", [] { mutable_vehicle.progress.flaring = true; }},
        {"level flight", [] { mutable_vehicle.estimate.climb_mps = -0.5f; }},
    };
    for (const Case& each : kCases) {
        SetUp();
        each.set();
        EXPECT_EQ(after(0.6f), Phase::flying) << each.name;
    }
}

TEST_F(StallInFlight, is_not_looked_for_in_a_takeoff) {
    guide(Path::takeoff);
    EXPECT_EQ(after(0.6f), Phase::flying);
}

// A test of the elevator can stall an airplane, and the step after it would hold the nose up.
TEST_F(StallInFlight, is_recovered_from_in_autotune) {
    fly(Mode::autotune);
    EXPECT_EQ(after(0.6f), Phase::breaking);
}

TEST_F(StallInFlight, is_not_looked_for_where_the_stick_is_the_elevator) {
    for (Mode mode : {Mode::manual, Mode::training, Mode::acro}) {
        SetUp();
        fly(mode);
        EXPECT_EQ(after(0.6f), Phase::flying) << static_cast<int>(mode);
    }
    SetUp();
    settle(with(2, 1100));
    fly(Mode::stabilize);
    EXPECT_EQ(after(0.6f), Phase::flying);
    settle(with(2, 1500));
    EXPECT_EQ(after(0.6f), Phase::breaking);
}

}  // namespace

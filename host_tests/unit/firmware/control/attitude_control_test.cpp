// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/attitude_control.hpp"

#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::control::Loop;
using firmware::control::surfaces;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

class AttitudeControl : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        mutable_vehicle.imu.periods = 2;
        mutable_vehicle.estimate.equivalent_airspeed_mps = parameters.scaling_speed_mps;
        level();
    }
    void level(float roll_rad = 0, float pitch_rad = 0) {
        auto& attitude = mutable_vehicle.attitude;
        attitude.roll_rad = core::Angle(roll_rad);
        attitude.pitch_rad = core::Angle(pitch_rad);
        attitude.sin_roll = core::Ratio(std::sin(roll_rad));
        attitude.cos_roll = core::Ratio(std::cos(roll_rad));
        attitude.sin_pitch = core::Ratio(std::sin(pitch_rad));
        attitude.cos_pitch = core::Ratio(std::cos(pitch_rad));
    }
    void run() {
        firmware::modes::runMode();
        prepareControl();
        firmware::control::runAttitudeControl();
    }
    // Afresh, so that no integrator remembers the case before.
    firmware::control::Surfaces surfacesIn(Mode mode, const std::vector<uint16_t>& sticks) {
        settle(sticks);
        ++mutable_vehicle.mode_entries;
        firmware::modes::requestMode(mode, firmware::modes::ModeReason::ground);
        run();
        return surfaces;
    }
};

TEST_F(AttitudeControl, leaves_the_airplane_alone_in_manual) {
    level(0.5f, -0.3f);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(1, 1, 1);
    surfacesIn(Mode::manual, bench::kCentred);
    EXPECT_EQ(surfaces.aileron.toFloat(), 0);
    EXPECT_EQ(surfaces.elevator.toFloat(), 0);
    EXPECT_EQ(surfaces.rudder.toFloat(), 0);
}

// Against a wind that is not known yet the estimate is little more than the speed over the ground,
// and gains for it are three times those that the airplane bears.
TEST_F(AttitudeControl, takes_no_estimated_airspeed_below_the_cruise_speed_for_its_gains) {
    const auto aileronAt = [&](float airspeed_mps, bool measured) {
        SetUp();
        mutable_vehicle.airspeed.healthy = measured;
        mutable_vehicle.estimate.equivalent_airspeed_mps = airspeed_mps;
        mutable_vehicle.attitude.rate_rads = core::BodyRates::from(0.3f, 0, 0);
        return surfacesIn(Mode::fbwa, bench::kCentred).aileron.toFloat();
    };
    const float cruise_mps = core::hundredths(parameters.cruise_speed_cms);
    const float at_cruise = aileronAt(cruise_mps, false);
    EXPECT_LT(at_cruise, -0.01f);
    for (const float slower_mps : {cruise_mps - 3, parameters.speed_min_mps - 3.0f}) {
        EXPECT_NEAR(aileronAt(slower_mps, false), at_cruise, 0.001) << "but for an integrator";
        EXPECT_LT(aileronAt(slower_mps, true), 1.15f * at_cruise) << "what is measured is so";
    }
    EXPECT_GT(aileronAt(cruise_mps + 3, false), 0.9f * at_cruise);
}

TEST_F(AttitudeControl, uses_a_gain_from_when_it_is_set) {
    const char name[16] = "RLL2SRV_P";
    uint16_t index;
    ASSERT_TRUE(firmware::state::parameterFind(name, index));
    firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
    level(0.3f);
    surfacesIn(Mode::fbwa, bench::kCentred);
    const float before = surfaces.aileron.toFloat();
    float value;
    uint8_t type;
    char read[16];
    ASSERT_TRUE(firmware::state::parameterAt(index, read, value, type));
    ASSERT_EQ(firmware::state::parameterSetAt(index, value * 1.5f), core::Status::ok);
    run();
    EXPECT_LT(surfaces.aileron.toFloat(), before - 0.02f);
}

// A slope and a gust hold it in a bank that its surfaces cannot change on the wheels.
TEST_F(AttitudeControl, gathers_no_integral_while_the_ground_may_hold_it) {
    const auto gathered_cd = [&](float height_m, float climb_mps) {
        SetUp();
        mutable_vehicle.estimate.height_m = height_m;
        mutable_vehicle.estimate.climb_mps = climb_mps;
        level(0.3f, -0.2f);
        surfacesIn(Mode::fbwa, bench::kCentred);
        for (int frame = 0; frame < 100; ++frame) run();
        firmware::control::LoopFigures roll, pitch;
        firmware::control::loopFigures(Loop::roll, roll);
        firmware::control::loopFigures(Loop::pitch, pitch);
        return std::fabs(roll.integral_cd) + std::fabs(pitch.integral_cd);
    };
    for (const float height_m : {-9.0f, 0.0f, 9.0f}) EXPECT_EQ(gathered_cd(height_m, 0.4f), 0);
    for (const float height_m : {-11.0f, 11.0f}) EXPECT_GT(gathered_cd(height_m, 0), 50);
    for (const float climb_mps : {-0.6f, 0.6f}) EXPECT_GT(gathered_cd(0, climb_mps), 50);
}

TEST_F(AttitudeControl, the_terms_of_the_yaw_loop_are_the_rudder_and_damp_what_no_turn_asks_for) {
    parameters.rudder_mix = 0;
    firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
    level(0.5f, 0);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(0, 0, 0.9f);
    surfacesIn(Mode::fbwa, bench::kCentred);
    mutable_vehicle.imu.periods = 4;  // it is worked out once in so many
    run();
    const float rudder = surfaces.rudder.toFloat();
    firmware::control::LoopFigures yaw;
    firmware::control::loopFigures(Loop::yaw, yaw);
    EXPECT_NEAR(yaw.rate_cdps, core::centidegrees(0.9f), 5);
    EXPECT_GT(yaw.demand_cdps, 500) << "the rate of a turn with this bank";
    EXPECT_LT(yaw.demand_cdps, yaw.rate_cdps);
    EXPECT_LT(yaw.derivative_cd, -50);
    EXPECT_NEAR(yaw.proportional_cd + yaw.integral_cd + yaw.feed_forward_cd + yaw.derivative_cd,
                rudder * 4500, 5);
}

TEST_F(AttitudeControl, turns_back_to_level_and_damps) {
    firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
    level(0.3f, 0.2f);
    surfacesIn(Mode::fbwa, with(3, 1900));
    EXPECT_LT(surfaces.aileron.toFloat(), -0.05f);
    EXPECT_LT(surfaces.elevator.toFloat(), -0.05f);

    level();
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(0.5f, 0.5f, 0);
    surfacesIn(Mode::fbwa, with(3, 1900));
    EXPECT_LT(surfaces.aileron.toFloat(), 0);
    EXPECT_LT(surfaces.elevator.toFloat(), 0);
}

TEST_F(AttitudeControl, meets_a_gust_twice_as_fast_in_the_flare) {
    firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
    level(0, core::radians(-4));
    const float elsewhere = surfacesIn(Mode::fbwa, with(3, 1900)).elevator.toFloat();
    mutable_vehicle.progress.flaring = true;
    EXPECT_NEAR(surfacesIn(Mode::fbwa, with(3, 1900)).elevator.toFloat(), 2 * elsewhere, 0.01);
    EXPECT_GT(elsewhere, 0.02f);
}

TEST_F(AttitudeControl, needs_less_surface_the_faster_it_flies) {
    level(0.3f);
    mutable_vehicle.estimate.equivalent_airspeed_mps = 10;
    const float slow = surfacesIn(Mode::fbwa, bench::kCentred).aileron.toFloat();
    firmware::modes::requestMode(Mode::manual, firmware::modes::ModeReason::ground);
    mutable_vehicle.estimate.equivalent_airspeed_mps = 20;
    const float fast = surfacesIn(Mode::fbwa, bench::kCentred).aileron.toFloat();
    EXPECT_LT(slow, 1.5f * fast);
    EXPECT_LT(fast, 0);
}

TEST_F(AttitudeControl, demands_no_more_than_the_limits) {
    surfacesIn(Mode::fbwa, {1900, 1900, 1900, 1500, 1500, 1500, 1500, 1815});
    const firmware::control::Surfaces full_stick = surfaces;
    ASSERT_GT(full_stick.aileron.toFloat(), 0.1f);
    firmware::modes::requestMode(Mode::manual, firmware::modes::ModeReason::ground);
    mutable_vehicle.roll_demand_rad = core::Angle(3);
    mutable_vehicle.pitch_demand_rad = core::Angle(1);
    settle(bench::kCentred);
    mutable_vehicle.sticks = firmware::state::Sticks::nothing;
    ++mutable_vehicle.mode_entries;
    firmware::control::runAttitudeControl();
    EXPECT_NEAR(surfaces.aileron.toFloat(), full_stick.aileron.toFloat(), 1e-4);
    EXPECT_NEAR(surfaces.elevator.toFloat(), full_stick.elevator.toFloat(), 1e-4);
}

TEST_F(AttitudeControl, adds_the_sticks_to_what_stabilises) {
    const auto centred = surfacesIn(Mode::stabilize, bench::kCentred);
    const auto moved =
        surfacesIn(Mode::stabilize, {1900, 1100, 1100, 1500, 1500, 1500, 1500, 1815});
    EXPECT_NEAR(moved.aileron.toFloat() - centred.aileron.toFloat(), 1, 0.01);
    EXPECT_NEAR(moved.elevator.toFloat() - centred.elevator.toFloat(), -1, 0.01);
}

TEST_F(AttitudeControl, moves_the_rudder_with_the_yaw_stick_in_every_mode) {
    for (Mode mode : {Mode::manual, Mode::stabilize, Mode::fbwa}) {
        const float centred = surfacesIn(mode, bench::kCentred).rudder.toFloat();
        EXPECT_NEAR(surfacesIn(mode, with(4, 1900)).rudder.toFloat() - centred, 1, 0.01)
            << static_cast<int>(mode);
    }
}

TEST_F(AttitudeControl, mixes_aileron_into_the_rudder_when_it_stabilises) {
    level(0.3f);
    surfacesIn(Mode::fbwa, bench::kCentred);
    EXPECT_NEAR(surfaces.rudder.toFloat(), surfaces.aileron.toFloat() * parameters.rudder_mix,
                1e-4);
    ASSERT_LT(surfaces.rudder.toFloat(), -0.01f);
}

TEST_F(AttitudeControl, damps_a_swing_of_the_yaw_but_not_while_the_rudder_steers) {
    surfacesIn(Mode::fbwa, bench::kCentred);
    mutable_vehicle.attitude.rate_rads.z = core::BodyRate(1);
    for (int i = 0; i < 2; ++i) run();  // one of them for each pulse of the servos
    EXPECT_NEAR(surfaces.rudder.toFloat(), -parameters.yaw.damping, 0.01f);
    mutable_vehicle.progress.steering = true;
    run();
    EXPECT_EQ(surfaces.rudder.toFloat(), 0);
}

// The wheel would turn towards the wing that a gust has lifted.
TEST_F(AttitudeControl, mixes_no_aileron_into_the_rudder_that_steers_on_the_ground) {
    level(0.3f);
    mutable_vehicle.progress.steering = true;
    mutable_vehicle.estimate.climb_mps = -0.8f;
    EXPECT_LT(surfacesIn(Mode::fbwa, bench::kCentred).rudder.toFloat(), -0.01f) << "flares";
    mutable_vehicle.estimate.climb_mps = 0;
    EXPECT_EQ(surfacesIn(Mode::fbwa, bench::kCentred).rudder.toFloat(), 0);
    mutable_vehicle.estimate.equivalent_airspeed_mps = 5;
    EXPECT_EQ(surfacesIn(Mode::fbwa, bench::kCentred).rudder.toFloat(), 0);
    parameters.rudder_only = 1;  // there is nothing else to hold its wings level with
    ++firmware::state::parameter_changes.count;
    EXPECT_LT(surfacesIn(Mode::fbwa, bench::kCentred).rudder.toFloat(), -0.01f);
}

TEST_F(AttitudeControl, has_not_its_ailerons_at_their_stop_from_bank_to_bank) {
    parameters.roll = {{0.4f, 3.2f, 0, 0.12f, 3000}, 0};
    ++firmware::state::parameter_changes.count;
    for (const float airspeed_mps : {10.0f, 16.0f}) {
        mutable_vehicle.estimate.equivalent_airspeed_mps = airspeed_mps;
        level(-0.7f);
        prepareControl();  // after a change the limit is next
        // about as fast as all of the surface turns it
        mutable_vehicle.attitude.rate_rads.x = core::BodyRate(0.7f * airspeed_mps / 15);
        EXPECT_NEAR(surfacesIn(Mode::fbwa, bench::kCentred).aileron.toFloat(), 0.94f, 0.05f)
            << airspeed_mps;
    }
}

TEST_F(AttitudeControl, adds_the_demanded_rudder_but_not_in_manual) {
    mutable_vehicle.rudder_demand = core::Ratio(0.2f);
    EXPECT_NEAR(surfacesIn(Mode::fbwa, bench::kCentred).rudder.toFloat(), 0.2f, 0.01);
    EXPECT_EQ(surfacesIn(Mode::manual, bench::kCentred).rudder.toFloat(), 0);
}

TEST_F(AttitudeControl, rolls_by_the_rudder_where_there_are_no_ailerons) {
    parameters.rudder_mix = 0.3f;
    parameters.rudder_only = 1;
    firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
    level(0.4f, 0);
    surfacesIn(Mode::fbwa, bench::kCentred);
    ASSERT_LT(surfaces.aileron.toFloat(), -0.05f);
    EXPECT_NEAR(surfaces.rudder.toFloat(), surfaces.aileron.toFloat(), 0.02f);
}

TEST_F(AttitudeControl, lets_the_pilot_bend_an_automatic_mode_if_stick_mixing_is_on) {
    fly(Mode::loiter);
    const float unmoved = surfacesIn(Mode::loiter, bench::kCentred).aileron.toFloat();
    const float bent = surfacesIn(Mode::loiter, with(1, 1900)).aileron.toFloat();
    EXPECT_GT(bent, unmoved + 0.2f);

    parameters.stick_mixing = 0;
    EXPECT_EQ(surfacesIn(Mode::loiter, with(1, 1900)).aileron.toFloat(), unmoved);
}

TEST_F(AttitudeControl, does_not_mix_the_sticks_of_a_lost_radio) {
    fly(Mode::loiter);
    const float unmoved = surfacesIn(Mode::loiter, bench::kCentred).aileron.toFloat();
    settle(with(1, 1900));
    loseRadio(1500);
    ++mutable_vehicle.mode_entries;
    run();
    ASSERT_TRUE(vehicle.radio.lost);
    EXPECT_EQ(surfaces.aileron.toFloat(), unmoved);
}

TEST_F(AttitudeControl, the_bend_stays_within_the_bank_limit) {
    fly(Mode::loiter);
    mutable_vehicle.roll_demand_rad =
        core::Angle(core::radiansFromCentidegrees(parameters.roll_limit_cd));
    const float at_limit = surfacesIn(Mode::loiter, bench::kCentred).aileron.toFloat();
    EXPECT_EQ(surfacesIn(Mode::loiter, with(1, 1900)).aileron.toFloat(), at_limit);
}

}  // namespace

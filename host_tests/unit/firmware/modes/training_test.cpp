// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/support/fakes/vehicle.hpp"
#include "modes_bench.hpp"

namespace {

using namespace modes_bench;

using Training = ModesBench;

TEST_F(Training, leaves_the_surfaces_to_the_sticks_within_the_limits) {
    fly(Mode::training);
    attitude(0.5f, -0.2f);
    settle({1700, 1300, 1600, 1500, 1500, 1500, 1500, 1815});
    frame();
    EXPECT_NEAR(surfaces.aileron.toFloat(), 170 / kStick, 0.01);
    EXPECT_NEAR(surfaces.elevator.toFloat(), -170 / kStick, 0.01);
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), (1600 - 1130) / 770.0f, 0.01);
}

TEST_F(Training, lets_the_stick_bank_back_but_not_beyond_the_limit) {
    fly(Mode::training);
    attitude(core::radians(46), 0);
    settle(with(1, 1900));
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), 0.02f);
    settle(with(1, 1100));
    frame();
    EXPECT_NEAR(surfaces.aileron.toFloat(), -1, 0.01);
    attitude(core::radians(-46), 0);
    frame();
    EXPECT_GT(surfaces.aileron.toFloat(), -0.02f);
}

TEST_F(Training, begins_to_hold_before_a_fast_roll_is_at_the_limit) {
    fly(Mode::training);
    attitude(core::radians(35), 0);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(2.0f, 0, 0);
    settle(with(1, 1900));
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), 0.3f);
}

TEST_F(Training, goes_on_holding_while_the_bank_comes_back_to_the_limit) {
    fly(Mode::training);
    attitude(core::radians(50), 0);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(core::radians(-10), 0, 0);
    settle(with(1, 1900));
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), 0.2f);
}

TEST_F(Training, holds_the_pitch_within_its_limits_too) {
    fly(Mode::training);
    attitude(0, core::radians(21));
    settle(with(2, 1900));
    frame();
    EXPECT_LT(surfaces.elevator.toFloat(), 0.02f);
    attitude(0, core::radians(-26));
    settle(with(2, 1100));
    frame();
    EXPECT_GT(surfaces.elevator.toFloat(), -0.02f);
}

}  // namespace

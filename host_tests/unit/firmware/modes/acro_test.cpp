// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/support/fakes/vehicle.hpp"
#include "modes_bench.hpp"

namespace {

using namespace modes_bench;

using Acro = ModesBench;

TEST_F(Acro, turns_at_the_rate_the_stick_demands_beyond_every_limit) {
    fly(Mode::acro);
    attitude(2.0f, 0);
    settle(with(1, 1600));
    frame();
    const float from_rest = surfaces.aileron.toFloat();
    EXPECT_GT(from_rest, 0.1f);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(core::radians(34), 0, 0);
    frame();
    const float at_rate = surfaces.aileron.toFloat();
    EXPECT_LT(at_rate, from_rest);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(core::radians(90), 0, 0);
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), at_rate);
    parameters.acro_roll_rate_dps = 60;
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(0, 0, 0);
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), 0.6f * from_rest);
}

TEST_F(Acro, with_centred_sticks_only_stops_turning_unless_it_locks) {
    fly(Mode::acro);
    attitude(1.0f, 0.2f);
    frame();
    attitude(1.4f, 0.5f);
    frame();
    EXPECT_NEAR(surfaces.aileron.toFloat(), 0, 1e-3);
    EXPECT_NEAR(surfaces.elevator.toFloat(), 0, 1e-3);
}

TEST_F(Acro, locked_returns_to_the_attitude_it_was_let_go_in) {
    parameters.acro_locking = 1;
    fly(Mode::acro);
    attitude(1.0f, 0.2f);
    frame();
    attitude(1.4f, 0.2f);
    frame();
    EXPECT_LT(surfaces.aileron.toFloat(), -0.1f);
    attitude(0.6f, 0.5f);
    frame();
    EXPECT_GT(surfaces.aileron.toFloat(), 0.1f);
    EXPECT_LT(surfaces.elevator.toFloat(), 0);
}

TEST_F(Acro, locks_only_once_it_has_stopped_turning) {
    parameters.acro_locking = 1;
    fly(Mode::acro);
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(2.0f, 0, 0);
    attitude(0.2f, 0);
    frame();
    mutable_vehicle.attitude.rate_rads = core::BodyRates::from(0, 0, 0);
    attitude(0.6f, 0);
    frame();
    EXPECT_NEAR(surfaces.aileron.toFloat(), 0, 0.01);
}

TEST_F(Acro, pushes_to_raise_the_nose_when_it_is_locked_inverted) {
    parameters.acro_locking = 1;
    fly(Mode::acro);
    attitude(core::kPi, 0.1f);
    frame();
    attitude(core::kPi, -0.2f);
    frame();
    EXPECT_LT(surfaces.elevator.toFloat(), -0.02f);
}

}  // namespace

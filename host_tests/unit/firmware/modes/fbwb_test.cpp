// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/support/fakes/vehicle.hpp"
#include "modes_bench.hpp"

namespace {

using namespace modes_bench;

using Fbwb = ModesBench;

TEST_F(Fbwb, holds_the_height_at_which_it_was_entered) {
    fly(Mode::fbwb);
    mutable_vehicle.estimate.height_m = 83;
    guide(3);
    EXPECT_FLOAT_EQ(planned_m(), 80);
    EXPECT_TRUE(firmware::state::autoThrottle());
}

TEST_F(Fbwb, climbs_at_the_rate_of_the_stick_and_stays_where_it_is_let_go) {
    fly(Mode::fbwb);
    settle(with(2, 1900));
    guide(10);
    EXPECT_NEAR(planned_m(), 82, 0.21);
    settle(with(2, 1700));
    guide(10);
    EXPECT_NEAR(planned_m(), 82 + 2 * 170 / kStick, 0.3);
    mutable_vehicle.estimate.height_m = 82.5f;
    mutable_vehicle.estimate.climb_mps = 1;
    settle(bench::kCentred);
    guide(1);
    mutable_vehicle.estimate.climb_mps = 0;
    guide(10);
    EXPECT_NEAR(planned_m(), 83.3, 0.01) << "with 0.8 s to end the climb in";
}

TEST_F(Fbwb, climbs_with_the_stick_pushed_if_the_pilot_wants_that) {
    parameters.fbwb_elevator_reverse = 1;
    fly(Mode::fbwb);
    settle(with(2, 1100));
    guide(10);
    EXPECT_NEAR(planned_m(), 82, 0.21);
}

TEST_F(Fbwb, does_not_let_the_demand_run_away_from_an_airplane_that_cannot_climb) {
    fly(Mode::fbwb);
    settle(with(2, 1900));
    guide(300);
    EXPECT_LT(planned_m(), 90.2f);
}

TEST_F(Fbwb, does_not_sink_below_its_lowest_height) {
    parameters.fbwb_lowest_cm = 7500;
    fly(Mode::fbwb);
    settle(with(2, 1100));
    guide(100);
    EXPECT_FLOAT_EQ(planned_m(), 75);
    mutable_vehicle.estimate.height_m = 70;
    settle(bench::kCentred);
    guide(2);
    EXPECT_FLOAT_EQ(planned_m(), 75);
}

TEST_F(Fbwb, flies_the_speed_of_the_throttle_stick) {
    fly(Mode::fbwb);
    settle(with(3, 1100));
    guide();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, parameters.speed_min_mps);
    settle(with(3, 1900));
    guide();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, parameters.speed_max_mps);
    settle(with(3, 1515));
    guide();
    EXPECT_NEAR(vehicle.demand.airspeed_mps, 15.5, 0.1);
    mutable_vehicle.radio.lost = true;
    mutable_vehicle.radio.throttle_pct = 0;
    guide();
    EXPECT_NEAR(vehicle.demand.airspeed_mps, 15.5, 0.1) << "the last that was asked for";
}

TEST_F(Fbwb, banks_as_fbwa_does) {
    fly(Mode::fbwb);
    settle(with(1, 1900));
    guide();
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), core::radians(45), 1e-3);
}

TEST_F(Fbwb, is_left_for_circle_when_the_radio_is_lost) {
    for (const Mode mode : {Mode::training, Mode::acro, Mode::fbwb, Mode::cruise}) {
        settle(bench::kCentred);
        for (int i = 0; i < 3; ++i) firmware::safety::runFailsafe();
        fly(mode);
        loseRadio(1500);
        EXPECT_EQ(vehicle.mode, Mode::circle);
    }
    settle(bench::kCentred);
    for (int i = 0; i < 3; ++i) firmware::safety::runFailsafe();
    EXPECT_EQ(vehicle.mode, Mode::cruise) << "and entered again when it is back in time";
}

}  // namespace

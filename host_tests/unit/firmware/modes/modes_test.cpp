// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/support/fakes/vehicle.hpp"
#include "modes_bench.hpp"

namespace {

using namespace modes_bench;
using Modes = ModesBench;

TEST_F(Modes, circle_flies_at_cruise_speed_whatever_flew_before) {
    mutable_vehicle.demand.climb_rate_mps = 1;
    mutable_vehicle.demand.airspeed_mps = 0;
    fly(Mode::circle);
    guide(10);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, parameters.cruise_speed_cms * 0.01f);
    EXPECT_EQ(vehicle.demand.throttle_pct, parameters.cruise_throttle_pct);
    EXPECT_FLOAT_EQ(planned_m(), 80);
    EXPECT_NEAR(vehicle.roll_demand_rad.toFloat(), core::radians(15), 1e-3);
}

TEST_F(Modes, mix_the_sticks_into_the_demands_or_the_surfaces_as_the_pilot_wants) {
    fly(Mode::loiter);
    settle(with(1, 1900));
    const struct {
        int8_t mixing;
        Sticks sticks;
        float bent_deg;
    } all[] = {{0, Sticks::nothing, 0}, {2, Sticks::on_top, 0}, {1, Sticks::nothing, 45}};
    for (const auto& each : all) {
        parameters.stick_mixing = each.mixing;
        firmware::modes::runMode();
        EXPECT_EQ(vehicle.sticks, each.sticks) << int{each.mixing};
        EXPECT_NEAR(vehicle.pilot_roll_rad.toFloat(), core::radians(each.bent_deg), 1e-3);
    }
    parameters.stick_mixing = 2;
    loseRadio(1200);
    firmware::modes::runMode();
    EXPECT_EQ(vehicle.sticks, Sticks::nothing) << "not those of a lost radio";
}

TEST_F(Modes, a_raised_throttle_stick_adds_throttle_where_no_airspeed_is_measured) {
    mutable_vehicle.airspeed.healthy = false;
    const auto throttle = [&](Mode mode, uint16_t stick_us) {
        firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
        firmware::guidance::runGuidance();
        settle(with(3, stick_us));
        fly(mode);
        guide(20);
        return vehicle.throttle_demand.toFloat();
    };
    const float cruise = throttle(Mode::loiter, 1515);
    EXPECT_NEAR(throttle(Mode::loiter, 1100), cruise, 0.02) << "a closed one does not slow";
    EXPECT_GT(throttle(Mode::loiter, 1900), cruise + 0.1f);
    EXPECT_LT(throttle(Mode::fbwb, 1100), cruise - 0.05f) << "but where it is the speed's";
    parameters.throttle_nudge = 0;
    EXPECT_NEAR(throttle(Mode::loiter, 1900), cruise, 0.02);
}

TEST_F(Modes, the_stick_works_before_the_launch_only_if_the_pilot_wants_that) {
    mutable_vehicle.estimate.airspeed_mps = mutable_vehicle.estimate.equivalent_airspeed_mps = 0;
    course(0, 0);
    settle(with(3, 1515));
    fly(Mode::loiter);
    mutable_vehicle.estimate.height_m = 0;
    guide(3);
    ASSERT_TRUE(vehicle.progress.throttle_suppressed);
    EXPECT_EQ(vehicle.throttle_demand.toFloat(), 0);
    parameters.suppressed_manual = 1;
    guide(1);
    EXPECT_NEAR(vehicle.throttle_demand.toFloat(), 0.5, 0.01);
}

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/touchdown.hpp"

#include <gmock/gmock.h>

using namespace simulator;

TEST(Touchdown, is_measured_along_and_across_the_last_leg) {
    Plan plan;
    PlannedNav land{};
    land.command = mavlink::MavCmd::nav_land;
    land.place = Point{0, 100};
    land.from = Point{0, -200};
    plan.navs = {land};
    Sample before{}, there{};
    before.time_s = 9;
    there.time_s = 10;
    there.place = Point{-3, 112};
    const auto at = touchdownAt(9.5, {before, there}, plan);

    ASSERT_TRUE(at);
    EXPECT_NEAR(at->long_m, 12, 1e-9);
    EXPECT_NEAR(at->right_m, 3, 1e-9);
    EXPECT_FALSE(touchdownAt(11, {before, there}, plan));
    EXPECT_FALSE(touchdownAt(9.5, {before, there}, Plan()));
}

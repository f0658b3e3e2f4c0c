// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/plan.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace simulator;

static Plan planOf(const std::string& rows) {
    const auto items = parseWaypoints("QGC WPL 110\n0 1 0 16 0 0 0 0 47 8 500 1\n" + rows, "plan");
    return makePlan(items, LocalFrame(47, 8));
}

TEST(LocalFrame, agrees_with_the_ellipsoid) {
    // one minute of arc at 47 N: 1852.9 m along the meridian, 1268.2 m along the parallel
    const Point point = LocalFrame(47, 8).at(47 + 1.0 / 60, 8 + 1.0 / 60);

    EXPECT_NEAR(point.north_m, 1852.9, 1);
    EXPECT_NEAR(point.east_m, 1268.2, 1);
}

TEST(LocalFrame, goes_across_the_antimeridian) {
    EXPECT_NEAR(LocalFrame(0, 179.999).at(0, -179.999).east_m, 222.6, 0.5);
}

TEST(Along, is_positive_to_the_right_of_the_leg) {
    const Along on = along({0, 0}, {100, 0}, {30, 7});

    EXPECT_DOUBLE_EQ(on.along_m, 30);
    EXPECT_DOUBLE_EQ(on.across_m, 7);
}

TEST(Plan, has_a_leg_for_every_nav_and_none_for_the_rest) {
    const Plan plan = planOf(
        "1 0 3 22 15 0 0 0 0 0 40 1\n2 0 3 178 0 13 0 0 0 0 0 1\n"
        "3 0 3 16 0 0 0 0 47.01 8 60 1\n4 0 3 21 0 0 0 0 47 8 0 1\n");

    ASSERT_EQ(plan.navs.size(), 3u);
    EXPECT_EQ(plan.nav(2), nullptr);
    EXPECT_FALSE(plan.nav(3)->from);  // after a take-off: from where it is
    EXPECT_TRUE(plan.nav(3)->from_circle);
    EXPECT_EQ(plan.nav(3)->from_height_m, 40);
    ASSERT_TRUE(plan.nav(4)->from);
    EXPECT_FALSE(plan.nav(4)->from_circle);
}

TEST(Plan, demands_the_new_speed_from_the_next_nav_on) {
    const Plan plan = planOf(
        "1 0 3 16 0 0 0 0 47.01 8 60 1\n2 0 3 178 0 13.5 -1 0 0 0 0 1\n"
        "3 0 3 16 0 0 0 0 47.02 8 60 1\n4 0 3 16 0 0 0 0 47.03 8 60 1\n");

    EXPECT_FALSE(plan.nav(1)->airspeed_mps);
    EXPECT_EQ(plan.nav(3)->airspeed_mps, 13.5);
    EXPECT_EQ(plan.nav(4)->airspeed_mps, 13.5);
}

TEST(Plan, puts_absolute_altitudes_above_home) {
    EXPECT_EQ(planOf("1 0 0 16 0 0 0 0 47.01 8 560 1\n").nav(1)->height_m, 60);
}

TEST(Plan, slopes_a_leg_between_the_heights_of_its_ends) {
    const Plan plan = planOf("1 0 3 16 0 0 0 0 47 8 60 1\n2 0 3 16 0 0 0 0 47.01 8 100 1\n");
    const PlannedNav& leg = *plan.nav(2);
    const Point middle = {leg.place->north_m / 2, 12};

    EXPECT_NEAR(Plan::height_m(leg, *leg.from, middle), 80, 1e-6);
    EXPECT_NEAR(Plan::height_m(leg, *leg.from, {-50, 0}), 60, 1e-6);
}

TEST(Plan, knows_the_landing_point_only_of_a_mission_that_ends_with_a_landing) {
    EXPECT_TRUE(planOf("1 0 3 21 0 0 0 0 47 8 0 1\n").landing());
    EXPECT_FALSE(planOf("1 0 3 21 0 0 0 0 47 8 0 1\n2 0 3 16 0 0 0 0 47 8 0 1\n").landing());
}

TEST(NavsInTurn, repeat_what_a_jump_leads_back_to) {
    Waypoints items(6);
    for (size_t i = 0; i < items.size(); ++i) {
        items[i].index = static_cast<int>(i);
        items[i].command = 16;
    }
    EXPECT_EQ(navsInTurn(items), (std::vector<int>{1, 2, 3, 4, 5}));
    items[3].command = 177;
    items[3].params = {2, 2, 0, 0};
    EXPECT_EQ(navsInTurn(items), (std::vector<int>{1, 2, 2, 2, 4, 5}));
    items[3].params = {1, 1, 0, 0};
    EXPECT_EQ(navsInTurn(items), (std::vector<int>{1, 2, 1, 2, 4, 5}));
    items[3].params = {1, -1, 0, 0};
    EXPECT_EQ(navsInTurn(items), (std::vector<int>{1, 2, 4, 5}));
    items[3].params = {5, 1, 0, 0};
    EXPECT_EQ(navsInTurn(items), (std::vector<int>{1, 2, 5}));
    items[3].params = {5, -1, 0, 0};
    EXPECT_EQ(navsInTurn(items), (std::vector<int>{1, 2, 5}));
    items[3].params = {NAN, 1, 0, 0};
    EXPECT_EQ(navsInTurn(items), (std::vector<int>{1, 2, 4, 5}));
}

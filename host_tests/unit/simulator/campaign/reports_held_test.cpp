// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/reports_held.hpp"

#include <gtest/gtest.h>

#include <cmath>

using simulator::ReportsHeld;

TEST(ReportsHeld, lets_go_of_the_least_bad_when_there_is_no_room) {
    ReportsHeld held(2);
    EXPECT_EQ(held.add(3, "three"), "");
    EXPECT_EQ(held.add(1, "one"), "");
    EXPECT_EQ(held.add(2, "two"), "one");
    EXPECT_EQ(held.add(0.5, "half"), "half");
    EXPECT_EQ(held.add(INFINITY, "none"), "two");
}

TEST(ReportsHeld, holds_reports_that_are_as_bad_as_each_other) {
    ReportsHeld held(2);
    EXPECT_EQ(held.add(1, "a"), "");
    EXPECT_EQ(held.add(1, "b"), "");
    EXPECT_EQ(held.add(1, "c"), "a");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/landing_check.hpp"

#include <gtest/gtest.h>

using simulator::landingFault;

// Heavy airplanes roll 119 to 145 m from a touch-down beside the point.
TEST(LandingCheck, goes_by_the_touch_down_and_not_by_how_far_it_rolls) {
    for (const double rolled_m : {0.0, 119.0, 145.0, 249.0})
        EXPECT_EQ(landingFault(3, rolled_m), "") << rolled_m;
    EXPECT_EQ(landingFault(60, 60), "");
}

TEST(LandingCheck, says_what_was_too_far_away) {
    EXPECT_EQ(landingFault(97, 20), "it touched down 97 m from the landing point, more than 60 m");
    EXPECT_EQ(landingFault(9, 251), "it stands 251 m from the landing point, more than 250 m");
    EXPECT_EQ(landingFault(std::nullopt, 5), "it never touched down");
}

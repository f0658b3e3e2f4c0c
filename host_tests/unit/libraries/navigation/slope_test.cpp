// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/slope.hpp"

#include <gtest/gtest.h>

namespace {

using navigation::heightOnSlope;

TEST(Slope, runs_straight_from_one_height_to_the_other_and_is_level_beyond) {
    const struct {
        float along, height, climb;
    } cases[] = {{-10, 50, 0}, {0, 50, 0}, {100, 60, 1.2f}, {300, 80, 1.2f}, {500, 100, 0}};
    for (const auto& c : cases) {
        const auto demand = heightOnSlope(50, 100, 500, c.along, 12);
        EXPECT_FLOAT_EQ(demand.height_m, c.height) << c.along;
        EXPECT_FLOAT_EQ(demand.climb_mps, c.climb) << c.along;
    }
}

TEST(Slope, of_no_length_is_the_end_height) {
    EXPECT_FLOAT_EQ(heightOnSlope(50, 100, 0, 0.5f, 12).height_m, 100);
}

}  // namespace

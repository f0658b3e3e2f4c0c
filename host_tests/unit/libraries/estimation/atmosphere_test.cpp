// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/atmosphere.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

double standardPressure_pa(double height_m) {
    return 101325 * std::pow(1 - 0.0065 * height_m / 288.15, 5.25588);
}

TEST(Atmosphere, heights_agree_with_the_standard_atmosphere) {
    for (double height_m = -100; height_m <= 3000; height_m += 50) {
        EXPECT_NEAR(estimation::pressureHeight_m(static_cast<float>(standardPressure_pa(height_m)),
                                                 101325, 15),
                    height_m, 0.05 + 0.001 * std::abs(height_m));
    }
}

TEST(Atmosphere, nonsense_pressures_give_a_finite_height) {
    EXPECT_EQ(estimation::pressureHeight_m(0, 101325, 15), 0);
    EXPECT_EQ(estimation::pressureHeight_m(101325, 0, 15), 0);
    EXPECT_TRUE(std::isfinite(estimation::pressureHeight_m(1, 101325, 15)));
}

TEST(Atmosphere, true_airspeed_is_larger_where_the_air_is_thin) {
    EXPECT_NEAR(estimation::trueSpeedRatio(101325, 15), 1, 0.001);
    EXPECT_NEAR(estimation::trueSpeedRatio(static_cast<float>(standardPressure_pa(3000)), -4.5f),
                std::sqrt(1.225 / 0.9093), 0.002);
}

}  // namespace

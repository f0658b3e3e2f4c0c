// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/atan2_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

float found_rad(double sine, double cosine) {
    return estimation::tableAtan2(core::Ratio(static_cast<float>(sine)),
                                  core::Ratio(static_cast<float>(cosine)))
        .toFloat();
}

TEST(Arc, agrees_with_atan2_all_round) {
    for (double angle = -M_PI + 1e-4; angle < M_PI; angle += 0.0007) {
        const double found = found_rad(std::sin(angle), std::cos(angle));
        EXPECT_NEAR(std::remainder(found - angle, 2 * M_PI), 0, 2e-4);
    }
}

TEST(Arc, tolerates_a_sine_and_cosine_with_an_error_of_a_percent) {
    for (double angle = -3; angle < 3; angle += 0.1)
        for (double factor : {0.99, 1.01})
            EXPECT_NEAR(found_rad(factor * std::sin(angle), factor * std::cos(angle)), angle,
                        0.012);
}

}  // namespace

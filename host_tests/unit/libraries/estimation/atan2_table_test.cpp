// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/atan2_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

TEST(Arc, agrees_with_atan2_all_round) {
    for (double angle = -M_PI + 1e-4; angle < M_PI; angle += 0.0007) {
        EXPECT_NEAR(estimation::tableAtan2_rad(static_cast<float>(std::sin(angle)),
                                               static_cast<float>(std::cos(angle))),
                    angle, 1.5e-4);
    }
}

TEST(Arc, in_fixed_point_agrees_with_atan2_all_round) {
    for (double angle = -M_PI + 1e-4; angle < M_PI; angle += 0.0007) {
        const float found = estimation::tableAtan2(core::Ratio(static_cast<float>(std::sin(angle))),
                                                   core::Ratio(static_cast<float>(std::cos(angle))))
                                .toFloat();
        EXPECT_NEAR(std::remainder(found - angle, 2 * M_PI), 0, 2e-4);
    }
}

TEST(Arc, tolerates_a_sine_and_cosine_with_an_error_of_a_percent) {
    for (double angle = -3; angle < 3; angle += 0.1) {
        for (double factor : {0.99, 1.01}) {
            EXPECT_NEAR(estimation::tableAtan2_rad(static_cast<float>(factor * std::sin(angle)),
                                                   static_cast<float>(factor * std::cos(angle))),
                        angle, 0.012);
        }
    }
}

}  // namespace

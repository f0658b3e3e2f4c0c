// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fixed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using core::Angle;
using core::Fixed;

TEST(Fixed, products_are_exact_over_the_whole_range) {
    const int16_t ends[] = {INT16_MIN, INT16_MIN + 1, -1, 0, 1, INT16_MAX};
    for (int16_t a : ends)
        for (int16_t b : ends) EXPECT_EQ(core::product(a, b), int32_t{a} * b);
    std::mt19937 random(1);
    for (int i = 0; i < 100000; ++i) {
        const int32_t a = static_cast<int32_t>(random());
        const int16_t b = static_cast<int16_t>(random());
        const double exact = std::floor(std::ldexp(double(a) * b, -16));
        ASSERT_EQ(core::times16(a, b), exact) << a << " * " << b;
    }
}

TEST(Fixed, the_upper_half_of_64_bits_is_right_within_three_steps) {
    std::mt19937 random(2);
    for (int i = 0; i < 100000; ++i) {
        const int32_t a = static_cast<int32_t>(random()), b = static_cast<int32_t>(random());
        ASSERT_NEAR(core::timesUpper(a, b), std::ldexp(double(a) * b, -32), 3.0);
    }
}

TEST(Fixed, holds_a_number_within_a_step_and_stops_at_its_ends) {
    for (double value = -1.99; value < 1.99; value += 0.00037) {
        const float asked = static_cast<float>(value);
        ASSERT_NEAR(Fixed<14>(asked).toFloat(), value, 1.0 / 16384) << value;
    }
    for (float beyond : {2.0f, 1e6f, 1e30f, INFINITY}) {
        EXPECT_EQ(Fixed<14>(beyond).raw, INT16_MAX);
        EXPECT_EQ(Fixed<14>(-beyond).raw, INT16_MIN);
    }
    EXPECT_EQ(Fixed<10>::fromRaw(100000).raw, INT16_MAX);
    EXPECT_EQ(Fixed<10>::fromRaw(-100000).raw, INT16_MIN);
}

TEST(Fixed32, loses_what_is_cut_off_towards_the_lower_number) {
    using Fine = core::Fixed32<30>;
    EXPECT_FLOAT_EQ(Fine::fromRaw(Fine::kOne / 4).toFloat(), 0.25f);
    EXPECT_EQ(Fine::fromRaw((Fine::kOne >> 1) + 1).as<20>().raw, core::Fixed32<20>::kOne / 2);
    EXPECT_EQ(Fine::fromRaw(-1).as<20>().raw, -1);
}

TEST(Angle, wraps_as_a_circle_does) {
    for (double angle = -7; angle < 7; angle += 0.001) {
        const float read = Angle(static_cast<float>(angle)).toFloat();
        ASSERT_NEAR(std::remainder(read - angle, 2 * M_PI), 0, 1e-4) << angle;
    }
    EXPECT_NEAR(core::between(Angle(3.0f), Angle(-3.0f)).toFloat(), 2 * M_PI - 6, 2e-4);
    EXPECT_NEAR(core::between(Angle(-3.0f), Angle(3.0f)).toFloat(), 6 - 2 * M_PI, 2e-4);
}

}  // namespace

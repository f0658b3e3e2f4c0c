// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maths.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Limit, keeps_what_lies_between_and_stops_at_the_ends) {
    EXPECT_EQ(core::limit(0.5f, -1.0f, 2.0f), 0.5f);
    EXPECT_EQ(core::limit(-1.0f, -1.0f, 2.0f), -1.0f);
    EXPECT_EQ(core::limit(2.0f, -1.0f, 2.0f), 2.0f);
    EXPECT_EQ(core::limit(-1.5f, -1.0f, 2.0f), -1.0f);
    EXPECT_EQ(core::limit(2.5f, -1.0f, 2.0f), 2.0f);
    EXPECT_EQ(core::limit(-3.0f, -5.0f, -2.0f), -3.0f);
    EXPECT_EQ(core::limit(-6.0f, -5.0f, -2.0f), -5.0f);
    EXPECT_EQ(core::limit(5, -3, 3), 3);
    EXPECT_EQ(core::limit(-5, -3, 3), -3);
}

constexpr float kEdges[] = {
    0.0f,        -0.0f,  1.0f,    0.5f, -0.5f, -1.0f, 0.99999994f, 1.0000001f, -0.99999994f,
    -1.0000001f, 1e-40f, -1e-40f, 2.0f, -2.0f, 1e30f, -1e30f,      INFINITY,   -INFINITY};

// The compiler calls another function where it knows that a bound is 0 or follows from the other.
void expectTheSame(float value) {
    const volatile float zero = 0, one = 1, minus_one = -1;  // not known to the compiler
    const volatile float highest = 0.75f;
    EXPECT_EQ(core::bitsOf(core::limit(value, 0.0f, 1.0f)),
              core::bitsOf(core::limit(value, float(zero), float(one))));
    EXPECT_EQ(core::bitsOf(core::limit(value, 0.0f, float(highest))),
              core::bitsOf(core::limit(value, float(zero), float(highest))));
    EXPECT_EQ(core::bitsOf(core::limit(value, 0.0f, float(minus_one))),
              core::bitsOf(core::limit(value, float(zero), float(minus_one))));
    EXPECT_EQ(core::bitsOf(core::limit(value, -1.0f, 1.0f)),
              core::bitsOf(core::limit(value, float(minus_one), float(one))));
}

TEST(Limit, by_known_bounds_is_what_it_is_by_any_two) {
    for (const float value : kEdges) expectTheSame(value);
    expectTheSame(copysignf(NAN, 1));
    expectTheSame(copysignf(NAN, -1));
}

TEST(Limit, takes_no_number_for_infinity_with_its_sign) {
    EXPECT_EQ(core::limit(float(INFINITY), -1.0f, 2.0f), 2.0f);
    EXPECT_EQ(core::limit(-float(INFINITY), -1.0f, 2.0f), -1.0f);
    EXPECT_EQ(core::limit(float(copysignf(NAN, 1)), -1.0f, 2.0f), 2.0f);
    EXPECT_EQ(core::limit(float(copysignf(NAN, -1)), -1.0f, 2.0f), -1.0f);
}

TEST(Maths, inverse_half_and_hundredths) {
    EXPECT_EQ(core::inverse(4), 0.25f);
    EXPECT_EQ(core::half(-3), -1.5f);
    EXPECT_EQ(core::inHundredths(1.236f), 124);
    EXPECT_EQ(core::inHundredths(-1.236f), -124);
}

TEST(Sign, is_that_of_every_number_and_of_neither_nought) {
    for (const float value : {1e-38f, 1e-6f, 1.0f, 3e38f}) {
        EXPECT_TRUE(core::isPositive(value)) << value;
        EXPECT_FALSE(core::isPositive(-value)) << value;
        EXPECT_TRUE(core::isNegative(-value)) << value;
        EXPECT_FALSE(core::isNegative(value)) << value;
        EXPECT_FALSE(core::isZero(value) || core::isZero(-value)) << value;
    }
    for (const float nought : {0.0f, -0.0f}) {
        EXPECT_TRUE(core::isZero(nought));
        EXPECT_FALSE(core::isPositive(nought) || core::isNegative(nought));
    }
}

TEST(Lerp, goes_from_one_value_to_the_other) {
    EXPECT_FLOAT_EQ(core::lerp(2, 6, 0), 2);
    EXPECT_FLOAT_EQ(core::lerp(2, 6, 0.25f), 3);
    EXPECT_FLOAT_EQ(core::lerp(2, 6, 1), 6);
}

}  // namespace

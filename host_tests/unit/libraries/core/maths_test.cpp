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

TEST(Limit, of_a_share_is_what_it_is_of_any_two) {
    const volatile float zero = 0, one = 1;  // not known to the compiler
    for (const float value : {0.0f, -0.0f, 1.0f, 0.5f, -0.5f, 0.99999994f, 1.0000001f, 1e-40f,
                              -1e-40f, 2.0f, 1e30f, -1e30f, float(INFINITY), -float(INFINITY),
                              float(copysignf(NAN, 1)), float(copysignf(NAN, -1))})
        EXPECT_EQ(core::bitsOf(core::limit(value, 0.0f, 1.0f)),
                  core::bitsOf(core::limit(value, float(zero), float(one))));
}

TEST(Limit, takes_no_number_for_infinity_with_its_sign) {
    EXPECT_EQ(core::limit(float(INFINITY), -1.0f, 2.0f), 2.0f);
    EXPECT_EQ(core::limit(-float(INFINITY), -1.0f, 2.0f), -1.0f);
    EXPECT_EQ(core::limit(float(copysignf(NAN, 1)), -1.0f, 2.0f), 2.0f);
    EXPECT_EQ(core::limit(float(copysignf(NAN, -1)), -1.0f, 2.0f), -1.0f);
}

}  // namespace

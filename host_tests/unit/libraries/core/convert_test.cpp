// SPDX-License-Identifier: GPL-3.0-or-later
// On the chip these are by hand: what they give is what a cast and a product give, bit for bit.
#include "core/convert.hpp"

#include <gtest/gtest.h>

namespace {

const int16_t kValues[] = {0,   1,    -1,    2,     3,     -3,    7,     100,    -100,   255,
                           256, -257, 12345, 18000, -9999, 32766, 32767, -32767, -32768, 4096};

TEST(Convert, whole_numbers_of_16_bits_are_exact) {
    for (const int16_t value : kValues)
        EXPECT_EQ(core::bitsOf(core::real(value)), core::bitsOf(static_cast<float>(value)));
}

TEST(Convert, hundredths_are_the_product_with_their_factor) {
    for (const int16_t value : kValues) {
        const float expected = static_cast<float>(value) * 0.01f;
        EXPECT_EQ(core::bitsOf(core::hundredths(value)), core::bitsOf(expected));
        EXPECT_EQ(core::bitsOf(core::hundredths(int32_t{value})), core::bitsOf(expected));
    }
    for (const int32_t value : {100000, -123456, 8388607, -2000000000})
        EXPECT_EQ(core::bitsOf(core::hundredths(value)),
                  core::bitsOf(static_cast<float>(value) * 0.01f));
}

TEST(Convert, thousandths_and_centidegrees_are_products_too) {
    for (const int16_t value : kValues) {
        const float number = static_cast<float>(value);
        EXPECT_EQ(core::bitsOf(core::thousandths(value)), core::bitsOf(number * 0.001f));
        EXPECT_EQ(core::bitsOf(core::thousandths(int32_t{value})), core::bitsOf(number * 0.001f));
        EXPECT_EQ(core::bitsOf(core::fromCentidegrees(value)),
                  core::bitsOf(number * (3.14159265f / 18000.0f)));
    }
}

TEST(Convert, thirty_bits_behind_the_point_are_taken_off) {
    for (const int32_t raw : {0, 1, -1, 1 << 30, -(1 << 30), 123456789, INT32_MAX, INT32_MIN})
        EXPECT_EQ(core::bitsOf(core::fromFixed30(raw)),
                  core::bitsOf(static_cast<float>(raw) * (1.0f / (1L << 30))));
}

TEST(Convert, an_angle_is_its_share_of_half_a_turn) {
    for (const int16_t raw : kValues)
        EXPECT_EQ(core::bitsOf(core::fromAngle(raw)),
                  core::bitsOf(static_cast<float>(raw) * (1.0f / (32768.0f / 3.14159265f))));
}

}  // namespace

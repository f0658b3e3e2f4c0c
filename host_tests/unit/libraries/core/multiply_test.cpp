// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multiply.hpp"

#include <gtest/gtest.h>

namespace {

const int16_t kValues[] = {0,     1,      -1,    2,      3,      -5,    100,
                           -255,  256,    -257,  4096,   -4096,  16384, -8192,
                           12345, -23456, 32767, -32767, -16384, 8191,  511};

// The upper half, rounded, of a product that was shifted; past 16 bits it wraps.
int16_t rounded(int32_t product, uint8_t shift) {
    return static_cast<int16_t>((product + (1L << (15 - shift))) >> (16 - shift));
}

TEST(Products, of_14_and_12_bits_behind_the_point_are_rounded) {
    for (const int16_t a : kValues)
        for (const int16_t b : kValues) {
            const int32_t product = int32_t{a} * b;
            const int32_t size = product < 0 ? -product : product;
            if (size < 1L << 29) {
                EXPECT_EQ(core::times14(a, b), rounded(product, 2));
            }
            if (size < 1L << 26) {
                EXPECT_EQ(core::times12(a, b), rounded(product, 4));
            }
        }
}

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
// Every check once with what must fail it: run_on_chip.test.mjs expects each to be printed.
#include <gtest/gtest.h>

#include "core/rom.hpp"

namespace {

const uint8_t kFive = 5;
enum class Colour : uint8_t { red, green };

TEST(Failing, every_failed_expectation_is_printed_and_the_test_goes_on) {
    EXPECT_EQ(kFive, 6);
    EXPECT_NE(kFive, 5);
    EXPECT_LT(kFive, 5);
    EXPECT_LE(kFive, 4);
    EXPECT_GT(kFive, 5);
    EXPECT_GE(kFive, 6);
    EXPECT_TRUE(kFive == 6);
    EXPECT_FALSE(kFive == 5);
    EXPECT_NEAR(1.0f, 1.5f, 0.4f);
    EXPECT_FLOAT_EQ(1.0f, 1.000001f);
    EXPECT_EQ(Colour::red, Colour::green);
    EXPECT_EQ(std::string("one"), "two") << "in words: " << 7;
    ADD_FAILURE() << "the last line is reached";
}

TEST(Failing, an_assertion_ends_its_test) {
    ASSERT_EQ(kFive, 6);
    ADD_FAILURE() << "never reached";
}

// What int of 16 bits would make equal is not: 65535 is no -1.
TEST(Failing, numbers_are_compared_as_numbers) {
    EXPECT_EQ(uint16_t{65535}, -1);
    EXPECT_LT(uint32_t{4000000000}, -1);
}

TEST(Failing, not_a_number_is_near_nothing) { EXPECT_NEAR(__builtin_nanf(""), 0, 1); }

// Read through the flash's bus although it lies in RAM: right on the host, noise here.
const uint32_t kForgotten[] = {1, 2, 3, 4};
TEST(Failing, a_table_that_was_not_marked_as_flash) {
    volatile uint8_t two = 2;
    EXPECT_EQ(core::romRead(kForgotten[two]), 3u);
}

TEST(Passing, among_failures_is_still_a_pass) { EXPECT_EQ(kFive, 5); }

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/line_fault.hpp"

#include <gtest/gtest.h>

using namespace simulator;

TEST(LineFault, leaves_a_sound_line_alone) {
    LineFault line(1);
    for (int i = 0; i < 256; ++i)
        EXPECT_EQ(line.through(static_cast<uint8_t>(i)), static_cast<uint8_t>(i));
    EXPECT_FALSE(line.stuck());
}

TEST(LineFault, of_a_line_that_stays_where_it_is_reads_zeros_or_ones) {
    LineFault line(1);
    line.fail(FaultKind::miso_low);
    EXPECT_EQ(line.through(0x5A), 0);
    line.fail(FaultKind::miso_high);
    EXPECT_EQ(line.through(0x5A), 0xFF);
    line.fail(FaultKind::scl_low);
    EXPECT_TRUE(line.stuck());
}

TEST(LineFault, turns_over_one_bit_of_one_byte_in_ten) {
    LineFault line(1);
    line.fail(FaultKind::noisy);
    int hit = 0;
    for (int i = 0; i < 10'000; ++i) {
        const int wrong = line.through(0x5A) ^ 0x5A;
        EXPECT_EQ(wrong & (wrong - 1), 0);
        hit += wrong != 0;
    }
    EXPECT_NEAR(hit, 1000, 120);
}

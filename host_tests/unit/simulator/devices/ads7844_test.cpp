// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ads7844.hpp"

#include <gtest/gtest.h>

using simulator::Ads7844;

namespace {

constexpr uint8_t kFirst = 0x87;  // channel 0, single-ended, always powered

struct Converter : testing::Test {
    Converter() {
        chip.volts = [](int) { return (2000.6 / 4096) * Ads7844::kReference_v; };
        chip.select(true);
    }
    // The first bits of the answer come at once, the others after the rest.
    int read(uint64_t rest_us) {
        chip.transfer(kFirst, now_us);
        int bits = chip.transfer(0, now_us) << 8;
        now_us += rest_us;
        bits |= chip.transfer(0, now_us);
        now_us += 100;
        return bits >> 3;
    }

    Ads7844 chip;
    uint64_t now_us = 5000;
};

TEST_F(Converter, answers_what_it_has_sampled) { EXPECT_EQ(read(0), 2000); }

TEST_F(Converter, whose_clock_rests_for_the_time_of_the_data_sheet_is_a_step_low_at_most) {
    EXPECT_EQ(read(900), 2000);
    EXPECT_EQ(read(1600), 1999);
    EXPECT_EQ(chip.longestConversion_us(), 1600u);
}

TEST_F(Converter, that_is_left_half_read_loses_the_bits_that_were_not_decided) {
    EXPECT_LT(read(20'000), 1995);
    EXPECT_GE(read(1'000'000), 1984) << "the upper bits were decided before";
    EXPECT_EQ(read(0), 2000) << "the next one is sampled anew";
}

}  // namespace

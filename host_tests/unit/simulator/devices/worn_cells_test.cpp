// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/worn_cells.hpp"

#include <gtest/gtest.h>

using namespace simulator;

TEST(WornCells, hold_the_bits_that_are_stuck) {
    WornCells worn;
    worn.stick(7, 0x01, true);
    worn.stick(7, 0x80, false);
    EXPECT_EQ(worn.written(7, 0xF0), 0x71);
    EXPECT_EQ(worn.written(8, 0xF0), 0xF0);
}

TEST(WornCells, are_as_many_as_were_asked_for_and_the_same_for_a_seed) {
    const auto wrong = [](uint64_t seed) {
        const WornCells worn(40, 4096, seed);
        std::vector<int> cells;
        for (uint16_t at = 0; at < 4096; ++at)
            if (worn.written(at, 0) != 0 || worn.written(at, 0xFF) != 0xFF) cells.push_back(at);
        return cells;
    };
    EXPECT_EQ(wrong(1).size(), 40u);
    EXPECT_EQ(wrong(1), wrong(1));
    EXPECT_NE(wrong(1), wrong(2));
}

TEST(Rot, turns_over_single_bits) {
    std::vector<uint8_t> memory(4096, 0x55);
    rot(memory, 1, 3);
    int bits = 0;
    for (const uint8_t byte : memory) bits += __builtin_popcount(byte ^ 0x55);
    EXPECT_EQ(bits, 1);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/native/eeprom_chip.hpp"

#include <gtest/gtest.h>

#include "hal/eeprom.hpp"

using core::Status;
using simulator::EepromChip;

namespace {

class EepromChipTest : public testing::Test {
protected:
    void pass(uint64_t us) {
        now_us += us;
        chip.run();
    }
    Status write(uint16_t address, std::vector<uint8_t> bytes) {
        return chip.write(address, bytes.data(), static_cast<uint8_t>(bytes.size()));
    }

    uint64_t now_us = 1000;
    EepromChip chip{now_us};
    uint8_t byte = 0;
};

}  // namespace

TEST_F(EepromChipTest, writes_a_byte_in_3400_us) {
    ASSERT_EQ(write(7, {1, 2}), Status::ok);
    pass(3399);
    EXPECT_EQ(chip.cells()[7], 0xFF);
    pass(1);
    EXPECT_EQ(chip.cells()[7], 1);
    EXPECT_FALSE(chip.drained());
    pass(3400);
    EXPECT_TRUE(chip.drained());
}

TEST_F(EepromChipTest, rests_for_a_reader_that_was_answered_busy) {
    ASSERT_EQ(write(7, {1, 2}), Status::ok);
    EXPECT_EQ(chip.read(8, &byte, 1), Status::busy);
    pass(3400);
    pass(9000);

    EXPECT_EQ(chip.read(8, &byte, 1), Status::ok);
    EXPECT_EQ(byte, 2);  // still in the queue, and seen as if written
    EXPECT_EQ(chip.cells()[8], 0xFF);
    pass(3400);
    EXPECT_EQ(chip.cells()[8], 2);
}

TEST_F(EepromChipTest, serves_a_reader_that_comes_ten_times_a_second) {
    ASSERT_EQ(write(7, {1, 2, 3, 4, 5, 6, 7, 8}), Status::ok);
    int busy = 0;
    for (int i = 0; i < 10; ++i) {
        if (chip.read(100, &byte, 1) == Status::busy) ++busy;
        for (int ms = 0; ms < 100; ++ms) pass(1000);
    }
    EXPECT_LE(busy, 1);
    EXPECT_TRUE(chip.drained());
}

// What is read elsewhere meanwhile must not end the rest that the first of them waits for.
TEST_F(EepromChipTest, serves_a_reader_of_two_places) {
    ASSERT_EQ(write(7, {1, 2, 3, 4, 5, 6, 7, 8}), Status::ok);
    int served = 0;
    for (int i = 0; i < 10; ++i) {
        const bool first = chip.read(100, &byte, 1) == Status::ok;
        const bool second = chip.read(200, &byte, 1) == Status::ok;
        served += first && second;
        for (int ms = 0; ms < 100; ++ms) pass(1000);
    }
    EXPECT_GE(served, 8);
    EXPECT_TRUE(chip.drained());
}

TEST_F(EepromChipTest, rests_for_the_reader_it_refused_and_for_no_other) {
    ASSERT_EQ(write(7, {1, 2}), Status::ok);
    EXPECT_EQ(chip.read(100, &byte, 1), Status::busy);
    pass(3400);
    EXPECT_EQ(chip.read(200, &byte, 1), Status::ok);
    pass(3400);
    EXPECT_EQ(chip.cells()[8], 0xFF) << "that reader has not been back";
    EXPECT_EQ(chip.read(100, &byte, 1), Status::ok);
    pass(3400);
    EXPECT_EQ(chip.cells()[8], 2);
}

TEST_F(EepromChipTest, goes_on_when_the_reader_stays_away) {
    ASSERT_EQ(write(7, {1, 2}), Status::ok);
    EXPECT_EQ(chip.read(8, &byte, 1), Status::busy);
    pass(3400);
    now_us = chip.due_us();
    chip.run();
    pass(3400);

    EXPECT_TRUE(chip.drained());
}

TEST_F(EepromChipTest, does_not_write_what_is_there_already) {
    EXPECT_EQ(write(0, {0xFF, 0xFF}), Status::ok);
    EXPECT_TRUE(chip.drained());
}

TEST_F(EepromChipTest, queues_all_bytes_of_a_call_or_none) {
    ASSERT_EQ(write(0, std::vector<uint8_t>(30, 1)), Status::ok);
    EXPECT_EQ(write(100, {1, 2, 3}), Status::busy);
    EXPECT_EQ(write(100, {1, 2}), Status::ok);
    EXPECT_EQ(write(200, std::vector<uint8_t>(33, 1)), Status::bad_argument);
    EXPECT_EQ(write(4095, {1, 2}), Status::bad_argument);
}

TEST_F(EepromChipTest, writes_noise_while_the_supply_is_low_and_once_more_until_it_reads_back) {
    ASSERT_EQ(write(7, {1, 2}), Status::ok);
    pass(1000);
    chip.endanger(true);
    pass(2400);
    EXPECT_NE(chip.cells()[7], 1);
    chip.endanger(false);
    pass(3400);
    EXPECT_NE(chip.cells()[7], 1) << "begun while it was";
    EXPECT_EQ(chip.cells()[8], 0xFF);
    pass(29'400);
    pass(3400);
    EXPECT_EQ(chip.cells()[7], 1);
    pass(3400);
    EXPECT_EQ(chip.cells()[8], 2);
    EXPECT_TRUE(chip.drained());
}

TEST_F(EepromChipTest, has_worn_cells) {
    simulator::WornCells worn;
    worn.stick(7, 0x01, true);
    chip.wear(worn);
    ASSERT_EQ(write(7, {2, 4}), Status::ok);
    pass(3400);
    for (int i = 1; i < hal::kEepromWrites; ++i) {
        EXPECT_EQ(chip.cells()[8], 0xFF);
        pass(3400);
        pass(29'400);
    }
    pass(3400);
    EXPECT_EQ(chip.cells()[7], 3);
    EXPECT_EQ(chip.cells()[8], 4);
    EXPECT_EQ(chip.read(7, &byte, 1), Status::ok);
    EXPECT_EQ(byte, 3);
}

TEST_F(EepromChipTest, is_read_between_the_writes_of_a_worn_cell) {
    simulator::WornCells worn;
    worn.stick(7, 0x01, true);
    chip.wear(worn);
    ASSERT_EQ(write(7, {2}), Status::ok);
    int served = 0;
    for (int i = 0; i < 70; ++i) {
        pass(10'000);
        served += chip.read(100, &byte, 1) == Status::ok;
    }
    EXPECT_GT(served, 50);
    EXPECT_FALSE(chip.drained());
}

TEST_F(EepromChipTest, a_restart_ends_the_byte_in_flight_and_loses_those_that_wait) {
    ASSERT_EQ(write(7, {1, 2}), Status::ok);
    pass(1000);
    chip.restart();
    EXPECT_TRUE(chip.drained());
    pass(10'000);
    EXPECT_EQ(chip.cells()[7], 1);
    EXPECT_EQ(chip.cells()[8], 0xFF);
}

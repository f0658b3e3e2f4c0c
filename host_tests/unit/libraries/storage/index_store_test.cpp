// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/index_store.hpp"

#include <gtest/gtest.h>

#include "core/crc.hpp"
#include "fakes/fakes.hpp"
#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"

namespace {

using core::Status;
using storage::IndexStore;

class IndexStoreTest : public testing::Test {
protected:
    void SetUp() override { fakes::reset(); }
};

uint8_t opened(uint8_t generation) {
    IndexStore store;
    uint8_t index = 99;
    bool damaged;
    EXPECT_EQ(store.open(generation, index, damaged), Status::ok);
    return index;
}

// As at a start that reports what is damaged, and writes again what is left.
struct Start {
    uint8_t index = 99;
    bool reported = false;
};
Start started(uint8_t generation) {
    IndexStore store;
    Start start;
    EXPECT_EQ(store.open(generation, start.index, start.reported), Status::ok);
    if (start.reported) {
        EXPECT_EQ(store.write(generation, start.index), Status::ok);
    }
    return start;
}

// As the first boards wrote them: without a check, numbers from 0 to 251.
void writeOld(uint8_t number, uint8_t generation, uint8_t index) {
    const uint8_t entry[] = {index, generation, number};
    const uint16_t at = static_cast<uint16_t>(storage::kIndex.begin + number % 21 * 3);
    ASSERT_EQ(hal::eepromWrite(at, entry, sizeof entry), Status::ok);
}

TEST_F(IndexStoreTest, a_blank_eeprom_gives_index_0) { EXPECT_EQ(opened(7), 0); }

TEST_F(IndexStoreTest, the_last_index_written_is_found_however_often_it_went_round) {
    IndexStore store;
    uint8_t index;
    bool damaged;
    ASSERT_EQ(store.open(7, index, damaged), Status::ok);
    for (int i = 1; i < 1000; ++i) {
        ASSERT_EQ(store.write(7, static_cast<uint8_t>(i)), Status::ok);
        ASSERT_EQ(opened(7), static_cast<uint8_t>(i)) << i;
    }
}

TEST_F(IndexStoreTest, an_index_of_another_mission_does_not_count) {
    IndexStore store;
    uint8_t index;
    bool damaged;
    ASSERT_EQ(store.open(7, index, damaged), Status::ok);
    ASSERT_EQ(store.write(7, 12), Status::ok);
    EXPECT_EQ(opened(8), 0);
    EXPECT_EQ(opened(7), 12);
}

TEST_F(IndexStoreTest, a_power_cut_at_any_byte_leaves_the_old_or_the_new_index) {
    uint8_t old_index = 1, index;
    bool damaged;
    {
        IndexStore store;
        ASSERT_EQ(store.open(7, index, damaged), Status::ok);
        ASSERT_EQ(store.write(7, old_index), Status::ok);
    }
    for (int round = 2; round < 600; ++round) {
        const uint8_t new_index = static_cast<uint8_t>(round);
        const auto before = fakes::eepromCells();
        for (uint32_t cut = 0; cut < 3; ++cut) {
            fakes::setEepromCells(before);
            IndexStore store;
            ASSERT_EQ(store.open(7, index, damaged), Status::ok);
            fakes::cutPowerAfter(cut);
            ASSERT_EQ(store.write(7, new_index), Status::ok);
            fakes::restartEeprom();
            const uint8_t found = opened(7);
            ASSERT_TRUE(found == old_index || found == new_index) << round << " " << cut;
            // a cut entry must not stand in the way of the next
            IndexStore next;
            ASSERT_EQ(next.open(7, index, damaged), Status::ok);
            ASSERT_EQ(next.write(7, 200), Status::ok);
            ASSERT_EQ(opened(7), 200);
        }
        fakes::setEepromCells(before);
        IndexStore store;
        ASSERT_EQ(store.open(7, index, damaged), Status::ok);
        ASSERT_EQ(store.write(7, new_index), Status::ok);
        old_index = new_index;
    }
}

// The newest in each place and round, with each check.
// 1 to 170, in no order.
uint8_t someIndex(int n) { return static_cast<uint8_t>(1 + n * 37 % 170); }

// As a run that starts does, of mission 7.
void writeAfterStart(uint8_t newest) {
    IndexStore store;
    uint8_t index;
    bool damaged;
    ASSERT_EQ(store.open(7, index, damaged), Status::ok);
    ASSERT_EQ(store.write(7, newest), Status::ok);
}

TEST_F(IndexStoreTest, any_changed_bit_leaves_the_index_or_is_reported_once) {
    IndexStore store;
    uint8_t index;
    bool damaged;
    ASSERT_EQ(store.open(7, index, damaged), Status::ok);
    int flips = 0, reported = 0;
    for (uint8_t n = 0; n < 90; ++n) {
        const uint8_t newest = someIndex(n);
        ASSERT_EQ(store.write(7, newest), Status::ok);
        const auto cells = fakes::eepromCells();
        ASSERT_FALSE(started(7).reported) << "whole after write " << +n;
        for (uint16_t at = storage::kIndex.begin; at < storage::kIndex.end(); ++at)
            for (int bit = 0; bit < 8; ++bit) {
                fakes::setEepromCells(cells);
                fakes::setEepromCell(at, static_cast<uint8_t>(cells[at] ^ 1 << bit));
                const Start start = started(7);
                ASSERT_TRUE(start.index == newest || start.reported) << at << ", " << bit;
                const Start next = started(7);
                ASSERT_EQ(next.index, start.index);
                ASSERT_FALSE(next.reported) << at << ", " << bit;
                ++flips;
                reported += start.reported;
            }
        fakes::setEepromCells(cells);
    }
    printf("%d changed bits, %d of them reported, none silent\n", flips, reported);
}

// Two rounds and a half over a cell that holds its bit.
TEST_F(IndexStoreTest, a_worn_cell_leaves_the_index_or_is_reported) {
    int reported = 0;
    for (uint16_t at = storage::kIndex.begin; at < storage::kIndex.end(); ++at)
        for (int bit = 0; bit < 16; ++bit) {
            fakes::resetEeprom();
            fakes::wearEepromCell(at, static_cast<uint8_t>(1 << bit % 8), bit > 7);
            for (uint8_t n = 0; n < 53; ++n) {
                const uint8_t newest = someIndex(n);
                writeAfterStart(newest);
                const Start start = started(7);
                ASSERT_TRUE(start.index == newest || start.reported)
                    << at << ", " << bit << ", " << +n;
                reported += start.reported;
            }
        }
    EXPECT_GT(reported, 0);
}

TEST_F(IndexStoreTest, the_index_of_the_first_boards_is_read_and_followed_by_those_with_a_check) {
    for (int last = 0; last < 252; ++last) {
        fakes::resetEeprom();
        for (int number = last < 30 ? 0 : last - 30; number <= last; ++number)
            writeOld(static_cast<uint8_t>(number), 7, static_cast<uint8_t>(number % 171));
        const Start start = started(7);
        ASSERT_EQ(start.index, last % 171);
        ASSERT_FALSE(start.reported) << last;
        for (int n = 0; n < 50; ++n) {
            const uint8_t newest = someIndex(n);
            writeAfterStart(newest);
            const Start next = started(7);
            ASSERT_EQ(next.index, newest) << last << ", " << n;
            ASSERT_FALSE(next.reported) << last << ", " << n;
        }
    }
}

}  // namespace

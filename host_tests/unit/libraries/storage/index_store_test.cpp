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
    EXPECT_EQ(store.open(generation, index), Status::ok);
    return index;
}

TEST_F(IndexStoreTest, a_blank_eeprom_gives_index_0) { EXPECT_EQ(opened(7), 0); }

TEST_F(IndexStoreTest, the_last_index_written_is_found_however_often_it_went_round) {
    IndexStore store;
    uint8_t index;
    ASSERT_EQ(store.open(7, index), Status::ok);
    for (int i = 1; i < 1000; ++i) {
        ASSERT_EQ(store.write(7, static_cast<uint8_t>(i)), Status::ok);
        ASSERT_EQ(opened(7), static_cast<uint8_t>(i)) << i;
    }
}

TEST_F(IndexStoreTest, an_index_of_another_mission_does_not_count) {
    IndexStore store;
    uint8_t index;
    ASSERT_EQ(store.open(7, index), Status::ok);
    ASSERT_EQ(store.write(7, 12), Status::ok);
    EXPECT_EQ(opened(8), 0);
    EXPECT_EQ(opened(7), 12);
}

TEST_F(IndexStoreTest, a_power_cut_at_any_byte_leaves_the_old_or_the_new_index) {
    uint8_t old_index = 1, index;
    {
        IndexStore store;
        ASSERT_EQ(store.open(7, index), Status::ok);
        ASSERT_EQ(store.write(7, old_index), Status::ok);
    }
    for (int round = 2; round < 600; ++round) {
        const uint8_t new_index = static_cast<uint8_t>(round);
        const auto before = fakes::eepromCells();
        for (uint32_t cut = 0; cut < 3; ++cut) {
            fakes::setEepromCells(before);
            IndexStore store;
            ASSERT_EQ(store.open(7, index), Status::ok);
            fakes::cutPowerAfter(cut);
            ASSERT_EQ(store.write(7, new_index), Status::ok);
            fakes::restartEeprom();
            const uint8_t found = opened(7);
            ASSERT_TRUE(found == old_index || found == new_index) << round << " " << cut;
            // a cut entry must not stand in the way of the next
            IndexStore next;
            ASSERT_EQ(next.open(7, index), Status::ok);
            ASSERT_EQ(next.write(7, 200), Status::ok);
            ASSERT_EQ(opened(7), 200);
        }
        fakes::setEepromCells(before);
        IndexStore store;
        ASSERT_EQ(store.open(7, index), Status::ok);
        ASSERT_EQ(store.write(7, new_index), Status::ok);
        old_index = new_index;
    }
}

}  // namespace

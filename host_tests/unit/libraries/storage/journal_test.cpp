// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/journal.hpp"

#include <gtest/gtest.h>

#include "core/crc.hpp"
#include "fakes/fakes.hpp"
#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"

namespace {

using core::Status;
using storage::Journal;

class JournalTest : public testing::Test {
protected:
    void SetUp() override { fakes::reset(); }

    static uint32_t slot(uint16_t number) {
        uint32_t value = 0;
        EXPECT_EQ(Journal().read(number, value), Status::ok);
        return value;
    }
};

TEST_F(JournalTest, a_value_is_in_its_slot_after_it_was_written) {
    Journal journal;
    ASSERT_EQ(journal.recover(), Status::ok);

    ASSERT_EQ(journal.write(255, 0x12345678), Status::ok);

    EXPECT_EQ(slot(255), 0x12345678u);
    EXPECT_EQ(slot(254), 0xFFFFFFFFu);
}

TEST_F(JournalTest, a_slot_outside_the_region_is_refused) {
    Journal journal;
    ASSERT_EQ(journal.recover(), Status::ok);
    uint32_t value;

    EXPECT_EQ(journal.write(256, 1), Status::bad_argument);
    EXPECT_EQ(journal.read(256, value), Status::bad_argument);
    EXPECT_EQ(fakes::eepromWrites(), 0u);
}

TEST_F(JournalTest, recovering_a_blank_eeprom_writes_nothing) {
    Journal journal;
    EXPECT_EQ(journal.recover(), Status::ok);
    EXPECT_EQ(fakes::eepromWrites(), 0u);
}

// Several values one after another, so that the entries go round and their numbers wrap; each is
// cut at every byte.
TEST_F(JournalTest, a_power_cut_at_any_byte_leaves_the_old_or_the_new_value) {
    Journal journal;
    ASSERT_EQ(journal.recover(), Status::ok);
    uint32_t old_value = 0;
    ASSERT_EQ(journal.write(5, old_value), Status::ok);
    int cuts = 0;
    for (uint32_t round = 1; round <= 300; ++round) {
        const uint32_t new_value = round * 2654435761u;
        const auto before = fakes::eepromCells();
        for (uint32_t after = 0; after < 20; ++after) {
            fakes::setEepromCells(before);
            Journal writer;
            ASSERT_EQ(writer.recover(), Status::ok);
            fakes::cutPowerAfter(after);
            ASSERT_EQ(writer.write(5, new_value), Status::ok);
            if (!fakes::powerWasCut()) break;
            ++cuts;
            fakes::restartEeprom();
            Journal reader;
            ASSERT_EQ(reader.recover(), Status::ok);
            const uint32_t found = slot(5);
            ASSERT_TRUE(found == old_value || found == new_value)
                << "round " << round << ", cut after " << after << " bytes: " << found;
            ASSERT_EQ(slot(4), 0xFFFFFFFFu);
            ASSERT_EQ(slot(6), 0xFFFFFFFFu);
        }
        fakes::setEepromCells(before);
        Journal writer;
        ASSERT_EQ(writer.recover(), Status::ok);
        ASSERT_EQ(writer.write(5, new_value), Status::ok);
        old_value = new_value;
    }
    EXPECT_GT(cuts, 2500);
}

TEST_F(JournalTest, nothing_is_lost_while_the_queue_is_full) {
    fakes::setEepromSlow(true);
    Journal journal;
    ASSERT_EQ(journal.recover(), Status::ok);
    uint32_t busy = 0;
    for (uint16_t i = 0; i < 40;) {
        const Status status = journal.write(i, 1000u + i);
        if (status == Status::ok) ++i;
        if (status == Status::busy) ++busy;
        fakes::advance_ms(10);
    }
    while (!journal.applyPending()) fakes::advance_ms(10);
    fakes::advance_ms(1000);
    ASSERT_TRUE(hal::eepromDrained());
    fakes::restartEeprom();

    EXPECT_GT(busy, 10u);
    for (uint16_t i = 0; i < 40; ++i) EXPECT_EQ(slot(i), 1000u + i);
}

TEST(Crc, has_the_published_check_value) {
    EXPECT_EQ(core::crc16(core::kCrcStart, "123456789", 9), 0x6F91);
}

}  // namespace

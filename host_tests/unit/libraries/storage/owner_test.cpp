// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/owner.hpp"

#include <gtest/gtest.h>

#include "core/crc.hpp"
#include "fakes/fakes.hpp"
#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"

namespace {

using core::Status;
using storage::Owner;

class OwnerTest : public testing::Test {
protected:
    void SetUp() override { fakes::reset(); }
    static Owner owner() {
        Owner found = Owner::foreign;
        EXPECT_EQ(storage::findOwner(found), Status::ok);
        return found;
    }
    static bool mendedDamage() {
        bool damaged = false;
        EXPECT_EQ(storage::mendMarks(damaged), Status::ok);
        return damaged;
    }
};

TEST_F(OwnerTest, a_blank_eeprom_has_no_owner_and_can_be_claimed) {
    EXPECT_EQ(owner(), Owner::blank);
    ASSERT_EQ(storage::claim(), Status::ok);
    EXPECT_EQ(owner(), Owner::ours);
}

TEST_F(OwnerTest, a_claim_that_a_power_cut_broke_can_be_made_again) {
    for (uint32_t cut = 0; cut < 7; ++cut) {
        fakes::resetEeprom();
        fakes::cutPowerAfter(cut);
        ASSERT_EQ(storage::claim(), Status::ok);
        fakes::restartEeprom();
        EXPECT_EQ(owner(), Owner::blank) << cut;
    }
}

TEST_F(OwnerTest, a_claim_cut_in_its_second_mark_is_ours_and_is_completed) {
    fakes::cutPowerAfter(10);
    ASSERT_EQ(storage::claim(), Status::ok);
    fakes::restartEeprom();
    EXPECT_EQ(owner(), Owner::ours);
    EXPECT_FALSE(mendedDamage()) << "it was only not yet there, as in what had one mark";
    EXPECT_EQ(fakes::eepromCell(8), 0xB7);
}

TEST_F(OwnerTest, any_bit_of_it_may_change_or_be_worn_and_it_still_is_ours) {
    ASSERT_EQ(storage::claim(), Status::ok);
    const auto whole = fakes::eepromCells();
    for (uint16_t at = 0; at < storage::kHeader.size; ++at)
        for (int bit = 0; bit < 8; ++bit) {
            fakes::setEepromCells(whole);
            fakes::setEepromCell(at, static_cast<uint8_t>(whole[at] ^ 1 << bit));
            ASSERT_EQ(owner(), Owner::ours) << at;
            EXPECT_TRUE(mendedDamage()) << at;
            EXPECT_EQ(fakes::eepromCells(), whole) << at;
            EXPECT_FALSE(mendedDamage()) << at;
            fakes::wearEepromCell(at, static_cast<uint8_t>(1 << bit), (whole[at] >> bit & 1) == 0);
            ASSERT_EQ(owner(), Owner::ours) << at;
            EXPECT_TRUE(mendedDamage()) << at;
            EXPECT_EQ(owner(), Owner::ours) << at;
            fakes::resetEeprom();
        }
}

TEST_F(OwnerTest, data_of_arduplane_and_a_blank_header_before_old_data_belong_to_other_firmware) {
    const uint8_t arduplane[] = {0x41, 0x50, 0x06, 0x00};
    ASSERT_EQ(hal::eepromWrite(0, arduplane, 4), Status::ok);
    EXPECT_EQ(owner(), Owner::foreign);

    fakes::resetEeprom();
    fakes::setEepromCell(4000, 1);
    EXPECT_EQ(owner(), Owner::foreign);
}

TEST_F(OwnerTest, another_layout_version_of_ours_is_recognised_as_such) {
    uint8_t header[] = {0xB7, 'A', 'P', 'M', storage::kLayoutVersion + 1, 0, 0};
    const uint16_t crc = core::crc16(core::kCrcStart, header, 5);
    header[5] = static_cast<uint8_t>(crc);
    header[6] = static_cast<uint8_t>(crc >> 8);
    ASSERT_EQ(hal::eepromWrite(0, header, sizeof header), Status::ok);
    EXPECT_EQ(owner(), Owner::other_version);

    fakes::setEepromCell(5, fakes::eepromCell(5) ^ 1);
    EXPECT_EQ(owner(), Owner::foreign) << "its CRC is wrong";
}

TEST_F(OwnerTest, erasing_on_demand_makes_it_ours_and_a_cut_on_the_way_does_not_make_half_of_it) {
    for (uint16_t at = 0; at < hal::kEepromSize; ++at)
        fakes::setEepromCell(at, static_cast<uint8_t>(at));
    const auto before = fakes::eepromCells();
    for (uint32_t cut : {0u, 1u, 15u, 16u, 100u, 2000u, 4050u}) {
        fakes::setEepromCells(before);
        fakes::cutPowerAfter(cut);
        uint16_t at = 0;
        ASSERT_EQ(storage::erase(at), Status::ok);
        fakes::restartEeprom();
        EXPECT_EQ(owner(), Owner::foreign) << cut;
    }
    fakes::setEepromCells(before);
    uint16_t at = 0;
    ASSERT_EQ(storage::erase(at), Status::ok);
    EXPECT_EQ(owner(), Owner::ours);
    EXPECT_EQ(fakes::eepromCell(2000), 0xFF);
}

}  // namespace

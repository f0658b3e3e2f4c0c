// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/saved_home.hpp"

#include <cstring>

#include "fakes/fakes.hpp"
#include "firmware_bench.hpp"
#include "storage/eeprom_map.hpp"
#include "storage/owner.hpp"

namespace {

using core::Status;
using namespace firmware;
using namespace firmware::notify;
using namespace firmware::state;
using namespace firmware::sensors;
using namespace firmware::modes;
using namespace firmware::safety;
using namespace firmware::gcs;

class SavedHomeTest : public testing::Test {
protected:
    void SetUp() override {
        fakes::reset();
        until([] { return storage::claim(); });
    }
    template <class Step>
    Status until(Step step) {
        Status status;
        while ((status = step()) == Status::busy) fakes::advance_ms(10);
        while (!hal::eepromDrained()) fakes::advance_ms(10);
        return status;
    }
    Status save(int32_t latitude_e7) {
        return until([&] { return saveHome({latitude_e7, 85456000}, 48800); });
    }
    Status read(SavedHome& home) {
        return until([&] { return readHome(home); });
    }
};

}  // namespace

TEST_F(SavedHomeTest, a_blank_eeprom_has_none) {
    SavedHome home;
    EXPECT_EQ(read(home), Status::corrupt);
}

TEST_F(SavedHomeTest, what_was_saved_is_read_back) {
    ASSERT_EQ(save(473977000), Status::ok);
    SavedHome home;
    ASSERT_EQ(read(home), Status::ok);
    EXPECT_EQ(home.position.latitude_e7, 473977000);
    EXPECT_EQ(home.position.longitude_e7, 85456000);
    EXPECT_EQ(home.altitude_cm, 48800);
}

TEST_F(SavedHomeTest, what_was_forgotten_is_not) {
    ASSERT_EQ(save(473977000), Status::ok);
    ASSERT_EQ(until(forgetHome), Status::ok);
    SavedHome home;
    EXPECT_EQ(read(home), Status::corrupt);
    EXPECT_EQ(until(forgetHome), Status::ok) << "twice is no harm";
    ASSERT_EQ(save(473978000), Status::ok);
    EXPECT_EQ(read(home), Status::ok);
}

TEST_F(SavedHomeTest, a_power_cut_leaves_one_of_the_two_or_none) {
    for (uint32_t writes = 0; writes < 28; ++writes) {
        SetUp();
        ASSERT_EQ(save(473977000), Status::ok);
        fakes::cutPowerAfter(writes);
        (void)until([] { return saveHome({-331234567, 1512345678}, 12300); });
        fakes::restartEeprom();
        SavedHome home;
        if (read(home) != Status::ok) continue;
        const bool old = home.position.latitude_e7 == 473977000 && home.altitude_cm == 48800;
        const bool now = home.position.latitude_e7 == -331234567 && home.altitude_cm == 12300;
        EXPECT_TRUE(old || now) << writes;
    }
}

TEST_F(SavedHomeTest, a_power_cut_of_the_forgetting_leaves_it_or_none) {
    bool gone = false;
    for (uint32_t writes = 0; writes < 5; ++writes) {
        SetUp();
        ASSERT_EQ(save(473977000), Status::ok);
        fakes::cutPowerAfter(writes);
        (void)until(forgetHome);
        fakes::restartEeprom();
        SavedHome home;
        gone = read(home) == Status::corrupt;
        if (!gone) {
            EXPECT_EQ(home.position.latitude_e7, 473977000);
        }
    }
    EXPECT_TRUE(gone);
}

TEST_F(SavedHomeTest, any_bit_may_change_or_be_worn_saved_and_forgotten) {
    for (uint16_t at = storage::kHomeAndLog.begin; at < storage::kHomeAndLog.end(); ++at)
        for (int bit = 0; bit < 8; ++bit) {
            SetUp();
            ASSERT_EQ(save(473977000), Status::ok);
            const uint8_t mask = static_cast<uint8_t>(1 << bit);
            fakes::wearEepromCell(at, mask, (fakes::eepromCell(at) & mask) == 0);
            SavedHome home;
            ASSERT_EQ(read(home), Status::ok) << at << ", " << bit;
            EXPECT_EQ(home.position.latitude_e7, 473977000);
            EXPECT_EQ(home.position.longitude_e7, 85456000);
            EXPECT_EQ(home.altitude_cm, 48800);
            ASSERT_EQ(until(forgetHome), Status::ok);
            ASSERT_EQ(read(home), Status::corrupt) << at << ", " << bit;
            fakes::resetEeprom();
            SetUp();
            ASSERT_EQ(save(473977000), Status::ok);
            ASSERT_EQ(until(forgetHome), Status::ok);
            fakes::setEepromCell(at, static_cast<uint8_t>(fakes::eepromCell(at) ^ mask));
            ASSERT_EQ(read(home), Status::corrupt) << at << ", " << bit;
        }
}

TEST_F(SavedHomeTest, of_a_version_that_had_one_is_read_and_forgotten) {
    ASSERT_EQ(save(473977000), Status::ok);
    for (uint16_t at = 14; at < 28; ++at)
        fakes::setEepromCell(static_cast<uint16_t>(storage::kHomeAndLog.begin + at), 0xFF);
    const auto saved = fakes::eepromCells();
    SavedHome home;
    ASSERT_EQ(read(home), Status::ok);
    EXPECT_EQ(home.position.latitude_e7, 473977000);
    ASSERT_EQ(until(forgetHome), Status::ok);
    EXPECT_EQ(read(home), Status::corrupt);
    fakes::setEepromCells(saved);
    for (uint16_t at = 12; at < 14; ++at) {  // forgotten by that version
        const auto cell = static_cast<uint16_t>(storage::kHomeAndLog.begin + at);
        fakes::setEepromCell(cell, static_cast<uint8_t>(~fakes::eepromCell(cell)));
    }
    EXPECT_EQ(read(home), Status::corrupt);
}

TEST_F(SavedHomeTest, waits_while_the_eeprom_is_busy) {
    ASSERT_EQ(save(473977000), Status::ok);
    fakes::setEepromSlow(true);
    const uint8_t other[4] = {1, 2, 3, 4};
    ASSERT_EQ(hal::eepromWrite(storage::kHomeAndLog.end() - 4, other, sizeof other), Status::ok);
    SavedHome home = {};
    EXPECT_EQ(readHome(home), Status::busy);
    EXPECT_EQ(forgetHome(), Status::busy);
    EXPECT_EQ(saveHome({1, 2}, 3), Status::busy);
    ASSERT_EQ(read(home), Status::ok);
    EXPECT_EQ(home.position.latitude_e7, 473977000);
}

TEST_F(SavedHomeTest, writes_nothing_into_another_firmwares_eeprom) {
    const std::vector<uint8_t> foreign(4096, 0x5A);
    fakes::setEepromCells(foreign);
    EXPECT_EQ(save(473977000), Status::ok);
    EXPECT_EQ(until(forgetHome), Status::ok);
    EXPECT_EQ(fakes::eepromCells(), foreign);
}

TEST_F(SavedHomeTest, is_not_forgotten_before_it_can_be_read) {
    ASSERT_EQ(save(473977000), Status::ok);
    fakes::setEepromSlow(true);
    const uint8_t other = 1;
    ASSERT_EQ(hal::eepromWrite(storage::kHomeAndLog.end() - 4, &other, 1), Status::ok);
    EXPECT_EQ(forgetHome(), Status::busy);
    SavedHome home;
    EXPECT_EQ(read(home), Status::ok);
    EXPECT_EQ(home.position.latitude_e7, 473977000);
}

TEST_F(SavedHomeTest, leaves_the_logs_part_of_the_region_unchanged) {
    const uint16_t at = storage::kHomeAndLog.end() - 4;
    const uint8_t logs[4] = {1, 2, 3, 4};
    ASSERT_EQ(until([&] { return hal::eepromWrite(at, logs, sizeof logs); }), Status::ok);
    ASSERT_EQ(save(473977000), Status::ok);
    uint8_t now[4];
    ASSERT_EQ(until([&] { return hal::eepromRead(at, now, sizeof now); }), Status::ok);
    EXPECT_EQ(std::memcmp(now, logs, sizeof now), 0);
}

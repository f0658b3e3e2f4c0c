// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/log_base.hpp"

#include <gtest/gtest.h>

#include "fakes/fakes.hpp"
#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"
#include "storage/owner.hpp"

namespace {

using core::Status;

constexpr uint16_t kAt = storage::kHomeAndLog.end() - 4;
constexpr uint16_t kLargestRing = 8192 - 16;

class LogBaseTest : public testing::Test {
protected:
    void SetUp() override {
        fakes::reset();
        ASSERT_EQ(storage::claim(), Status::ok);
    }
    static uint16_t page() {
        uint16_t read = 1;
        EXPECT_EQ(storage::readLogBase(read), Status::ok);
        return read;
    }
};

TEST_F(LogBaseTest, any_page_is_read_back_though_a_bit_changes_or_is_worn) {
    for (uint16_t base = 0; base < kLargestRing; base += 8) {
        ASSERT_EQ(storage::writeLogBase(base), Status::ok);
        const auto cells = fakes::eepromCells();
        ASSERT_EQ(page(), base);
        for (uint16_t at = kAt; at < kAt + 4; ++at)
            for (int bit = 0; bit < 8; ++bit) {
                const uint8_t mask = static_cast<uint8_t>(1 << bit);
                fakes::wearEepromCell(at, mask, (cells[at] & mask) == 0);
                ASSERT_EQ(page(), base) << at << ", " << bit;
                ASSERT_EQ(storage::writeLogBase(base), Status::ok);
                ASSERT_EQ(page(), base);
                fakes::resetEeprom();
                fakes::setEepromCells(cells);
            }
    }
}

TEST_F(LogBaseTest, blank_with_a_changed_bit_or_without_is_no_place_in_any_ring_or_its_beginning) {
    EXPECT_EQ(page(), storage::kNoLogBase);
    for (uint16_t at = kAt; at < kAt + 4; ++at)
        for (int bit = 0; bit < 8; ++bit) {
            fakes::setEepromCell(at, static_cast<uint8_t>(0xFF ^ 1 << bit));
            EXPECT_TRUE(page() >= kLargestRing || page() == 0) << at << ", " << bit;
            fakes::setEepromCell(at, 0xFF);
        }
}

TEST_F(LogBaseTest, nothing_is_written_into_another_firmwares_eeprom) {
    const std::vector<uint8_t> foreign(4096, 0x5A);
    fakes::setEepromCells(foreign);
    EXPECT_EQ(storage::writeLogBase(800), Status::ok);
    EXPECT_EQ(fakes::eepromCells(), foreign);
}

TEST_F(LogBaseTest, that_of_the_first_boards_is_read) {
    for (uint16_t base = 0; base < kLargestRing; base += 8) {
        const uint16_t stored[] = {base, static_cast<uint16_t>(~base)};
        ASSERT_EQ(hal::eepromWrite(kAt, stored, sizeof stored), Status::ok);
        ASSERT_EQ(page(), base);
    }
}

}  // namespace

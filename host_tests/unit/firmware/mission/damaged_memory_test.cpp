// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that does not keep what was stored: mended or reported, and never flown.
#include "firmware/mission/lists.hpp"
#include "host_tests/support/spelt.hpp"
#include "mission_flight.hpp"
#include "storage/eeprom_map.hpp"
#include "storage/index_store.hpp"

namespace firmware {
using namespace mission;
namespace {

class DamagedMemory : public MissionFlight {
protected:
    void SetUp() override {
        MissionFlight::SetUp();
        ASSERT_EQ(upload({waypoint(500), waypoint(900), waypoint(1500)}), MissionResult::accepted);
        (void)statusTexts();
    }
    static void flip(uint16_t at) {
        fakes::setEepromCell(at, static_cast<uint8_t>(fakes::eepromCell(at) ^ 0x10));
    }
    static std::string textsOfStart() {
        missionBoot();
        for (int i = 0; i < 100; ++i) missionRun();
        return statusTexts();
    }
    static bool has(const std::string& texts, const char* part) {
        return texts.find(part) != std::string::npos;
    }
};

TEST_F(DamagedMemory, with_either_head_damaged_the_mission_stays_and_is_mended) {
    const auto cells = fakes::eepromCells();
    for (const uint16_t head : {0, 1}) {
        fakes::setEepromCells(cells);
        flip(static_cast<uint16_t>(storage::kMissionHead.begin + head * storage::kHeadSize + 5));
        const std::string texts = textsOfStart();
        EXPECT_TRUE(has(texts, "Memory has not kept")) << texts;
        EXPECT_TRUE(has(texts, "Mission mended")) << texts;
        EXPECT_EQ(missionCount(), 4);
        EXPECT_EQ(textsOfStart(), "") << "the next start finds nothing";
    }
}

TEST_F(DamagedMemory, a_record_that_changed_is_not_flown_but_reported_at_the_start) {
    flip(storage::recordAddress(2) + 8);
    const std::string texts = textsOfStart();
    EXPECT_TRUE(has(texts, "No mission: cannot be read")) << texts;
    EXPECT_EQ(missionCount(), 0);
}

TEST_F(DamagedMemory, a_record_that_changes_in_flight_ends_the_mission_in_rtl) {
    ASSERT_TRUE(requestMode(Mode::automatic, ModeReason::ground));
    seconds(1);
    ASSERT_EQ(missionCurrent(), 1);
    (void)statusTexts();
    flip(storage::recordAddress(3) + 8);
    seconds(10);
    EXPECT_TRUE(hasStatusText("No mission: cannot be read"));
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    firmware::notify::StatusText why_not;
    EXPECT_FALSE(missionEnter(why_not));
    EXPECT_EQ(spelt(why_not), "AUTO: mission cannot be read");
}

TEST_F(DamagedMemory, an_index_that_changed_is_reported_and_the_one_before_stored_again) {
    const auto isIndex = [](uint8_t wanted) {
        storage::IndexStore store;
        uint8_t index = 0;
        bool damaged = true;
        EXPECT_EQ(store.open(static_cast<uint8_t>(mission_store.generation()), index, damaged),
                  core::Status::ok);
        EXPECT_FALSE(damaged);
        return index == wanted;
    };
    ASSERT_TRUE(requestMode(Mode::automatic, ModeReason::ground));
    seconds(1);
    const auto before = fakes::eepromCells();
    missionSetCurrent(2);
    seconds(1);
    ASSERT_TRUE(isIndex(2));
    uint16_t newest = storage::kIndex.begin;
    while (fakes::eepromCell(newest) == before[newest]) ++newest;
    flip(newest);
    const std::string texts = textsOfStart();
    EXPECT_TRUE(has(texts, "Memory has not kept")) << texts;
    EXPECT_TRUE(isIndex(1));
    EXPECT_EQ(textsOfStart(), "") << "the next start finds nothing";
}

// Of each place of the index, with items that need each value of the bit.
TEST_F(DamagedMemory, a_worn_cell_of_the_index_is_reported_and_the_next_place_taken) {
    int reported = 0;
    for (uint16_t at = storage::kIndex.begin; at < storage::kIndex.begin + 63; ++at)
        for (const int bit : {0, 1, 9, 3 + at % 5}) {
            fakes::resetEeprom();
            ASSERT_TRUE(requestMode(Mode::loiter, ModeReason::ground));
            missionBoot();
            ASSERT_EQ(upload({waypoint(500), waypoint(900), waypoint(1500)}),
                      MissionResult::accepted);
            ASSERT_TRUE(enterAuto());
            fakes::wearEepromCell(at, static_cast<uint8_t>(1 << bit % 8), bit > 7);
            bool noticed = false;
            for (uint16_t n = 0; n < 25; ++n) {
                const auto item = static_cast<uint16_t>(1 + (n + n / 21) % 3);
                ASSERT_TRUE(missionSetCurrent(item));
                pass(4);
                storage::IndexStore store;
                uint8_t index = 0;
                bool damaged = false;
                ASSERT_EQ(
                    store.open(static_cast<uint8_t>(mission_store.generation()), index, damaged),
                    core::Status::ok);
                ASSERT_EQ(index, item) << at << ", " << bit;
                noticed |= hasStatusText("EEPROM is worn");
            }
            reported += noticed;
        }
    EXPECT_GT(reported, 100) << "in every other cell the bit is as it should be";
}

TEST_F(DamagedMemory, a_worn_head_is_reported_and_the_upload_not_acknowledged_on_it) {
    for (uint16_t at = storage::kMissionHead.begin; at < storage::kMission.begin; ++at)
        fakes::wearEepromCell(at, 0x40, (at & 1) != 0);
    EXPECT_EQ(upload({waypoint(700)}), MissionResult::error);
    EXPECT_TRUE(hasStatusText("Not stored: memory error"));
    EXPECT_EQ(missionCount(), 4) << "as long as the power stays";
}

TEST_F(DamagedMemory, a_worn_second_head_is_reported_but_the_upload_is_stored) {
    fakes::wearEepromCell(storage::kMissionHead.begin, 0x40, false);
    EXPECT_EQ(upload({waypoint(700)}), MissionResult::accepted);
    for (int i = 0; i < 20; ++i) missionRun();
    EXPECT_TRUE(hasStatusText("EEPROM is worn"));
    (void)textsOfStart();
    EXPECT_EQ(missionCount(), 2);
}

}  // namespace
}  // namespace firmware

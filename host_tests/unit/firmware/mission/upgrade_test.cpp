// SPDX-License-Identifier: GPL-3.0-or-later
// EEPROMs as earlier versions of this firmware left them: images/*.hex, and beside them the
// parameters they hold as "slot NAME value". Whatever was stored is found.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "firmware/mission/lists.hpp"
#include "mission_rig.hpp"

namespace firmware {
using namespace mission;
namespace {

std::string imageFile(const std::string& name) {
    return (std::filesystem::path(__FILE__).parent_path() / "images" / name).string();
}

// Intel hex with nothing but data; what is blank may be left out.
std::vector<uint8_t> readImage(const std::string& name) {
    std::ifstream file(imageFile(name));
    EXPECT_TRUE(file) << name;
    std::vector<uint8_t> cells(hal::kEepromSize, 0xFF);
    const auto number = [](const std::string& digits) { return std::stoul(digits, nullptr, 16); };
    for (std::string line; std::getline(file, line) && line.substr(7, 2) == "00";)
        for (size_t i = 0, address = number(line.substr(3, 4)); i < number(line.substr(1, 2)); ++i)
            cells.at(address + i) = static_cast<uint8_t>(number(line.substr(9 + 2 * i, 2)));
    return cells;
}

class Upgrade : public Rig {
protected:
    static void boot(const std::string& image) {
        fakes::setEepromCells(readImage(image));
        while (parametersLoad() == core::Status::busy) {
        }
        missionBoot();
        for (int i = 0; i < 100; ++i) missionRun();
    }
    // `set` is MIS_SET, which each image has as its mission needed it.
    static void expectParameters(float set) {
        std::ifstream file(imageFile("layout1.parameters"));
        int slot, count = 0;
        std::string name;
        for (float wanted; file >> slot >> name >> wanted; ++count) {
            float found = -1e9f;
            // SRn_RAW_CTRL and SRn_PARAMS, given up since
            if (slot == 13 || slot == 22 || slot == 18 || slot == 27) continue;
            ASSERT_TRUE(parameterGet(static_cast<uint8_t>(slot), found)) << name << " is gone";
            EXPECT_EQ(found, name == "MIS_SET" ? set : wanted) << name;
        }
        EXPECT_EQ(count, 167);
    }
    static void expectMission(int count, int32_t step_m, float height_m) {
        ASSERT_EQ(missionCount(), count);
        for (int i = 1; i < count; ++i) {
            const MissionItem found = stored(static_cast<uint16_t>(i));
            if (i == 8 && count == 60) continue;  // a relay, looked at by the test
            EXPECT_EQ(found, waypoint(step_m * (i - 1), height_m)) << i;
        }
    }
};

TEST_F(Upgrade, from_the_first_version_with_a_mission_of_the_apm1_set) {
    boot("layout1_set1.hex");
    EXPECT_EQ(missionSet(), ::mission::Set::apm1);
    expectParameters(1);
    expectMission(70, 10, 40);
    EXPECT_EQ(listCount(ListKind::fence), 0);
    EXPECT_EQ(listCount(ListKind::rally), 0);
}

TEST_F(Upgrade, from_the_first_version_with_a_mission_round_the_end_of_the_ring) {
    boot("layout1_ring.hex");
    EXPECT_EQ(missionSet(), ::mission::Set::apm2);
    expectParameters(2);
    expectMission(60, 30, 60);
    EXPECT_EQ(stored(8), command(181, 0, 1));
    parameters.mission_restart = 0;
    ASSERT_TRUE(enterAuto());
    EXPECT_EQ(missionCurrent(), 5) << "where that airplane was";
}

TEST_F(Upgrade, from_the_first_version_whose_power_was_cut_in_an_upload) {
    boot("layout1_cut.hex");
    expectParameters(2);
    expectMission(60, 30, 60);
}

// Written when fence and rally points had come into what was blank before.
TEST_F(Upgrade, from_a_board_with_fence_and_rally_points) {
    boot("layout1_lists.hex");
    expectParameters(2);
    expectMission(60, 30, 60);
    for (const ListKind kind : {ListKind::fence, ListKind::rally}) {
        ASSERT_EQ(listCount(kind), listCapacity(kind));
        const int size = storage::shapeOf(kind).record_size;
        for (int i = 0; i < listCount(kind); ++i) {
            uint8_t record[storage::kLargestRecord];
            ASSERT_EQ(listRead(kind, static_cast<uint8_t>(i), record), core::Status::ok);
            for (int k = 0; k < size; ++k)
                ASSERT_EQ(record[k], static_cast<uint8_t>(i * 31 + k * 7 + static_cast<int>(kind)));
        }
    }
}

TEST_F(Upgrade, the_lists_do_not_overlap_what_the_first_version_stored) {
    boot("layout1_ring.hex");
    const std::vector<uint8_t> record(storage::kLargestRecord, 0x5A);
    for (const ListKind kind : {ListKind::fence, ListKind::rally}) {
        const uint8_t count = listCapacity(kind);
        ASSERT_EQ(whileBusy([&] { return listBegin(kind, count, 1); }), MissionResult::accepted);
        for (int i = 0; i < count; ++i)
            ASSERT_EQ(whileBusy([&] { return listPut(record.data()); }), MissionResult::accepted);
        ASSERT_EQ(whileBusy(listCommit), MissionResult::accepted);
    }
    uint16_t index = 0;
    ASSERT_TRUE(parameterOfSlot(3, index));
    ASSERT_EQ(parameterSetAt(index, 111), core::Status::ok);
    ASSERT_EQ(parameterSetAt(index, 58), core::Status::ok);
    missionBoot();
    while (parametersLoad() == core::Status::busy) {
    }
    expectParameters(2);
    expectMission(60, 30, 60);
    EXPECT_EQ(listCount(ListKind::fence), 20);
    EXPECT_EQ(listCount(ListKind::rally), 10);
}

}  // namespace
}  // namespace firmware

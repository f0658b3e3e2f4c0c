// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/lists.hpp"

#include <array>

#include "mission_rig.hpp"

namespace firmware {
using namespace mission;
namespace {

using Record = std::array<uint8_t, storage::kLargestRecord>;

class Lists : public Rig {
protected:
    static Record record(uint8_t seed) {
        Record made;
        for (size_t i = 0; i < made.size(); ++i) made[i] = static_cast<uint8_t>(seed * 31 + i);
        return made;
    }
    static MissionResult commit() { return whileBusy(listCommit); }
    static MissionResult store(ListKind kind, uint8_t count, uint8_t seed) {
        const MissionResult begun = whileBusy([&] { return listBegin(kind, count, 1); });
        if (begun != MissionResult::accepted) return begun;
        for (uint8_t i = 0; i < count; ++i) {
            const Record made = record(static_cast<uint8_t>(seed + i));
            const MissionResult put = whileBusy([&] { return listPut(made.data()); });
            if (put != MissionResult::accepted) return put;
        }
        return commit();
    }
    // The first of its records that is not what store() put there; the count when all are.
    static int firstWrong(ListKind kind, uint8_t seed) {
        const uint8_t size = storage::shapeOf(kind).record_size;
        for (uint8_t i = 0; i < listCount(kind); ++i) {
            Record found = {};
            EXPECT_EQ(listRead(kind, i, found.data()), core::Status::ok);
            const Record wanted = record(static_cast<uint8_t>(seed + i));
            if (!std::equal(wanted.begin(), wanted.begin() + size, found.begin())) return i;
        }
        return listCount(kind);
    }
};

TEST_F(Lists, a_full_fence_and_full_rally_points_fit_beside_a_full_mission) {
    ASSERT_EQ(upload(Items(170, waypoint(100))), MissionResult::accepted);
    ASSERT_EQ(store(ListKind::fence, 20, 1), MissionResult::accepted);
    ASSERT_EQ(store(ListKind::rally, 10, 2), MissionResult::accepted);

    fakes::restartEeprom();
    missionBoot();

    EXPECT_EQ(missionCount(), 171);
    EXPECT_EQ(stored(170), waypoint(100));
    EXPECT_EQ(firstWrong(ListKind::fence, 1), 20);
    EXPECT_EQ(firstWrong(ListKind::rally, 2), 10);
}

TEST_F(Lists, more_than_the_capacity_is_no_space) {
    EXPECT_EQ(listBegin(ListKind::fence, 21, 1), MissionResult::no_space);
    EXPECT_EQ(listBegin(ListKind::fence, 276, 1), MissionResult::no_space);
    EXPECT_EQ(listBegin(ListKind::rally, 11, 1), MissionResult::no_space);
}

TEST_F(Lists, the_old_list_is_the_list_until_the_commit_is_accepted) {
    ASSERT_EQ(store(ListKind::rally, 3, 1), MissionResult::accepted);
    const uint8_t before = listGeneration(ListKind::rally);
    ASSERT_EQ(whileBusy([] { return listBegin(ListKind::rally, 2, 1); }), MissionResult::accepted);
    ASSERT_EQ(listPut(record(50).data()), MissionResult::accepted);
    EXPECT_EQ(listCommit(), MissionResult::invalid_sequence) << "one is missing";
    EXPECT_EQ(firstWrong(ListKind::rally, 1), 3);
    EXPECT_EQ(listGeneration(ListKind::rally), before);
    ASSERT_EQ(listPut(record(51).data()), MissionResult::accepted);
    ASSERT_EQ(commit(), MissionResult::accepted);
    EXPECT_EQ(firstWrong(ListKind::rally, 50), 2);
    EXPECT_NE(listGeneration(ListKind::rally), before);
}

TEST_F(Lists, the_id_is_that_of_the_contents_wherever_they_lie) {
    EXPECT_EQ(listId(ListKind::rally), 0u) << "empty";
    ASSERT_EQ(store(ListKind::rally, 3, 1), MissionResult::accepted);
    const uint32_t id = listId(ListKind::rally);
    EXPECT_NE(id, 0u);
    ASSERT_EQ(store(ListKind::rally, 3, 2), MissionResult::accepted);
    EXPECT_NE(listId(ListKind::rally), id) << "other points";
    ASSERT_EQ(store(ListKind::rally, 2, 1), MissionResult::accepted);
    EXPECT_NE(listId(ListKind::rally), id) << "fewer";
    ASSERT_EQ(store(ListKind::rally, 3, 1), MissionResult::accepted);
    EXPECT_EQ(listId(ListKind::rally), id) << "the same again";
    EXPECT_EQ(listId(ListKind::fence), 0u);

    fakes::restartEeprom();
    missionBoot();
    EXPECT_EQ(listId(ListKind::rally), id);
}

TEST_F(Lists, one_record_is_replaced_and_the_others_stay) {
    ASSERT_EQ(store(ListKind::fence, 5, 1), MissionResult::accepted);
    ASSERT_EQ(whileBusy([] { return listBegin(ListKind::fence, 5, 1); }), MissionResult::accepted);
    for (int i = 0; i < 5; ++i) {
        const Record changed = record(100);
        EXPECT_EQ(i == 3 ? listPut(changed.data()) : listCopy(), MissionResult::accepted);
    }
    ASSERT_EQ(commit(), MissionResult::accepted);
    EXPECT_EQ(firstWrong(ListKind::fence, 1), 3);
    Record found = {};
    ASSERT_EQ(listRead(ListKind::fence, 3, found.data()), core::Status::ok);
    EXPECT_EQ(found[0], record(100)[0]);
}

TEST_F(Lists, a_clear_empties_its_own_list_alone) {
    ASSERT_EQ(upload({waypoint(100)}), MissionResult::accepted);
    ASSERT_EQ(store(ListKind::fence, 5, 1), MissionResult::accepted);
    ASSERT_EQ(store(ListKind::rally, 4, 2), MissionResult::accepted);
    EXPECT_EQ(whileBusy([] { return listClear(ListKind::fence, 1); }), MissionResult::accepted);
    EXPECT_EQ(listCount(ListKind::fence), 0);
    EXPECT_EQ(listCount(ListKind::rally), 4);
    EXPECT_EQ(missionCount(), 2);
}

TEST_F(Lists, a_fence_upload_ends_an_open_mission_upload) {
    ASSERT_EQ(whileBusy([] { return missionBeginUpload(3); }), MissionResult::accepted);
    ASSERT_EQ(missionUploadItem(0, waypoint(1)), MissionResult::accepted);
    ASSERT_EQ(listBegin(ListKind::fence, 1, 1), MissionResult::accepted);
    EXPECT_EQ(missionUploadItem(1, waypoint(1)), MissionResult::error);
    EXPECT_FALSE(listStaging(ListKind::mission));
    EXPECT_TRUE(listStaging(ListKind::fence));
}

TEST_F(Lists, a_commit_goes_on_without_requests) {
    fakes::setEepromSlow(true);
    ASSERT_EQ(whileBusy([] { return listBegin(ListKind::rally, 2, 1); }), MissionResult::accepted);
    for (uint8_t i = 0; i < 2; ++i) {
        ASSERT_EQ(whileBusy([&] { return listPut(record(static_cast<uint8_t>(7 + i)).data()); }),
                  MissionResult::accepted);
    }
    ASSERT_EQ(listCommit(), MissionResult::busy);
    pass(20);
    EXPECT_EQ(firstWrong(ListKind::rally, 7), 2);
    EXPECT_EQ(missionBeginUpload(2), MissionResult::accepted);
}

TEST_F(Lists, a_damaged_fence_is_reported_and_the_other_lists_stay) {
    ASSERT_EQ(upload({waypoint(100)}), MissionResult::accepted);
    ASSERT_EQ(store(ListKind::fence, 5, 1), MissionResult::accepted);
    ASSERT_EQ(store(ListKind::rally, 4, 2), MissionResult::accepted);
    const uint16_t at = storage::kFence.begin + 7;
    fakes::setEepromCell(at, fakes::eepromCell(at) ^ 1);
    (void)statusTexts();
    missionBoot();
    const std::string text = statusTexts();
    EXPECT_NE(text.find("Memory has not kept what was stored"), std::string::npos) << text;
    EXPECT_NE(text.find("No fence"), std::string::npos) << text;
    EXPECT_EQ(listCount(ListKind::fence), 0);
    EXPECT_EQ(listCount(ListKind::rally), 4);
    EXPECT_EQ(missionCount(), 2);
}

}  // namespace
}  // namespace firmware

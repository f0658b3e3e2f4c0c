// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/mission_store.hpp"

#include "core/crc.hpp"
#include "rig.hpp"

namespace {

class MissionStoreTest : public testing::Test {
protected:
    void SetUp() override {
        fakes::reset();
        fakes::resetPageFlash();
    }
};

TEST_F(MissionStoreTest, a_blank_eeprom_holds_an_empty_mission) {
    MissionStore store;
    EXPECT_EQ(open(store), Status::ok);
    EXPECT_EQ(store.count(), 0);
}

TEST_F(MissionStoreTest, what_was_committed_is_there_after_a_restart_with_its_set) {
    const Mission wanted = mission(171, 1);
    MissionStore writer;
    ASSERT_EQ(open(writer), Status::ok);
    ASSERT_EQ(upload(writer, wanted, 1), Status::ok);

    MissionStore reader;
    ASSERT_EQ(open(reader), Status::ok);

    EXPECT_EQ(reader.set(), 1);
    EXPECT_EQ(stored(reader), wanted);
}

TEST_F(MissionStoreTest, a_mission_one_too_long_is_refused_before_anything_is_written) {
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);

    EXPECT_EQ(store.begin(172, 2), Status::full);
    EXPECT_EQ(fakes::eepromWrites(), 0u);
}

TEST_F(MissionStoreTest, a_mission_that_does_not_fit_beside_the_present_one_needs_a_clear_first) {
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    ASSERT_EQ(upload(store, mission(100, 1)), Status::ok);
    EXPECT_EQ(store.begin(72, 2), Status::full);
    EXPECT_EQ(store.begin(71, 2), Status::ok);
    store.abort();

    ASSERT_EQ(upload(store, Mission()), Status::ok);

    EXPECT_EQ(store.count(), 0);
    EXPECT_EQ(upload(store, mission(171, 2)), Status::ok);
}

TEST_F(MissionStoreTest, a_full_mission_touches_neither_parameters_nor_fence) {
    for (uint16_t at = 0; at < hal::kEepromSize; ++at) {
        const bool missions = at >= storage::kMissionHead.begin && at < storage::kMission.end();
        const bool heads = at >= storage::kFenceHead.begin && at < storage::kRallyHead.end();
        fakes::setEepromCell(at, missions || heads ? 0xFF : 0xA5);
    }
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    ASSERT_EQ(upload(store, mission(171, 3)), Status::ok);

    for (uint16_t at = 0; at < hal::kEepromSize; ++at) {
        if (at >= storage::kMissionHead.begin && at < storage::kMission.end()) continue;
        if (at >= storage::kFenceHead.begin && at < storage::kRallyHead.end()) continue;
        ASSERT_EQ(fakes::eepromCell(at), 0xA5) << at;
    }
}

TEST_F(MissionStoreTest, an_aborted_upload_leaves_the_old_mission) {
    const Mission old_mission = mission(20, 1), new_mission = mission(30, 2);
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    ASSERT_EQ(upload(store, old_mission), Status::ok);
    ASSERT_EQ(store.begin(30, 2), Status::ok);
    for (int i = 0; i < 29; ++i) ASSERT_EQ(store.put(new_mission[i].data()), Status::ok);

    EXPECT_EQ(store.commit(), Status::bad_argument);
    store.abort();

    EXPECT_EQ(stored(store), old_mission);
    MissionStore again;
    ASSERT_EQ(open(again), Status::ok);
    EXPECT_EQ(stored(again), old_mission);
}

TEST_F(MissionStoreTest, the_old_mission_can_be_read_until_the_next_upload_begins) {
    const Mission old_mission = mission(4, 1);
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    ASSERT_EQ(upload(store, old_mission, 1), Status::ok);
    ASSERT_EQ(upload(store, mission(6, 2), 2), Status::ok);

    Record record;
    EXPECT_EQ(store.previousCount(), 4);
    EXPECT_EQ(store.previousSet(), 1);
    for (uint8_t i = 0; i < 4; ++i) {
        ASSERT_EQ(store.readPrevious(i, record.data()), Status::ok);
        EXPECT_EQ(record, old_mission[i]);
    }
}

TEST_F(MissionStoreTest, a_record_read_ahead_is_there_while_the_eeprom_is_busy) {
    const Mission wanted = mission(6, 1);
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    ASSERT_EQ(upload(store, wanted), Status::ok);
    store.readAhead(3);
    fakes::setEepromSlow(true);
    const uint8_t other[] = {1, 2, 3, 4};
    ASSERT_EQ(hal::eepromWrite(storage::kFence.begin, other, 4), Status::ok);

    Record record;
    EXPECT_EQ(store.read(0, record.data()), Status::busy);
    EXPECT_EQ(store.read(3, record.data()), Status::ok);
    EXPECT_EQ(record, wanted[3]);
    EXPECT_EQ(store.read(4, record.data()), Status::ok);
    EXPECT_EQ(record, wanted[4]);
}

TEST_F(MissionStoreTest, what_was_read_ahead_is_forgotten_when_the_mission_changes) {
    const Mission new_mission = mission(6, 2);
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    ASSERT_EQ(upload(store, mission(6, 1)), Status::ok);
    store.readAhead(1);
    ASSERT_EQ(upload(store, new_mission), Status::ok);

    EXPECT_EQ(stored(store), new_mission);
}

TEST_F(MissionStoreTest, corrupt_records_are_noticed_and_the_mission_is_empty) {
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    ASSERT_EQ(upload(store, mission(6, 1)), Status::ok);
    const uint16_t at = storage::recordAddress(2) + 5;
    fakes::setEepromCell(at, fakes::eepromCell(at) ^ 0x10);

    MissionStore reader;
    EXPECT_EQ(open(reader), Status::corrupt);
    EXPECT_EQ(reader.count(), 0);
    EXPECT_EQ(upload(reader, mission(6, 2)), Status::ok);
    MissionStore again;
    EXPECT_EQ(open(again), Status::ok);
    EXPECT_EQ(stored(again), mission(6, 2));
}

TEST_F(MissionStoreTest, uploading_the_same_mission_again_to_the_same_place_writes_only_the_head) {
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    const Mission same(57, mission(1, 9)[0]);  // three places of 57 fill the ring
    for (int i = 0; i < 3; ++i) ASSERT_EQ(upload(store, same), Status::ok);
    const uint32_t before = fakes::eepromWrites();

    ASSERT_EQ(upload(store, same), Status::ok);

    EXPECT_LE(fakes::eepromWrites() - before, storage::kHeadSize);
}

TEST_F(MissionStoreTest, the_number_of_a_commit_may_wrap) {
    storage::Extent last = {};
    last.set = 2;
    last.crc = core::kCrcStart;
    for (last.sequence = 65500; last.sequence < 65502; ++last.sequence)
        ASSERT_EQ(storage::writeHead(ListKind::mission, last), Status::ok);
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    for (uint8_t i = 0; i < 60; ++i) {  // of two heads each
        const Mission wanted = mission(1, i);
        ASSERT_EQ(upload(store, wanted), Status::ok);
        MissionStore reader;
        ASSERT_EQ(open(reader), Status::ok);
        ASSERT_EQ(stored(reader), wanted) << i;
    }
    storage::Head head;
    ASSERT_EQ(storage::readHead(ListKind::mission, 0, head), Status::ok);
    EXPECT_LT(head.extent.sequence, 100) << "it has wrapped";
}

TEST_F(MissionStoreTest, the_last_of_65600_heads_counts) {
    fakes::setEepromSlow(false);
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    for (uint32_t i = 0; i < 65600 / 2; ++i) {  // a commit writes two
        const Mission wanted = mission(1, static_cast<uint8_t>(i));
        ASSERT_EQ(upload(store, wanted), Status::ok);
        if (i % 64 != 0 && i < 32700) continue;
        MissionStore reader;
        ASSERT_EQ(open(reader), Status::ok);
        ASSERT_EQ(stored(reader), wanted) << i;
    }
}

TEST_F(MissionStoreTest, an_upload_through_the_slow_queue_arrives_whole) {
    fakes::setEepromSlow(true);
    const Mission wanted = mission(60, 7);
    MissionStore store;
    ASSERT_EQ(open(store), Status::ok);
    ASSERT_EQ(upload(store, wanted), Status::ok);
    EXPECT_TRUE(hal::eepromDrained());

    fakes::restartEeprom();
    MissionStore reader;
    ASSERT_EQ(open(reader), Status::ok);
    EXPECT_EQ(stored(reader), wanted);
}

}  // namespace

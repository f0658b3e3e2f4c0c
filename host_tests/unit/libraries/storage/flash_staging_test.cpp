// SPDX-License-Identifier: GPL-3.0-or-later
// Lists staged in the DataFlash and copied to the EEPROM after that.
#include "rig.hpp"

namespace {

class FlashStaging : public testing::Test {
protected:
    void SetUp() override {
        fakes::reset();
        fakes::fitPageFlash();
        ASSERT_EQ(open(store), Status::ok);
    }
    static Mission afterRestart() {
        restart();
        MissionStore reader;
        EXPECT_EQ(open(reader), Status::ok);
        return stored(reader);
    }
    uint32_t writesOf(const Mission& wanted) {
        const uint32_t before = fakes::eepromWrites();
        EXPECT_EQ(upload(store, wanted), Status::ok);
        EXPECT_EQ(migrateToEeprom(store), Status::ok);
        return fakes::eepromWrites() - before;
    }

    MissionStore store;
};

TEST_F(FlashStaging, a_full_mission_fits_beside_a_full_one) {
    ASSERT_EQ(upload(store, mission(171, 1)), Status::ok);
    ASSERT_EQ(upload(store, mission(171, 2)), Status::ok);
    EXPECT_EQ(stored(store), mission(171, 2));
    EXPECT_EQ(store.begin(172, 2), Status::full);
}

TEST_F(FlashStaging, what_was_committed_is_there_before_it_is_copied_and_after) {
    const Mission wanted = mission(80, 1);
    ASSERT_EQ(upload(store, wanted), Status::ok);
    EXPECT_EQ(afterRestart(), wanted);
    EXPECT_EQ(migrateToEeprom(store), Status::ok);
    fakes::removePageFlash();
    EXPECT_EQ(afterRestart(), wanted) << "at home in the EEPROM";
}

TEST_F(FlashStaging, the_same_mission_again_writes_its_heads_and_nothing_else) {
    const Mission same = mission(160, 1);
    EXPECT_GT(writesOf(same), 160u * storage::kRecordSize / 2);
    EXPECT_LE(writesOf(same), 2u * storage::kHeadSize);
    EXPECT_LE(writesOf(same), 2u * storage::kHeadSize);
}

TEST_F(FlashStaging, only_bytes_that_differ_are_written) {
    Mission changed = mission(160, 1);
    ASSERT_GT(writesOf(changed), 0u);
    changed[77][9] ^= 0x40;
    changed[140][2] ^= 0x01;
    EXPECT_LE(writesOf(changed), 2u + 2u * storage::kHeadSize);
}

TEST_F(FlashStaging, an_upload_touches_neither_the_eeprom_nor_the_present_area_until_its_commit) {
    ASSERT_EQ(upload(store, mission(100, 1)), Status::ok);
    const auto cells = fakes::eepromCells();
    const auto before = fakes::flashPages();
    ASSERT_EQ(store.begin(171, 2), Status::ok);
    for (const Record& record : mission(171, 2))
        ASSERT_EQ(whileBusy([&] { return store.put(record.data()); }), Status::ok);
    EXPECT_EQ(fakes::eepromCells(), cells);
    const auto after = fakes::flashPages();
    for (size_t page = 0; page < 3; ++page) EXPECT_EQ(after[page], before[page]);
    store.abort();
    EXPECT_EQ(stored(store), mission(100, 1));
    EXPECT_EQ(afterRestart(), mission(100, 1));
}

TEST_F(FlashStaging, an_upload_may_begin_in_the_middle_of_the_copying) {
    fakes::setEepromSlow(true);
    fakes::setPageFlashSlow(true);
    ASSERT_EQ(upload(store, mission(90, 1)), Status::ok);
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(store.migrateToEeprom(), Status::busy);
        fakes::advance_ms(10);
    }
    ASSERT_EQ(upload(store, mission(70, 2)), Status::ok);
    EXPECT_EQ(stored(store), mission(70, 2));
    EXPECT_EQ(migrateToEeprom(store), Status::ok);
    EXPECT_EQ(stored(store), mission(70, 2));
    EXPECT_EQ(afterRestart(), mission(70, 2));
}

TEST_F(FlashStaging, an_aborted_upload_does_not_keep_the_copying_from_its_end) {
    ASSERT_EQ(upload(store, mission(90, 1)), Status::ok);
    ASSERT_EQ(store.begin(5, 2), Status::ok);
    EXPECT_EQ(store.migrateToEeprom(), Status::busy);
    store.abort();
    EXPECT_EQ(migrateToEeprom(store), Status::ok);
    fakes::removePageFlash();
    EXPECT_EQ(afterRestart(), mission(90, 1));
}

TEST_F(FlashStaging, a_commit_has_another_generation_and_the_copying_has_not) {
    ASSERT_EQ(upload(store, mission(5, 1)), Status::ok);
    const uint8_t first = store.generation();
    ASSERT_EQ(migrateToEeprom(store), Status::ok);
    EXPECT_EQ(store.generation(), first);
    restart();
    MissionStore reader;
    ASSERT_EQ(open(reader), Status::ok);
    EXPECT_EQ(reader.generation(), first);
    ASSERT_EQ(upload(reader, mission(5, 1)), Status::ok);
    EXPECT_NE(reader.generation(), first);
}

TEST_F(FlashStaging, a_mission_in_a_lost_chip_is_reported_and_returns_with_the_chip) {
    const Mission wanted = mission(80, 1);
    ASSERT_EQ(upload(store, mission(20, 3)), Status::ok);
    ASSERT_EQ(migrateToEeprom(store), Status::ok);
    ASSERT_EQ(upload(store, wanted), Status::ok);
    const auto cells = fakes::eepromCells();
    fakes::removePageFlash();
    restart();

    MissionStore without;
    ListKind which = ListKind::rally;
    EXPECT_EQ(whileBusy([&] { return without.open(which); }), Status::unsupported);
    EXPECT_EQ(which, ListKind::mission);
    EXPECT_EQ(open(without), Status::ok) << "of the other lists";
    EXPECT_EQ(without.count(), 0) << "not the mission before: that was replaced";
    EXPECT_EQ(migrateToEeprom(without), Status::ok);
    EXPECT_EQ(fakes::eepromCells(), cells);

    const auto pages = fakes::flashPages();
    fakes::fitPageFlash();
    fakes::setFlashPages(pages);
    EXPECT_EQ(afterRestart(), wanted);
}

TEST_F(FlashStaging, a_mission_in_a_corrupt_page_is_reported_and_nothing_is_erased) {
    ASSERT_EQ(upload(store, mission(80, 1)), Status::ok);
    fakes::damagePage(1);
    const auto cells = fakes::eepromCells();
    restart();
    MissionStore reader;
    EXPECT_EQ(open(reader), Status::corrupt);
    EXPECT_EQ(reader.count(), 0);
    EXPECT_EQ(migrateToEeprom(reader), Status::ok);
    EXPECT_EQ(fakes::eepromCells(), cells);
    ASSERT_EQ(upload(reader, mission(30, 2)), Status::ok);
    EXPECT_EQ(afterRestart(), mission(30, 2));
}

TEST_F(FlashStaging, records_corrupt_in_the_eeprom_are_read_from_the_dataflash) {
    ASSERT_EQ(upload(store, mission(80, 1)), Status::ok);
    ASSERT_EQ(migrateToEeprom(store), Status::ok);
    const uint16_t at = storage::recordAddress(50);
    fakes::setEepromCell(at, fakes::eepromCell(at) ^ 0x20);
    restart();
    MissionStore reader;
    EXPECT_EQ(open(reader), Status::ok);
    EXPECT_EQ(stored(reader), mission(80, 1));
    EXPECT_EQ(migrateToEeprom(reader), Status::ok);
    fakes::removePageFlash();
    EXPECT_EQ(afterRestart(), mission(80, 1)) << "and are mended";
}

TEST_F(FlashStaging, a_chip_that_does_not_keep_what_is_written_is_not_used_again) {
    ASSERT_EQ(upload(store, mission(60, 1)), Status::ok);
    ASSERT_EQ(migrateToEeprom(store), Status::ok);
    ASSERT_EQ(store.begin(80, 2), Status::ok);
    for (const Record& record : mission(80, 2)) {
        ASSERT_EQ(whileBusy([&] { return store.put(record.data()); }), Status::ok);
        if (store.staged() == 73)
            for (uint16_t page = 0; page < 16; ++page) fakes::damagePage(page);
    }
    EXPECT_EQ(whileBusy([&] { return store.commit(); }), Status::corrupt);
    EXPECT_EQ(stored(store), mission(60, 1));
    EXPECT_FALSE(store.flashWorks());
    EXPECT_EQ(upload(store, mission(112, 3)), Status::full) << "beside the present one";
    EXPECT_EQ(upload(store, mission(111, 3)), Status::ok);
    fakes::removePageFlash();
    EXPECT_EQ(afterRestart(), mission(111, 3));
}

TEST_F(FlashStaging, an_eeprom_that_does_not_keep_the_copy_is_reported_once) {
    const Mission wanted = mission(10, 1);
    ASSERT_EQ(upload(store, wanted), Status::ok);
    for (int i = 0; i < 3; ++i) ASSERT_EQ(store.migrateToEeprom(), Status::busy);
    fakes::setEepromCell(storage::recordAddress(0), 0x55);
    EXPECT_EQ(migrateToEeprom(store), Status::corrupt);
    EXPECT_EQ(migrateToEeprom(store), Status::ok);
    EXPECT_EQ(stored(store), wanted);
    EXPECT_EQ(afterRestart(), wanted);
}

TEST_F(FlashStaging, while_the_log_has_the_chip_the_mission_wants_it) {
    ASSERT_EQ(store.begin(60, 2), Status::ok);
    const Mission wanted = mission(60, 1);
    fakes::holdPageFlashBusy(true);
    for (int i = 0; i < 36; ++i) ASSERT_EQ(store.put(wanted[i].data()), Status::ok);
    EXPECT_EQ(store.put(wanted[36].data()), Status::busy);
    EXPECT_TRUE(fakes::missionWantsPageFlash());
    fakes::holdPageFlashBusy(false);
    for (int i = 36; i < 60; ++i)
        ASSERT_EQ(whileBusy([&] { return store.put(wanted[i].data()); }), Status::ok);
    EXPECT_FALSE(fakes::missionWantsPageFlash());
    EXPECT_EQ(whileBusy([&] { return store.commit(); }), Status::ok);
    EXPECT_EQ(stored(store), wanted);
}

TEST_F(FlashStaging, an_upload_given_up_leaves_the_chip_to_the_log) {
    ASSERT_EQ(store.begin(60, 2), Status::ok);
    fakes::holdPageFlashBusy(true);
    for (int i = 0; i < 36; ++i) ASSERT_EQ(store.put(mission(1, 1)[0].data()), Status::ok);
    ASSERT_EQ(store.put(mission(1, 1)[0].data()), Status::busy);
    store.abort();
    EXPECT_FALSE(fakes::missionWantsPageFlash());
}

TEST_F(FlashStaging, a_chip_not_yet_identified_is_waited_for) {
    ASSERT_EQ(upload(store, mission(80, 1)), Status::ok);
    restart();
    fakes::setPageFlashKnown(false);
    MissionStore reader;
    ListKind which;
    for (int i = 0; i < 50; ++i) ASSERT_EQ(reader.open(which), Status::busy);
    fakes::setPageFlashKnown(true);
    EXPECT_EQ(open(reader), Status::ok);
    EXPECT_EQ(stored(reader), mission(80, 1));
}

TEST_F(FlashStaging, the_lists_do_not_touch_one_another) {
    ASSERT_EQ(upload(store, mission(171, 1)), Status::ok);
    ASSERT_EQ(upload(store, records(ListKind::fence, 20, 2), 1, ListKind::fence), Status::ok);
    ASSERT_EQ(upload(store, records(ListKind::rally, 10, 3), 1, ListKind::rally), Status::ok);
    ASSERT_EQ(upload(store, mission(171, 4)), Status::ok);
    for (int boot = 0; boot < 2; ++boot) {
        MissionStore reader;
        ASSERT_EQ(open(reader), Status::ok);
        EXPECT_EQ(stored(reader), mission(171, 4));
        EXPECT_EQ(stored(reader, ListKind::fence), records(ListKind::fence, 20, 2));
        EXPECT_EQ(stored(reader, ListKind::rally), records(ListKind::rally, 10, 3));
        ASSERT_EQ(migrateToEeprom(reader), Status::ok);
        fakes::removePageFlash();
    }
}

// The first cut comes while the copy is made, the second while it is made again.
TEST_F(FlashStaging, a_cut_while_the_copying_is_done_again_changes_nothing) {
    const Mission wanted = mission(60, 2);
    ASSERT_EQ(upload(store, mission(50, 1)), Status::ok);
    ASSERT_EQ(migrateToEeprom(store), Status::ok);
    ASSERT_EQ(upload(store, wanted), Status::ok);
    const auto pages = fakes::flashPages();
    const auto cells = fakes::eepromCells();
    int cuts = 0;
    for (uint32_t first : {1, 20, 300, 700, 838}) {
        for (uint32_t second = 0; second < 850; second += 3, ++cuts) {
            fakes::setFlashPages(pages);
            fakes::setEepromCells(cells);
            for (uint32_t at : {first, second}) {
                MissionStore writer;
                ASSERT_EQ(open(writer), Status::ok);
                fakes::cutPowerAfter(at);
                (void)migrateToEeprom(writer);
                restart();
            }
            MissionStore reader;
            ASSERT_EQ(open(reader), Status::ok) << first << ", " << second;
            ASSERT_EQ(stored(reader), wanted) << first << ", " << second;
        }
    }
    printf("%d pairs of power cuts survived\n", cuts);
}

}  // namespace

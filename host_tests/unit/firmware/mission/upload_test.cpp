// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission_rig.hpp"
#include "storage/owner.hpp"

namespace firmware {
namespace {

class Upload : public Rig {};

Items many(int count) {
    Items items;
    for (int i = 0; i < count; ++i) items.push_back(waypoint(100 * (i + 1)));
    return items;
}

TEST_F(Upload, a_mission_over_capacity_is_answered_no_space_before_anything_is_written) {
    const uint32_t before = fakes::eepromWrites();
    EXPECT_EQ(missionBeginUpload(172), MissionResult::no_space);
    EXPECT_EQ(missionBeginUpload(65535), MissionResult::no_space);
    EXPECT_EQ(fakes::eepromWrites(), before);
}

TEST_F(Upload, home_and_170_commands_fit_and_read_back) {
    ASSERT_EQ(upload(many(170)), MissionResult::accepted);
    EXPECT_EQ(missionCount(), 171);
    for (int i = 1; i <= 170; ++i) EXPECT_EQ(stored(static_cast<uint16_t>(i)), waypoint(100 * i));
}

TEST_F(Upload, a_mission_that_does_not_fit_beside_the_present_one_is_refused_with_the_reason) {
    ASSERT_EQ(upload(many(100)), MissionResult::accepted);
    (void)statusTexts();
    EXPECT_EQ(upload(many(100)), MissionResult::no_space);
    EXPECT_TRUE(hasStatusText("DataFlash does not work: clear the old one first"));
    EXPECT_EQ(missionCount(), 101);
    EXPECT_EQ(whileBusy(missionClear), MissionResult::accepted);
    EXPECT_EQ(missionCount(), 0);
    EXPECT_EQ(upload(many(100)), MissionResult::accepted);
}

TEST_F(Upload, until_the_last_item_is_stored_the_old_mission_is_the_mission) {
    ASSERT_EQ(upload(many(3)), MissionResult::accepted);
    ASSERT_EQ(missionBeginUpload(3), MissionResult::accepted);
    for (uint16_t i = 0; i < 2; ++i) {
        ASSERT_EQ(missionUploadItem(i, waypoint(9000)), MissionResult::accepted);
        EXPECT_EQ(missionCount(), 4);
        EXPECT_EQ(stored(1), waypoint(100));
    }
    EXPECT_EQ(missionCommit(), MissionResult::invalid_sequence);
    missionAbort();
    EXPECT_EQ(missionCount(), 4);
    EXPECT_EQ(stored(1), waypoint(100));
}

TEST_F(Upload, a_refused_item_leaves_the_old_mission) {
    ASSERT_EQ(upload(many(3)), MissionResult::accepted);
    EXPECT_EQ(upload({waypoint(1), command(181, 0, 9)}), static_cast<MissionResult>(7));
    missionAbort();
    EXPECT_EQ(missionCount(), 4);
}

TEST_F(Upload, items_out_of_order_are_refused) {
    ASSERT_EQ(whileBusy([] { return missionBeginUpload(3); }), MissionResult::accepted);
    EXPECT_EQ(missionUploadItem(1, waypoint(1)), MissionResult::invalid_sequence);
    EXPECT_EQ(missionUploadItem(3, waypoint(1)), MissionResult::invalid_sequence);
    EXPECT_EQ(missionUploadItem(0, waypoint(1)), MissionResult::accepted);
    EXPECT_EQ(missionUploadItem(0, waypoint(1)), MissionResult::invalid_sequence);
}

TEST_F(Upload, a_part_of_the_mission_can_be_replaced) {
    ASSERT_EQ(upload(many(30)), MissionResult::accepted);
    ASSERT_EQ(uploadPartial(3, {waypoint(7000), waypoint(8000)}), MissionResult::accepted);
    EXPECT_EQ(missionCount(), 31);
    EXPECT_EQ(stored(2), waypoint(200));
    EXPECT_EQ(stored(3), waypoint(7000));
    EXPECT_EQ(stored(4), waypoint(8000));
    EXPECT_EQ(stored(5), waypoint(500));
    EXPECT_EQ(stored(30), waypoint(3000));
    EXPECT_EQ(uploadPartial(30, {waypoint(1)}), MissionResult::accepted);
    EXPECT_EQ(uploadPartial(0, {waypoint(2)}), MissionResult::accepted);
    EXPECT_EQ(missionBeginPartial(30, 31), MissionResult::invalid_sequence);
    EXPECT_EQ(missionBeginPartial(5, 4), MissionResult::invalid_sequence);
}

TEST_F(Upload, a_partial_write_in_the_other_set_is_refused) {
    ASSERT_EQ(upload(many(3)), MissionResult::accepted);
    parameters.mission_set = 1;
    EXPECT_EQ(missionBeginPartial(1, 2), MissionResult::denied);
}

TEST_F(Upload, the_set_stored_is_the_one_of_the_upload_and_download_speaks_it) {
    parameters.mission_set = 1;
    ASSERT_EQ(upload({waypoint(100), command(0x20, 5)}), MissionResult::accepted);
    parameters.mission_set = 2;
    EXPECT_EQ(stored(2), command(0x20, 5));
    missionBoot();
    EXPECT_EQ(missionSet(), ::mission::Set::apm1);
    EXPECT_EQ(stored(2), command(0x20, 5));
}

TEST_F(Upload, a_sixteenth_counted_jump_is_refused_with_no_space) {
    Items items = {waypoint(1)};
    for (int i = 0; i < 15; ++i) items.push_back(command(177, 1, 2));
    for (int i = 0; i < 5; ++i) items.push_back(command(177, 1, -1));
    items.push_back(waypoint(2));
    EXPECT_EQ(upload(items), MissionResult::accepted);
    items.insert(items.begin() + 1, command(177, 2, 2));
    items[1].param1 = 1;
    EXPECT_EQ(upload(items), MissionResult::no_space);
    EXPECT_EQ(missionCount(), 23);
}

TEST_F(Upload, commands_that_will_not_run_are_warned_about) {
    (void)statusTexts();
    ASSERT_EQ(upload({waypoint(1), command(181, 0, 1)}), MissionResult::accepted);
    EXPECT_TRUE(hasStatusText("nothing after item 1"));
    ASSERT_EQ(upload({waypoint(1), command(181, 0, 1), command(177, 1, 3)}),
              MissionResult::accepted);
    EXPECT_FALSE(hasStatusText("nothing after")) << "the jump closes a loop";
    ASSERT_EQ(upload({waypoint(1), command(177, 1, 3), command(181, 0, 1)}),
              MissionResult::accepted);
    EXPECT_TRUE(hasStatusText("nothing after item 2"));
    parameters.mission_trailing = 1;
    ASSERT_EQ(upload({waypoint(1), command(181, 0, 1)}), MissionResult::accepted);
    EXPECT_FALSE(hasStatusText("nothing after"));
    ASSERT_EQ(upload({command(181, 0, 1)}), MissionResult::accepted);
    EXPECT_TRUE(hasStatusText("no NAV"));
    parameters.mission_set = 1;
    ASSERT_EQ(upload({command(0x81, 1), waypoint(1)}), MissionResult::accepted);
    EXPECT_TRUE(hasStatusText("nothing before item 2"));
}

TEST_F(Upload, a_mission_is_there_after_a_restart_and_a_cut_leaves_the_old_one) {
    ASSERT_EQ(upload(many(5)), MissionResult::accepted);
    fakes::cutPowerAfter(40);
    ASSERT_EQ(upload(many(20)), MissionResult::accepted) << "the program does not notice";
    fakes::restartEeprom();
    missionBoot();
    EXPECT_EQ(missionCount(), 6);
    EXPECT_EQ(stored(5), waypoint(500));
}

TEST_F(Upload, works_through_the_slow_eeprom_too) {
    fakes::setEepromSlow(true);
    ASSERT_EQ(upload(many(40)), MissionResult::accepted);
    EXPECT_TRUE(hal::eepromDrained());
    EXPECT_EQ(missionCount(), 41);
}

TEST_F(Upload, an_eeprom_of_other_firmware_is_left_alone) {
    fakes::resetEeprom();
    fakes::setEepromCell(0, 0x41);
    fakes::setEepromCell(1, 0x50);
    const auto before = fakes::eepromCells();
    (void)statusTexts();
    missionBoot();
    EXPECT_TRUE(hasStatusText("other firmware"));
    EXPECT_EQ(missionBeginUpload(2), MissionResult::denied);
    EXPECT_EQ(missionClear(), MissionResult::denied);
    pass(20);
    EXPECT_EQ(fakes::eepromCells(), before);
}

}  // namespace
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// Missions that are left, gone back to, ended and changed in flight.
#include "mission_flight.hpp"

#include "firmware/mission/handlers.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace firmware {
using namespace mission;
namespace {

TEST_F(MissionFlight, a_watchdog_reset_in_the_air_resumes_where_it_was) {
    fly({waypoint(500), command(177, 1, 1), command(112, 5), command(181, 0, 1), waypoint(900)});
    reach();
    reach();
    EXPECT_EQ(missionCurrent(), 5);
    pass(3);
    fakes::watchdog().last_run.ended = hal::ResetCause::watchdog;
    relaySet(false);
    missionBoot();
    requestMode(Mode::loiter, ModeReason::boot);
    EXPECT_EQ(missionCurrent(), 5);
    enterAuto();
    EXPECT_FALSE(relayGet());
    seconds(6);
    EXPECT_TRUE(relayGet()) << "the chain goes on where it stood";
}

TEST_F(MissionFlight, after_a_power_loss_the_index_is_left_and_the_chain_is_not_run_again) {
    fly({waypoint(500), command(181, 0, 1), waypoint(900), waypoint(1500)});
    reach();
    EXPECT_TRUE(relayGet());
    pass(5);
    relaySet(false);
    fakes::restartEeprom();
    mission_engine.leave();
    missionBoot();
    requestMode(Mode::loiter, ModeReason::boot);
    EXPECT_EQ(missionCurrent(), 3);
    enterAuto();
    EXPECT_EQ(missionCurrent(), 3);
    pass(5);
    EXPECT_FALSE(relayGet());
}

TEST_F(MissionFlight, mis_restart_begins_at_the_first) {
    fly({waypoint(500), waypoint(900)});
    reach();
    parameters.mission_restart = 1;
    requestMode(Mode::loiter, ModeReason::pilot);
    enterAuto();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(MissionFlight, a_resumed_leg_begins_at_the_airplane) {
    fly({waypoint(500), waypoint(900)});
    reach();
    EXPECT_NE(vehicle.demand.from, vehicle.estimate.position);
    requestMode(Mode::loiter, ModeReason::pilot);
    mutable_vehicle.estimate.position.longitude_e7 += 4000;
    enterAuto();
    EXPECT_EQ(vehicle.demand.from, vehicle.estimate.position);
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, an_upload_elsewhere_in_the_mission_does_not_disturb_the_flight) {
    fly({waypoint(500), command(112, 5), waypoint(900), waypoint(1500)});
    reach();
    const geo::Position from = vehicle.demand.from;
    pass(20);
    ASSERT_EQ(upload({waypoint(500), command(112, 5), waypoint(900), waypoint(7000), waypoint(1)}),
              MissionResult::accepted);
    EXPECT_EQ(missionCurrent(), 3);
    EXPECT_EQ(vehicle.demand.from, from);
    EXPECT_FALSE(vehicle.demand.new_path);
    reach();
    expectTo(waypoint(7000));
}

TEST_F(MissionFlight, the_flight_goes_on_while_an_upload_keeps_the_eeprom_busy) {
    Items items = {waypoint(500)};
    for (int i = 0; i < 10; ++i) items.push_back(command(181, 0, 1 - i % 2));
    items.push_back(command(181, 0, 1));
    items.push_back(waypoint(900));
    fly(items);
    fakes::setEepromSlow(true);
    ASSERT_EQ(missionBeginUpload(60), MissionResult::accepted);
    uint16_t next = 0;
    const auto uploadOn = [&] {
        while (next < 60 && missionUploadItem(next, waypoint(7 * next)) == MissionResult::accepted)
            ++next;
    };
    uploadOn();
    reach();
    EXPECT_NE(missionCurrent(), 2);
    int tenths = 0;
    while (vehicle.demand.to.latitude_e7 != waypoint(900).x && tenths < 30) {
        uploadOn();
        pass();
        ++tenths;
    }
    EXPECT_LT(tenths, 20) << "eleven commands and a NAV behind a busy EEPROM";
    EXPECT_LT(next, 60) << "the upload was under way all the time";
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_change_of_the_nav_or_its_chain_restarts_the_mission) {
    const Items base = {waypoint(500), command(112, 5), waypoint(900), waypoint(1500)};
    for (int changed : {1, 2}) {
        requestMode(Mode::loiter, ModeReason::pilot);
        missionSetCurrent(0);
        fly(base);
        reach();
        EXPECT_EQ(missionCurrent(), 3);
        Items other = base;
        if (changed == 1) other[1] = command(112, 6);
        if (changed == 2) other[2] = waypoint(901);
        ASSERT_EQ(upload(other), MissionResult::accepted);
        pass();
        EXPECT_EQ(missionCurrent(), 1) << changed;
    }
}

TEST_F(MissionFlight, in_apm1_the_chain_is_what_follows_the_nav) {
    parameters.mission_set = 1;
    const Items base = {waypoint(500),    command(0x20, 5), waypoint(900),
                        command(0x20, 9), command(0x81, 1), waypoint(1500)};
    fly(base);
    reach();
    EXPECT_EQ(missionCurrent(), 3);
    Items other = base;
    other[1] = command(0x20, 50);
    other[5] = waypoint(1600);
    ASSERT_EQ(upload(other), MissionResult::accepted);
    pass();
    EXPECT_EQ(missionCurrent(), 3) << "neither is in flight";
    other[4] = command(0x81, 0);
    ASSERT_EQ(upload(other), MissionResult::accepted);
    pass();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(MissionFlight,
       in_apm1_a_waypoint_appended_behind_the_last_chain_does_not_disturb_the_flight) {
    parameters.mission_set = 1;
    const Items base = {waypoint(500), waypoint(900), command(0x20, 9), command(0x81, 1)};
    Items longer = base;
    longer.push_back(waypoint(1500));
    fly(base);
    reach();
    pass(20);
    ASSERT_EQ(upload(longer), MissionResult::accepted);
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    EXPECT_FALSE(vehicle.demand.new_path);
    ASSERT_EQ(upload(base), MissionResult::accepted) << "and taken away again";
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    longer[4] = command(0x81, 0);
    ASSERT_EQ(upload(longer), MissionResult::accepted) << "the chain itself is longer";
    pass();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(MissionFlight, a_nav_out_of_range_does_not_end_a_chain) {
    parameters.mission_set = 1;
    const ::mission::Record beyond_the_pole = {16, 0, 0, 5000, 910000000, 80000000};
    storeImage(1, {{16, 0, 0, 0, 0, 0},
                   {16, 0, 0, 5000, waypoint(500).x, waypoint(500).y},
                   beyond_the_pole,
                   {0x81, 0, 1, 0, 0, 0},
                   {16, 0, 0, 5000, waypoint(1900).x, waypoint(1900).y}});
    ASSERT_TRUE(enterAuto());
    EXPECT_TRUE(relayGet());
    relaySet(false);
    ASSERT_EQ(upload({waypoint(500), waypoint(900), command(0x81, 1), waypoint(1900)}),
              MissionResult::accepted);
    pass();
    EXPECT_TRUE(vehicle.demand.from_height_m == vehicle.estimate.height_m);
    EXPECT_FALSE(relayGet()) << "it belongs to the second waypoint now";
    mutable_vehicle.estimate.height_m = 51;
    reach();
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_clear_in_auto_enters_rtl_and_is_reported) {
    fly({waypoint(500), waypoint(900)});
    (void)statusTexts();
    ASSERT_EQ(whileBusy(missionClear), MissionResult::accepted);
    pass();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_TRUE(hasStatusText("Mission complete"));
    EXPECT_EQ(missionCount(), 0);
}

TEST_F(MissionFlight, a_new_mission_outside_auto_begins_at_its_first) {
    fly({waypoint(500), waypoint(900)});
    reach();
    requestMode(Mode::loiter, ModeReason::pilot);
    ASSERT_EQ(upload({waypoint(500), waypoint(900)}), MissionResult::accepted);
    enterAuto();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(MissionFlight, set_current_outside_auto_sets_where_auto_begins) {
    ASSERT_EQ(upload({waypoint(500), waypoint(900)}), MissionResult::accepted);
    EXPECT_TRUE(missionSetCurrent(2));
    EXPECT_EQ(missionCurrent(), 2);
    EXPECT_FALSE(missionSetCurrent(3));
    EXPECT_FALSE(missionSetCurrent(300));
    enterAuto();
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, no_item_can_be_chosen_in_a_mission_without_a_nav) {
    ASSERT_EQ(upload({command(181, 0, 1), command(112, 5)}), MissionResult::accepted);
    for (uint16_t item : {0, 1, 2}) EXPECT_FALSE(missionSetCurrent(item)) << item;
    EXPECT_EQ(missionCurrent(), 0);
}

TEST_F(MissionFlight, trailing_commands_circle_the_last_place_at_its_altitude) {
    parameters.mission_trailing = 1;
    fly({waypoint(500, 66), command(112, 5), command(181, 0, 1)});
    reach();
    EXPECT_EQ(vehicle.demand.path, Path::circle);
    expectTo(waypoint(500, 66));
    seconds(4);
    EXPECT_EQ(vehicle.mode, Mode::automatic);
    requestMode(Mode::loiter, ModeReason::pilot);
    pass();
    enterAuto();
    expectTo(waypoint(500, 66));
    seconds(6);
    EXPECT_TRUE(relayGet());
    EXPECT_EQ(vehicle.mode, Mode::rtl);
}

TEST_F(MissionFlight, a_trailing_distance_is_measured_to_the_last_navs_place) {
    parameters.mission_trailing = 1;
    fly({waypoint(500), command(114, 200), command(181, 0, 1)});
    reach();
    mutable_vehicle.progress.distance_m = 201;
    pass();
    EXPECT_FALSE(relayGet());
    EXPECT_EQ(vehicle.demand.to.latitude_e7, waypoint(500).x);
    mutable_vehicle.progress.distance_m = 199;
    pass();
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_record_out_of_range_in_an_image_is_skipped_reported_and_counted) {
    const uint16_t before = missionSkipped();
    storeImage(2, {{16, 1, 0, 0, 0, 0},
                   {16, 1, 0, 5000, 470090000, 80000000},
                   {181, 0, 0, 7, 0, 0},
                   {16, 1, 0, 5000, 470190000, 80000000}});
    ASSERT_TRUE(enterAuto());
    (void)statusTexts();
    reach();
    EXPECT_EQ(missionCurrent(), 3);
    EXPECT_TRUE(hasStatusText("item 2 skipped"));
    EXPECT_EQ(missionSkipped(), before + 1);
}

}  // namespace
}  // namespace firmware

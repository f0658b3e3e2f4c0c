// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands of both sets share, command by command: places, altitudes, ends.
#include "core/maths.hpp"
#include "firmware/mission/fence_rally_items.hpp"
#include "firmware/mission/lists.hpp"
#include "hal/watchdog.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "mission_rig.hpp"

namespace firmware {
using namespace mission;
namespace {

using core::kPi;

class EveryCommand : public Rig {
protected:
    // Another mission, from its beginning.
    static void flyAnew(int set, const Items& items) {
        requestMode(Mode::loiter, ModeReason::pilot);
        stopEvents();
        parameters.mission_set = static_cast<int8_t>(set);
        fly(items);
    }
    static MissionItem absolute(MissionItem item, float z) {
        item.frame = kGlobalFrame;
        item.z = z;
        return item;
    }
};

constexpr uint16_t kPlaced2[] = {16, 17, 18, 19, 21, 23}, kPlaced1[] = {16, 17, 18, 19, 21};

TEST_F(EveryCommand, nav_of_both_sets_has_its_own_kind_of_path) {
    const struct {
        uint16_t id;
        Path path;
    } paths[] = {{16, Path::leg}, {17, Path::circle}, {18, Path::circle},  {19, Path::circle},
                 {20, Path::leg}, {21, Path::land},   {22, Path::takeoff}, {23, Path::leg}};
    for (const int set : {1, 2}) {
        for (const auto& each : paths) {
            if (set == 1 && each.id == 23) continue;
            flyAnew(set, {placed(each.id, 500, 0, 60, 1)});
            EXPECT_EQ(int(vehicle.demand.path), int(each.path)) << set << " " << each.id;
        }
    }
}

TEST_F(EveryCommand, nav_at_0_0_is_flown_where_the_airplane_is_when_it_loads) {
    const auto expectHere = [](int set, uint16_t id) {
        mutable_vehicle.estimate.position.latitude_e7 += 700;
        MissionItem here = placed(id, 0, 0, 60, 1);
        here.x = here.y = 0;
        flyAnew(set, {here});
        EXPECT_EQ(vehicle.demand.to, vehicle.estimate.position) << set << " " << id;
    };
    for (const uint16_t id : kPlaced2) expectHere(2, id);
    for (const uint16_t id : kPlaced1) expectHere(1, id);
}

TEST_F(EveryCommand, return_at_0_0_is_flown_home_all_the_same) {
    mutable_vehicle.estimate.position.latitude_e7 += 70000;
    for (const int set : {1, 2}) {
        MissionItem back = placed(20, 0, 0, 60);
        back.x = back.y = 0;
        flyAnew(set, {back});
        EXPECT_EQ(vehicle.demand.to, vehicle.home.position) << set;
    }
}

TEST_F(EveryCommand, with_an_altitude_takes_it_above_the_sea_where_its_options_say_so) {
    for (const uint16_t id : {16, 17, 18, 19, 20, 21, 22, 23}) {
        flyAnew(2, {absolute(placed(id, 500, 0, 0, 1), 470)});
        EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70) << id << ": home lies at 400 m";
    }
    flyAnew(2, {absolute(command(113, 20), 470), waypoint(900)});
    seconds(3);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70) << "CHANGE_ALT";
}

TEST_F(EveryCommand, of_apm1_with_an_altitude_takes_it_above_the_sea_where_alt_abs_says_so) {
    parameters.altitude_absolute = 1;
    for (const uint16_t id : {16, 17, 18, 19, 20, 21, 22}) {
        flyAnew(1, {absolute(placed(id, 500, 0, 0, 1), 470)});
        EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70) << id;
    }
    flyAnew(1, {absolute(waypoint(900), 410), command(0x21, 255, 47000, 2000)});
    seconds(3);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70) << "CHANGE_ALT";
    requestMode(Mode::loiter, ModeReason::pilot);
    flyAnew(1, {absolute(waypoint(900), 410), placed(0x42, 1000, 0, 420)});
    EXPECT_EQ(vehicle.home.altitude_cm, 42000) << "home is above the sea in any case";
}

TEST_F(EveryCommand, takeoff_above_the_sea_ends_at_its_altitude) {
    mutable_vehicle.estimate.height_m = 0;
    fly({absolute(takeoff(), 440), waypoint(900)});
    mutable_vehicle.estimate.height_m = 38.9f;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.estimate.height_m = 39.1f;  // within a metre
    pass();
    EXPECT_EQ(missionCurrent(), 2);
}

// ---- rally points

class WayHome : public EveryCommand {
protected:
    // Two of them, the second nearer than home; at 85 m.
    void SetUp() override {
        EveryCommand::SetUp();
        mutable_vehicle.estimate.position = {waypoint(4000).x, waypoint(4000).y};
        ASSERT_EQ(whileBusy([] { return listBegin(ListKind::rally, 2, kPointSet); }),
                  MissionResult::accepted);
        for (const int32_t north_m : {-9000, 3000}) {
            uint8_t record[storage::kLargestRecord] = {};
            setPlace(record, {waypoint(north_m).x, waypoint(north_m).y});
            setRallyHeight(record, 85, true);
            ASSERT_EQ(whileBusy([&] { return listPut(record); }), MissionResult::accepted);
        }
        ASSERT_EQ(whileBusy(listCommit), MissionResult::accepted);
        pass(5);
    }
};

TEST_F(WayHome, leads_to_the_rally_point_that_is_nearer_and_ends_there) {
    for (const int set : {1, 2}) {
        flyAnew(set, {placed(20, 0, 0, 0), waypoint(900)});
        seconds(1);
        EXPECT_EQ(vehicle.demand.path, Path::leg);
        EXPECT_EQ(vehicle.demand.to.latitude_e7, waypoint(3000).x) << set;
        EXPECT_FLOAT_EQ(vehicle.demand.height_m, 85) << "the point's own";
        reach();
        EXPECT_EQ(missionCurrent(), 2);
        EXPECT_EQ(vehicle.demand.from.latitude_e7, waypoint(3000).x);
    }
}

TEST_F(WayHome, keeps_the_altitude_that_the_command_gives) {
    fly({placed(20, 0, 0, 120), waypoint(900)});
    seconds(1);
    EXPECT_EQ(vehicle.demand.to.latitude_e7, waypoint(3000).x);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 120);
}

TEST_F(WayHome, leads_home_where_home_is_nearer) {
    mutable_vehicle.estimate.position = {waypoint(1000).x, waypoint(1000).y};
    fly({placed(20, 0, 0, 0), waypoint(900)});
    seconds(1);
    EXPECT_EQ(vehicle.demand.to, vehicle.home.position);
}

// ---- loiters

TEST_F(EveryCommand, loiter_of_apm1_counts_its_turns_and_tens_of_seconds) {
    flyAnew(1, {placed(0x12, 500, 0, 60, 2), waypoint(900)});
    mutable_vehicle.progress.captured = true;
    mutable_vehicle.progress.turned_rad = 1.9f * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.progress.turned_rad = 2.01f * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 2);

    flyAnew(1, {placed(0x13, 500, 0, 60, 2), waypoint(900)});
    mutable_vehicle.progress.captured = true;
    seconds(19);
    EXPECT_EQ(missionCurrent(), 1);
    seconds(2);
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(EveryCommand, loiter_for_no_time_finishes_on_capture) {
    fly({placed(19, 500, 0, 60, 0), waypoint(900)});
    seconds(20);
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.progress.captured = true;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(EveryCommand, loiter_time_is_forgotten_by_a_restart) {
    fly({placed(19, 500, 0, 60, 20), waypoint(900)});
    mutable_vehicle.progress.captured = true;
    seconds(18);
    missionRestart();
    pass();
    mutable_vehicle.progress.captured = true;
    seconds(5);
    EXPECT_EQ(missionCurrent(), 1);
}

// ---- CHANGE_ALT

TEST_F(EveryCommand, change_alt_goes_down_as_it_goes_up) {
    mutable_vehicle.estimate.height_m = 90;
    fly({absolute(command(113, 2), 470), command(181, 0, 1), waypoint(900, 90)});
    EXPECT_NEAR(vehicle.demand.height_m, 89.8, 0.01);
    seconds(5);
    EXPECT_NEAR(vehicle.demand.height_m, 79.8, 0.1);
    mutable_vehicle.estimate.height_m = 72.1f;
    pass();
    EXPECT_FALSE(relayGet());
    mutable_vehicle.estimate.height_m = 71.9f;
    pass();
    EXPECT_TRUE(relayGet()) << "within 2 m";
    seconds(60);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70);
}

TEST_F(EveryCommand, change_alt_is_done_when_the_airplane_has_crossed_the_altitude_in_one_leap) {
    for (const float beyond_m : {80.0f, 60.0f}) {
        relaySet(false);
        mutable_vehicle.estimate.height_m = 140 - beyond_m;
        flyAnew(2, {absolute(command(113, 2), 470), command(181, 0, 1), waypoint(900)});
        EXPECT_FALSE(relayGet()) << beyond_m;
        mutable_vehicle.estimate.height_m = beyond_m;
        pass();
        EXPECT_TRUE(relayGet()) << beyond_m;
    }
}

TEST_F(EveryCommand, change_alt_takes_the_exact_rate_of_p3_before_that_of_p1) {
    flyAnew(1, {waypoint(900), command(0x21, 255, 9000, 300)});
    const float before_m = vehicle.demand.height_m;
    seconds(2);
    EXPECT_NEAR(vehicle.demand.height_m - before_m, 6, 0.05);
    flyAnew(1, {waypoint(900), command(0x21, 100, 9000)});
    const float slow_m = vehicle.demand.height_m;
    seconds(2);
    EXPECT_NEAR(vehicle.demand.height_m - slow_m, 2, 0.05);
}

// ---- speeds

TEST_F(EveryCommand, change_of_speed_ends_with_the_mission_and_is_never_stored) {
    fly({waypoint(500), command(178, 0, 16, 60), waypoint(900)});
    reach();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 16);
    EXPECT_EQ(parameters.cruise_speed_cms, 1300);
    EXPECT_EQ(parameters.cruise_throttle_pct, 45);
    reach();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 13);
    EXPECT_EQ(vehicle.demand.throttle_pct, 45);
}

TEST_F(EveryCommand, throttle_of_0_is_0_percent_in_both_sets) {
    fly({waypoint(500), command(178, 0, -1, 0), waypoint(900)});
    reach();
    EXPECT_EQ(vehicle.demand.throttle_pct, 0);
    flyAnew(1, {waypoint(900), command(0x41, 0)});
    EXPECT_EQ(vehicle.demand.throttle_pct, 0);
}

TEST_F(EveryCommand, cruise_of_apm1_ends_with_the_mission_and_is_never_stored) {
    flyAnew(1, {waypoint(900), command(0x40, 15), command(0x41, 70)});
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 15);
    EXPECT_EQ(parameters.cruise_speed_cms, 1300);
    EXPECT_EQ(parameters.cruise_throttle_pct, 45);
    reach();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 13);
    EXPECT_EQ(vehicle.demand.throttle_pct, 45);
}

// ---- outputs

TEST_F(EveryCommand, repeat_of_a_servo_with_a_pulse_of_0_goes_to_the_channels_maximum) {
    parameters.channel[6].max_us = 1934;
    fly({waypoint(500), command(184, 7, 0, 2, 2), waypoint(900)});
    reach();
    EXPECT_EQ(outputPulse_us(7), 1934);
    seconds(1);
    EXPECT_EQ(outputPulse_us(7), 1500) << "half a cycle";
}

TEST_F(EveryCommand, repeat_goes_on_over_the_navs_until_it_is_counted_out) {
    fly({waypoint(500), command(182, 0, 3, 2), waypoint(900), waypoint(1500)});
    reach();
    EXPECT_TRUE(relayGet());
    seconds(1);
    EXPECT_FALSE(relayGet());
    reach();
    EXPECT_EQ(missionCurrent(), 4);
    seconds(1);
    EXPECT_TRUE(relayGet()) << "the second cycle";
    seconds(4);
    EXPECT_FALSE(eventRuns());
    EXPECT_FALSE(relayGet());
}

TEST_F(EveryCommand, event_0_or_10_stops_what_repeats) {
    for (const int stop : {0, 10}) {
        flyAnew(1, {waypoint(500), command(0x80, 3, 1700, 2, 0), command(0x20, 4),
                    command(0x80, float(stop)), waypoint(900)});
        EXPECT_EQ(outputPulse_us(6), 1700) << stop;
        (void)statusTexts();
        seconds(5);
        EXPECT_FALSE(hasStatusText("refused")) << stop;
        EXPECT_FALSE(eventRuns()) << stop;
        EXPECT_EQ(outputPulse_us(6), 1500) << stop;
    }
}

// ---- jumps

TEST_F(EveryCommand, jump_of_apm1_finds_its_index_in_p2_or_where_that_is_0_in_p1) {
    for (const MissionItem& jump : {command(0x75, 0, 4), command(0x75, 4), command(0x75, 2, 4)}) {
        flyAnew(1, {waypoint(500), jump, waypoint(700), waypoint(900)});
        reach();
        EXPECT_EQ(missionCurrent(), 4) << jump.param1 << " " << jump.param2;
    }
}

// ---- resets

TEST_F(EveryCommand, chain_survives_a_brown_out_as_it_does_the_watchdog) {
    for (const auto cause : {hal::ResetCause::brown_out, hal::ResetCause::watchdog}) {
        flyAnew(2, {waypoint(500), command(177, 1, 1), command(112, 5), waypoint(900)});
        reach();
        reach();
        EXPECT_EQ(missionCurrent(), 4);
        fakes::watchdog().last_run.ended = cause;
        missionBoot();
        requestMode(Mode::loiter, ModeReason::boot);
        enterAuto();
        missionSetCurrent(1);
        pass();
        reach();
        EXPECT_EQ(missionCurrent(), 4) << "the one jump had been taken";
    }
}

TEST_F(EveryCommand, counter_is_full_again_after_a_loss_of_power) {
    fly({waypoint(500), command(177, 1, 1), waypoint(900)});
    reach();
    pass(5);
    fakes::restartEeprom();
    mission_engine.leave();
    missionBoot();
    requestMode(Mode::loiter, ModeReason::boot);
    enterAuto();
    EXPECT_EQ(missionCurrent(), 1);
    reach();
    EXPECT_EQ(missionCurrent(), 1) << "the jump is taken again";
    reach();
    EXPECT_EQ(missionCurrent(), 3);
}

// ---- another mission in flight

TEST_F(EveryCommand, a_partial_upload_in_flight_leaves_the_flight_unchanged_or_restarts_it) {
    fly({waypoint(500), command(112, 5), waypoint(900), waypoint(1500)});
    reach();
    pass(20);
    ASSERT_EQ(uploadPartial(4, {waypoint(7000)}), MissionResult::accepted);
    pass();
    EXPECT_EQ(missionCurrent(), 3);
    EXPECT_FALSE(vehicle.demand.new_path);
    ASSERT_EQ(uploadPartial(2, {command(112, 6)}), MissionResult::accepted);
    pass();
    EXPECT_EQ(missionCurrent(), 1);
}

// 60 m above the sea in one set is 15,360 m above home in the other, byte for byte.
TEST_F(EveryCommand, the_same_bytes_in_the_other_set_restart_the_mission) {
    fly({absolute(waypoint(500), 60), absolute(waypoint(900), 60)});
    reach();
    EXPECT_EQ(missionCurrent(), 2);
    uint8_t before[::mission::kRecordSize], after[::mission::kRecordSize];
    ASSERT_EQ(mission_store.read(2, before), core::Status::ok);
    parameters.mission_set = 1;
    ASSERT_EQ(upload({waypoint(500, 15360), waypoint(900, 15360)}), MissionResult::accepted);
    ASSERT_EQ(mission_store.read(2, after), core::Status::ok);
    EXPECT_EQ(memcmp(before, after, sizeof before), 0);
    pass();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(EveryCommand, an_upload_without_a_nav_ends_the_mission_in_flight) {
    fly({waypoint(500), waypoint(900)});
    (void)statusTexts();
    ASSERT_EQ(upload({command(181, 0, 1)}), MissionResult::accepted);
    pass();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_TRUE(hasStatusText("Mission complete"));
    EXPECT_FALSE(relayGet());
}

// ---- what only an image can hold

TEST_F(EveryCommand, a_terrain_altitude_in_an_image_is_skipped_and_reported) {
    storeImage(2, {{16, 1, 0, 0, 0, 0},
                   {16, ::mission::kAboveTerrain, 0, 5000, 470050000, 80000000},
                   {16, 1, 0, 5000, 470190000, 80000000}});
    ASSERT_TRUE(enterAuto());
    EXPECT_EQ(missionCurrent(), 2);
    EXPECT_TRUE(hasStatusText("item 1 skipped"));
}

TEST_F(EveryCommand, with_options_that_mean_nothing_is_flown_as_without_them) {
    storeImage(2, {{16, 1, 0, 0, 0, 0}, {16, 0xF3, 0, 6000, 470190000, 80000000}});
    ASSERT_TRUE(enterAuto());
    EXPECT_EQ(missionCurrent(), 1);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 60);
}

TEST_F(EveryCommand, parameter_value_beyond_24_bits_stands_exactly_in_p3) {
    const float value = 12345678;
    ::mission::Record record = {};
    EncodeWarnings warnings = {};
    EXPECT_EQ(encodeItem(::mission::Set::apm2, {1, 4}, command(180, 134, value), record, warnings),
              static_cast<MissionResult>(7))
        << "no parameter is that large";
    EXPECT_EQ(record.p2, 8388607) << "the nearest";
    MissionItem item;
    decodeItem(::mission::Set::apm2, 1, record, item);
    EXPECT_EQ(item.param2, value);
}

TEST_F(EveryCommand, speed_that_says_no_change_reads_back_so_whatever_p4_holds) {
    MissionItem item;
    decodeItem(::mission::Set::apm2, 1, {178, 0, 0, -1, 50, 1250}, item);
    EXPECT_EQ(item.param2, -1);
}

TEST_F(EveryCommand, setting_of_the_mission_is_what_the_manual_says_by_default) {
    EXPECT_EQ(parameters.mission_set, 2);
    EXPECT_EQ(parameters.mission_trailing, 0);
    EXPECT_EQ(parameters.mission_restart, 0);
    EXPECT_EQ(parameters.altitude_absolute, 0);
}

}  // namespace
}  // namespace firmware

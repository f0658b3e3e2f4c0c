// SPDX-License-Identifier: GPL-3.0-or-later
// Missions in flight: what the commands of both sets do to the airplane.
#include <algorithm>

#include "core/maths.hpp"
#include "firmware/dataflash.hpp"
#include "firmware/log/log.hpp"
#include "firmware/mission/handlers.hpp"
#include "hal/mark.hpp"
#include "rig.hpp"

namespace firmware {
namespace {

using core::kPi;

class MissionFlight : public Rig {
protected:
    static int reachedItem() {
        uint16_t index = 0;
        return takeReached(index) ? index : -1;
    }
    static void expectTo(const MissionItem& item) {
        EXPECT_EQ(vehicle.demand.to.latitude_e7, item.x);
        EXPECT_EQ(vehicle.demand.to.longitude_e7, item.y);
        EXPECT_FLOAT_EQ(vehicle.demand.height_m, item.z);
    }
};

// ---- NAV

TEST_F(MissionFlight, a_waypoint_is_a_leg_from_the_airplane_then_from_waypoint_to_waypoint) {
    fly({waypoint(500, 60), waypoint(1000, 80), waypoint(1500, 90)});
    EXPECT_EQ(vehicle.demand.path, Path::leg);
    EXPECT_EQ(vehicle.demand.from, vehicle.estimate.position);
    EXPECT_FLOAT_EQ(vehicle.demand.from_height_m, 50);
    EXPECT_TRUE(vehicle.demand.sloped);
    expectTo(waypoint(500, 60));
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 13);
    EXPECT_EQ(vehicle.demand.throttle_pct, 45);

    reach();

    EXPECT_EQ(reachedItem(), 1);
    EXPECT_EQ(reachedItem(), -1);
    EXPECT_EQ(missionCurrent(), 2);
    EXPECT_EQ(vehicle.demand.from.latitude_e7, waypoint(500).x);
    EXPECT_FLOAT_EQ(vehicle.demand.from_height_m, 60);
    expectTo(waypoint(1000, 80));
}

TEST_F(MissionFlight, a_climb_near_the_ground_and_a_small_step_are_flown_at_once) {
    fly({waypoint(500, 60), waypoint(1000, 80), waypoint(1500, 40), waypoint(2000, 20)});
    vehicle.estimate.height_m = 10;
    reach();
    EXPECT_FALSE(vehicle.demand.sloped) << "up";
    reach();
    EXPECT_TRUE(vehicle.demand.sloped) << "down";
    firmware::parameters.glide_slope_min_m = 25;
    reach();
    EXPECT_FALSE(vehicle.demand.sloped) << "not worth a slope";
}

TEST_F(MissionFlight, a_waypoint_finishes_within_its_radius_or_past_its_line) {
    MissionItem near = waypoint(500);
    near.param2 = 12;
    fly({near, waypoint(1000), waypoint(1500)});
    vehicle.progress.distance_m = 12.1f;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    vehicle.progress.distance_m = 12;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    vehicle.progress.distance_m = 30.1f;  // WP_RADIUS is 30
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    vehicle.progress.passed = true;
    pass();
    EXPECT_EQ(missionCurrent(), 3);
}

TEST_F(MissionFlight, a_leg_shorter_than_the_radius_uses_the_radius_only) {
    fly({waypoint(500), waypoint(510), waypoint(900)});
    reach();
    EXPECT_EQ(missionCurrent(), 2);
    vehicle.progress.passed = true;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    vehicle.progress.distance_m = 29;
    pass();
    EXPECT_EQ(missionCurrent(), 3);
}

TEST_F(MissionFlight, altitudes_are_above_home_or_above_the_sea_as_the_options_say) {
    MissionItem absolute = waypoint(500, 470);
    absolute.frame = kGlobalFrame;
    fly({absolute});
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70) << "home lies at 400 m";
}

TEST_F(MissionFlight, in_apm1_altitudes_are_above_home_unless_alt_abs_says_otherwise) {
    parameters.mission_set = 1;
    fly({waypoint(500, 70), waypoint(600, 470)});
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70);
    parameters.altitude_absolute = 1;
    reach();
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70);
}

TEST_F(MissionFlight, a_nav_at_0_0_is_flown_where_the_airplane_is) {
    MissionItem here = waypoint(0, 66);
    here.command = 17;
    here.x = here.y = 0;
    fly({here});
    EXPECT_EQ(vehicle.demand.path, Path::circle);
    EXPECT_EQ(vehicle.demand.to, vehicle.estimate.position);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 66);
}

TEST_F(MissionFlight, target_is_flown_as_a_waypoint) {
    fly({placed(23, 500, 0, 60, 0, 9), waypoint(900)});
    EXPECT_EQ(vehicle.demand.path, Path::leg);
    vehicle.progress.distance_m = 8;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, loiter_unlimited_never_finishes) {
    fly({placed(17, 500, 0, 60), waypoint(900)});
    EXPECT_EQ(vehicle.demand.path, Path::circle);
    EXPECT_FLOAT_EQ(vehicle.demand.radius_m, 60);
    vehicle.progress.captured = true;
    vehicle.progress.turned_rad = 1000;
    vehicle.progress.distance_m = 0;
    pass(100);
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(MissionFlight, the_loiter_direction_is_an_option_in_apm2_and_the_radius_sign_in_apm1) {
    MissionItem left = placed(17, 500, 0, 60);
    left.param3 = -1;
    fly({left});
    EXPECT_TRUE(vehicle.demand.counter_clockwise);
    setMode(Mode::loiter, ModeReason::ground);
    parameters.mission_set = 1;
    parameters.loiter_radius_m = -70;
    fly({placed(17, 500, 0, 60)});
    EXPECT_TRUE(vehicle.demand.counter_clockwise);
    EXPECT_FLOAT_EQ(vehicle.demand.radius_m, 70);
}

TEST_F(MissionFlight, loiter_turns_counts_from_capture_and_survives_a_resume) {
    fly({placed(18, 500, 0, 60, 3), waypoint(900)});
    vehicle.progress.turned_rad = 7 * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 1) << "not captured";
    vehicle.progress.captured = true;
    vehicle.progress.turned_rad = 2 * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    setMode(Mode::loiter, ModeReason::pilot);
    pass(5);
    enterAuto();
    vehicle.progress.captured = true;
    vehicle.progress.turned_rad = 0.9f * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    vehicle.progress.turned_rad = 1.01f * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, zero_turns_finish_on_capture) {
    fly({placed(18, 500, 0, 60, 0), waypoint(900)});
    pass(3);
    EXPECT_EQ(missionCurrent(), 1);
    vehicle.progress.captured = true;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, loiter_time_is_tens_of_seconds_from_capture_and_survives_a_resume) {
    fly({placed(19, 500, 0, 60, 20), waypoint(900)});
    seconds(60);
    EXPECT_EQ(missionCurrent(), 1) << "not captured";
    vehicle.progress.captured = true;
    seconds(15);
    EXPECT_EQ(missionCurrent(), 1);
    setMode(Mode::loiter, ModeReason::pilot);
    seconds(100);
    enterAuto();
    vehicle.progress.captured = true;
    seconds(4);
    EXPECT_EQ(missionCurrent(), 1);
    seconds(2);
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, a_restart_forgets_the_turns) {
    fly({placed(18, 500, 0, 60, 3), waypoint(900)});
    vehicle.progress.captured = true;
    vehicle.progress.turned_rad = 2.9f * 2 * kPi;
    pass();
    missionRestart();
    pass();
    vehicle.progress.captured = true;
    vehicle.progress.turned_rad = 1 * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(MissionFlight, return_to_launch_flies_home_at_its_altitude_or_the_parameters) {
    fly({placed(20, 3000, 0, 0), waypoint(900)});
    EXPECT_EQ(vehicle.demand.to, vehicle.home.position);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 100);
    reach();
    EXPECT_EQ(missionCurrent(), 2);
    setMode(Mode::loiter, ModeReason::pilot);
    fly({placed(20, 3000, 0, 77)});
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 77);
}

TEST_F(MissionFlight, takeoff_climbs_to_its_altitude_and_the_next_leg_begins_at_the_airplane) {
    vehicle.estimate.height_m = 0;
    fly({takeoff(40), waypoint(900)});
    EXPECT_EQ(vehicle.demand.path, Path::takeoff);
    EXPECT_NEAR(vehicle.demand.takeoff_pitch_rad, 12 * kPi / 180, 1e-5);
    vehicle.estimate.height_m = 38;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    vehicle.estimate.height_m = 40;
    vehicle.estimate.position.latitude_e7 += 5000;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    EXPECT_EQ(vehicle.demand.from, vehicle.estimate.position);
    EXPECT_FLOAT_EQ(vehicle.demand.from_height_m, 40);
}

TEST_F(MissionFlight, a_land_finishes_when_down_and_disarmed_and_auto_stays) {
    fly({waypoint(500), placed(21, 900, 0, 0)});
    reach();
    EXPECT_EQ(vehicle.demand.path, Path::land);
    EXPECT_EQ(vehicle.demand.from.latitude_e7, waypoint(500).x);
    reach();
    EXPECT_EQ(missionCurrent(), 2) << "over the point is not down";
    vehicle.estimate.flying = false;
    vehicle.progress.flaring = true;
    seconds(9);
    EXPECT_TRUE(vehicle.armed);
    seconds(2);
    EXPECT_FALSE(vehicle.armed) << "disarms when it has stood for LAND_DISARMDELAY";
    pass(2);
    EXPECT_TRUE(missionComplete());
    EXPECT_EQ(vehicle.mode, Mode::automatic);
    EXPECT_EQ(vehicle.demand.path, Path::land);
}

TEST_F(MissionFlight, after_a_land_a_takeoff_waits_for_arming) {
    fly({placed(21, 900, 0, 0), takeoff(40), waypoint(900)});
    vehicle.estimate.flying = false;
    vehicle.armed = false;
    vehicle.estimate.height_m = 0;
    pass(3);
    EXPECT_EQ(missionCurrent(), 2);
    vehicle.estimate.height_m = 60;  // the barometer drifts
    pass(3);
    EXPECT_EQ(missionCurrent(), 2);
    vehicle.armed = true;
    pass();
    EXPECT_EQ(missionCurrent(), 3);
}

TEST_F(MissionFlight, the_end_of_the_mission_is_rtl_and_told) {
    fly({waypoint(500)});
    (void)told();
    reach();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_TRUE(missionComplete());
    EXPECT_TRUE(tells("Mission complete"));
    EXPECT_EQ(missionCurrent(), 0);
}

TEST_F(MissionFlight, a_mission_without_a_nav_refuses_auto_with_the_reason) {
    ASSERT_EQ(upload({command(181, 0, 1)}), MissionResult::accepted);
    vehicle.armed = vehicle.estimate.flying = false;
    (void)told();
    EXPECT_FALSE(enterAuto());
    EXPECT_EQ(vehicle.mode, Mode::loiter);
    EXPECT_TRUE(tells("no NAV"));
    vehicle.armed = vehicle.estimate.flying = true;
    setMode(Mode::automatic, ModeReason::pilot);
    EXPECT_EQ(vehicle.mode, Mode::rtl) << "in the air it means home";
}

// ---- CONDITION

TEST_F(MissionFlight, a_delay_holds_the_servo_back_for_its_seconds) {
    fly({waypoint(500), command(112, 5), command(183, 6, 1700), waypoint(900)});
    reach();
    seconds(4);
    EXPECT_EQ(outputPulse_us(6), 1500);
    seconds(2);
    EXPECT_EQ(outputPulse_us(6), 1700);
}

TEST_F(MissionFlight, a_delay_stands_in_p1_in_apm1) {
    parameters.mission_set = 1;
    fly({waypoint(500), command(0x20, 5), command(0x81, 1)});
    seconds(4);
    EXPECT_FALSE(relayGet());
    seconds(2);
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_resumed_delay_waits_its_full_time) {
    fly({waypoint(500), command(112, 5), command(181, 0, 1), waypoint(900)});
    reach();
    seconds(4);
    setMode(Mode::loiter, ModeReason::pilot);
    seconds(10);
    EXPECT_FALSE(relayGet());
    enterAuto();
    seconds(4);
    EXPECT_FALSE(relayGet());
    seconds(2);
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_distance_waits_for_the_airplane_to_come_near) {
    fly({waypoint(500), command(114, 200), command(181, 0, 1), waypoint(900)});
    reach();
    vehicle.progress.distance_m = 201;
    pass();
    EXPECT_FALSE(relayGet());
    vehicle.progress.distance_m = 199;
    pass();
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_distance_beside_a_takeoff_waits_until_that_nav_ends) {
    fly({command(114, 200), command(181, 0, 1), takeoff(400), waypoint(900)});
    vehicle.progress.distance_m = 0;
    pass(5);
    EXPECT_FALSE(relayGet());
}

TEST_F(MissionFlight, change_alt_moves_the_target_at_its_rate_from_the_airplane_and_it_stays) {
    MissionItem climb = command(113, 2);
    climb.frame = kRelativeFrame;
    climb.z = 70;
    fly({waypoint(500, 60), climb, command(181, 0, 1), waypoint(900, 60), waypoint(1900, 60)});
    vehicle.estimate.height_m = 55;
    reach();
    EXPECT_FALSE(vehicle.demand.sloped);
    EXPECT_FLOAT_EQ(vehicle.demand.from_height_m, 55) << "guidance moves this one, not the leg's";
    EXPECT_NEAR(vehicle.demand.height_m, 55.2, 0.01);
    seconds(5);
    EXPECT_NEAR(vehicle.demand.height_m, 65.2, 0.1);
    EXPECT_FALSE(relayGet());
    vehicle.estimate.height_m = 68.5f;
    pass();
    EXPECT_TRUE(relayGet()) << "within 2 m";
    seconds(10);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70);
    setMode(Mode::loiter, ModeReason::pilot);
    pass(5);
    enterAuto();
    seconds(5);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 70) << "it stays over a resume";
    reach();
    pass(5);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 60) << "until the next NAV loads";
}

TEST_F(MissionFlight, change_alt_leaves_the_ground_of_a_landing_where_it_is) {
    MissionItem climb = command(113, 2);
    climb.frame = kRelativeFrame;
    climb.z = 30;
    fly({waypoint(500), climb, placed(21, 900, 0, 0)});
    reach();
    pass(5);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 0);
}

// ---- DO

TEST_F(MissionFlight, change_speed_lasts_until_the_mission_restarts_or_ends) {
    fly({waypoint(500), command(178, 0, 16.5f, 60), waypoint(900), waypoint(1500)});
    reach();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 16.5f);
    EXPECT_EQ(vehicle.demand.throttle_pct, 60);
    reach();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 16.5f);
    setMode(Mode::loiter, ModeReason::pilot);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 13);
    enterAuto();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 16.5f) << "survives a resume";
    missionRestart();
    pass();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 13);
}

TEST_F(MissionFlight, minus_1_leaves_speed_or_throttle_alone) {
    fly({waypoint(500), command(178, 0, 16, -1), command(178, 0, -1, 30), waypoint(900)});
    reach();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 16);
    EXPECT_EQ(vehicle.demand.throttle_pct, 30);
}

TEST_F(MissionFlight, a_ground_speed_is_followed_within_the_air_speed_limits) {
    fly({waypoint(500), command(178, 1, 18, -1), waypoint(900)});
    vehicle.estimate.ground_speed_mps = 10;
    reach();
    seconds(60);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 22);
    vehicle.estimate.ground_speed_mps = 30;
    seconds(60);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 9);
}

TEST_F(MissionFlight, set_home_between_two_waypoints_sets_home_at_the_first) {
    fly({waypoint(500), command(179, 1), waypoint(900)});
    vehicle.estimate.position = {waypoint(500).x, waypoint(500).y};
    EXPECT_NE(vehicle.home.position, vehicle.estimate.position);
    reach();
    EXPECT_EQ(vehicle.home.position, vehicle.estimate.position);
}

TEST_F(MissionFlight, set_home_as_given_is_above_sea_level_whatever_the_frame) {
    MissionItem home = placed(179, 1000, 2000, 430);
    fly({waypoint(500), home, waypoint(900)});
    reach();
    EXPECT_EQ(vehicle.home.position.latitude_e7, home.x);
    EXPECT_EQ(vehicle.home.altitude_cm, 43000);
}

TEST_F(MissionFlight, set_parameter_sets_the_one_in_the_slot) {
    fly({waypoint(500), command(180, 102, 0.75f), command(180, 134, 45), waypoint(900)});
    reach();
    EXPECT_FLOAT_EQ(parameters.roll.axis.p, 0.75f);
    EXPECT_EQ(parameters.waypoint_radius_m, 45);
}

TEST_F(MissionFlight,
       an_advance_over_168_actions_takes_several_frames_of_16_records_and_loses_none) {
    Items items = {waypoint(500)};
    for (int i = 0; i < 168; ++i) items.push_back(command(181, 0, float(i % 2)));
    items.push_back(waypoint(900));
    fly(items);
    const auto actions = [] {
        const auto& marks = fakes::marks();
        return std::count(marks.begin(), marks.end(),
                          hal::kMarkMission + static_cast<int>(mission::Event::runs));
    };
    const auto before = actions();
    vehicle.progress.distance_m = 0;
    int tenths = 0;
    for (auto seen = before; missionCurrent() != 170 ||
                             vehicle.demand.to != geo::Position{waypoint(900).x, waypoint(900).y};
         ++tenths) {
        ASSERT_LT(tenths, 20);
        pass();
        EXPECT_LE(actions() - seen, 2 * 16) << "two frames in a tenth of a second";
        seen = actions();
    }
    EXPECT_EQ(actions() - before, 168);
    // looked at once for the NAV behind them and once to be run, 32 records in a tenth
    EXPECT_EQ(tenths, (169 + 168 + 31) / 32);
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, set_servo_holds_the_output_until_the_mode_changes) {
    fly({waypoint(500), command(183, 5, 1), command(183, 6, 0), command(183, 7, 1234),
         waypoint(900)});
    reach();
    EXPECT_EQ(outputPulse_us(5), 1900);
    EXPECT_EQ(outputPulse_us(6), 1100);
    EXPECT_EQ(outputPulse_us(7), 1234);
    setMode(Mode::loiter, ModeReason::pilot);
    pass();
    EXPECT_EQ(outputPulse_us(7), 1500);
}

TEST_F(MissionFlight, set_relay_switches_it) {
    fly({waypoint(500), command(181, 0, 1), waypoint(900), command(181, 0, 0), waypoint(1500)});
    reach();
    EXPECT_TRUE(relayGet());
    reach();
    EXPECT_FALSE(relayGet());
}

// ---- APM 1.0

class Apm1Flight : public MissionFlight {
protected:
    void SetUp() override {
        MissionFlight::SetUp();
        parameters.mission_set = 1;
    }
    // The command runs beside the first waypoint.
    static void run(const MissionItem& item) { fly({waypoint(500), item, waypoint(900)}); }
};

TEST_F(Apm1Flight, the_mode_is_changed_and_coming_back_goes_on_behind_the_command) {
    fly({waypoint(500), command(0x30, 12), command(0x81, 1), waypoint(900)});
    EXPECT_EQ(vehicle.mode, Mode::loiter);
    EXPECT_FALSE(relayGet());
    enterAuto();
    EXPECT_EQ(vehicle.mode, Mode::automatic);
    EXPECT_TRUE(relayGet());
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(Apm1Flight, changing_the_mode_to_auto_does_nothing) {
    run(command(0x30, 10));
    EXPECT_EQ(vehicle.mode, Mode::automatic);
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(Apm1Flight, cruise_speed_throttle_gains_and_channels_are_set) {
    fly({waypoint(500), command(0x40, 15), command(0x41, 70), command(0x60, 0, 45000),
         command(0x61, 6, 20000), command(0x64, 1, 70000), command(0x70, 4, 1510),
         command(0x71, 7, 1950), command(0x72, 0, 1050), command(0x73, 2, 960)});
    pass();  // more than the engine looks at in one
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 15);
    EXPECT_EQ(vehicle.demand.throttle_pct, 70);
    EXPECT_FLOAT_EQ(parameters.roll.axis.p, 0.45f);
    EXPECT_FLOAT_EQ(parameters.speed_height.integral_gain, 0.2f);
    EXPECT_FLOAT_EQ(parameters.rudder_mix, 0.7f);
    EXPECT_EQ(parameters.channel[4].trim_us, 1510);
    EXPECT_EQ(parameters.channel[7].max_us, 1950);
    EXPECT_EQ(parameters.channel[0].min_us, 1050);
    EXPECT_EQ(parameters.throttle_failsafe_us, 960);
}

TEST_F(Apm1Flight, every_gain_it_accepts_goes_to_the_parameter_that_plays_the_part) {
    struct {
        uint8_t id, index;
        const char* name;
    } const parts[] = {
        {0x60, 0, "RLL2SRV_P"},     {0x60, 1, "PTCH2SRV_P"},     {0x61, 0, "RLL2SRV_I"},
        {0x61, 1, "PTCH2SRV_I"},    {0x61, 2, "YAW2SRV_INT"},    {0x61, 6, "TECS_INTEG_GAIN"},
        {0x62, 0, "RLL2SRV_D"},     {0x62, 1, "PTCH2SRV_D"},     {0x62, 2, "YAW2SRV_DAMP"},
        {0x62, 3, "NAVL1_DAMPING"}, {0x62, 5, "TECS_PTCH_DAMP"}, {0x62, 6, "TECS_THR_DAMP"},
        {0x63, 0, "RLL2SRV_IMAX"},  {0x63, 1, "PTCH2SRV_IMAX"},  {0x63, 2, "YAW2SRV_IMAX"},
        {0x64, 0, "PTCH2SRV_RLL"},  {0x64, 1, "KFF_RDDRMIX"},
    };
    int mapped = 0;
    for (int id = 0x60; id <= 0x64; ++id) {
        for (int index = 0; index < 8; ++index) {
            const uint8_t slot = gainSlot(uint8_t(id), uint8_t(index));
            if (slot == kNoSlot) continue;
            ++mapped;
            uint16_t row;
            ASSERT_TRUE(parameterOfSlot(slot, row));
            char name[16];
            float value;
            uint8_t type;
            ASSERT_TRUE(parameterAt(row, name, value, type));
            bool found = false;
            for (const auto& part : parts)
                found |= part.id == id && part.index == index &&
                         std::string(name, strnlen(name, 16)) == part.name;
            EXPECT_TRUE(found) << std::hex << id << " " << index << " " << name;
        }
    }
    EXPECT_EQ(mapped, 17);
}

TEST_F(Apm1Flight, every_channel_slot_is_the_parameter_it_should_be) {
    for (int i = 0; i < 8; ++i) {
        const std::string channel = "RC" + std::to_string(i + 1);
        const struct {
            uint8_t id;
            const char* part;
        } kinds[] = {{0x70, "_TRIM"}, {0x71, "_MAX"}, {0x72, "_MIN"}};
        for (const auto& kind : kinds) {
            uint16_t row;
            ASSERT_TRUE(parameterOfSlot(channelSlot(kind.id, uint8_t(i)), row));
            char name[16];
            float value;
            uint8_t type;
            parameterAt(row, name, value, type);
            EXPECT_EQ(std::string(name, strnlen(name, 16)), channel + kind.part);
        }
    }
    uint16_t row;
    ASSERT_TRUE(parameterOfSlot(otherRadioSlot(2), row));
}

TEST_F(Apm1Flight, home_is_reset_here_or_as_given) {
    vehicle.estimate.position.latitude_e7 += 1000;
    run(command(0x42));
    EXPECT_EQ(vehicle.home.position, vehicle.estimate.position);
    setMode(Mode::loiter, ModeReason::pilot);
    MissionItem home = placed(0x42, 1000, 0, 420);
    run(home);
    EXPECT_EQ(vehicle.home.position.latitude_e7, home.x);
    EXPECT_EQ(vehicle.home.altitude_cm, 42000);
}

TEST_F(Apm1Flight, a_queried_or_broadcast_variable_is_told_once_on_every_link) {
    const auto told = [](hal::Port port) {
        auto& out = fakes::serial(port).out;
        const std::string text(out.begin(), out.end());
        out.clear();
        const size_t at = text.find("WP_RADIUS");
        return at != std::string::npos && text.find("WP_RADIUS", at + 1) == std::string::npos;
    };
    for (const uint16_t id : {0x32, 0x33}) {
        setMode(Mode::loiter, ModeReason::pilot);
        told(hal::Port::link0);
        told(hal::Port::link1);
        run(command(id, 134));
        pass(5);
        EXPECT_TRUE(told(hal::Port::link0)) << id;
        EXPECT_TRUE(told(hal::Port::link1)) << id;
    }
}

// A DataFlash that is never busy; what is written into its buffers goes by as text.
class LoggedFlight : public Apm1Flight {
protected:
    void SetUp() override {
        Apm1Flight::SetUp();
        fakes::FlashBus::device = [](uint8_t) -> uint8_t {
            const std::vector<uint8_t>& sent = fakes::FlashBus::sent;
            if (sent.size() < 2) return 0xFF;
            if (sent[0] == 0x9F) return sent.size() == 2 ? 0x1F : 0x26;
            return sent[0] == 0xD7 ? 0xAC : 0xFF;
        };
        fakes::FlashBus::on_select = [this](bool low) {
            std::vector<uint8_t>& sent = fakes::FlashBus::sent;
            const bool into_buffer = !low && !sent.empty() && (sent[0] == 0x84 || sent[0] == 0x87);
            if (into_buffer && sent.size() > 4) written.append(sent.begin() + 4, sent.end());
            sent.clear();
        };
        dataflashStart();
        for (int i = 0; i < 4; ++i) {
            fakes::advance_ms(100);
            dataflashStep();
        }
        parameters.log_bitmask = 4;
        logStart();
        while (logFind()) {
        }
        writeOn();  // what every log begins with, all parameters among it
    }
    static void writeOn() {
        for (int i = 0; i < 600; ++i) {
            runLog();
            fakes::advance_ms(20);
        }
    }
    void TearDown() override {
        fakes::reset();
        dataflashStart();  // no chip any more
        for (int i = 0; i < 40; ++i) {
            fakes::advance_ms(100);
            dataflashStep();
        }
        logStart();
    }
    // The chip keeps nothing, so there is no mission: the row itself is run.
    bool logs(uint8_t id) {
        written.clear();
        const uint8_t row = kCommandTable.find(mission::Set::apm1, id);
        kCommandTable.rows[row].act({id, 0, 134, 0, 0, 0});
        pass(3);
        writeOn();
        return written.find("WP_RADIUS") != std::string::npos;
    }
    std::string written;
};

TEST_F(LoggedFlight, a_broadcast_variable_is_written_to_the_log_and_a_queried_one_is_not) {
    ASSERT_TRUE(logOpen());
    EXPECT_FALSE(logs(0x32));
    EXPECT_TRUE(logs(0x33));
}

TEST_F(Apm1Flight, a_variable_that_another_one_overtakes_is_told) {
    auto& port = fakes::serial(hal::Port::link0);
    port.endless = false;
    port.room = 0;
    fly({waypoint(500), command(0x32, 134), command(0x32, 102), waypoint(900)});
    port.endless = true;
    port.room = 255;
    EXPECT_TRUE(tells("parameter 134 not sent"));
}

TEST_F(Apm1Flight, a_variable_that_finds_no_room_is_sent_later) {
    auto& port = fakes::serial(hal::Port::link0);
    port.endless = false;
    port.room = 0;
    run(command(0x32, 134));
    pass(3);
    port.endless = true;
    port.room = 255;
    port.out.clear();
    pass();
    EXPECT_NE(std::string(port.out.begin(), port.out.end()).find("WP_RADIUS"), std::string::npos);
}

TEST_F(Apm1Flight, the_radio_can_be_silenced_and_heard_again) {
    run(command(0x34, 0));
    EXPECT_TRUE(radioSilenced());
    radioHeard();
    EXPECT_FALSE(radioSilenced());
}

TEST_F(Apm1Flight, a_servo_pulse_is_held_at_800_at_least_and_0_is_no_pulse) {
    fly({waypoint(500), command(0x82, 4, 1300), command(0x82, 5, 1), command(0x82, 6, 0)});
    EXPECT_EQ(outputPulse_us(5), 1300);
    EXPECT_EQ(outputPulse_us(6), 800);
    EXPECT_EQ(outputPulse_us(7), 0);
}

TEST_F(Apm1Flight, the_throttle_is_never_taken_while_armed) {
    (void)told();
    run(command(0x82, 2, 1300));
    EXPECT_NE(outputPulse_us(3), 1300);
    EXPECT_TRUE(tells("output 3 refused"));
}

TEST_F(Apm1Flight, a_servo_pulse_may_be_set_on_every_other_output_until_the_mode_changes) {
    for (uint8_t output : {1, 2, 4, 5, 6, 7, 8}) {
        setMode(Mode::loiter, ModeReason::pilot);
        run(command(0x82, float(output - 1), 1300));
        EXPECT_EQ(outputPulse_us(output), 1300) << int(output);
        setMode(Mode::loiter, ModeReason::pilot);
        pass();
        EXPECT_NE(outputPulse_us(output), 1300) << int(output);
    }
}

TEST_F(Apm1Flight, the_throttle_of_a_disarmed_airplane_may_be_set_and_arming_takes_it_back) {
    vehicle.armed = vehicle.estimate.flying = false;
    run(command(0x82, 2, 1300));
    EXPECT_EQ(outputPulse_us(3), 1300);
    vehicle.armed = true;
    runOutputs();
    EXPECT_NE(outputPulse_us(3), 1300);
}

TEST_F(Apm1Flight, jumps_to_one_fly_round_and_round) {
    fly({waypoint(500), waypoint(900), command(0x31)});
    int flown[4];
    for (int& item : flown) {
        item = missionCurrent();
        reach();
    }
    EXPECT_EQ(flown[0], 1);
    EXPECT_EQ(flown[1], 2);
    EXPECT_EQ(flown[2], 1);
    EXPECT_EQ(flown[3], 2);
}

// ---- leaving, coming back, changing

TEST_F(MissionFlight, a_watchdog_reset_in_the_air_resumes_where_it_was) {
    fly({waypoint(500), command(177, 1, 1), command(112, 5), command(181, 0, 1), waypoint(900)});
    reach();
    reach();
    EXPECT_EQ(missionCurrent(), 5);
    pass(3);
    fakes::watchdog().cause = hal::ResetCause::watchdog;
    relaySet(false);
    missionBoot();
    setMode(Mode::loiter, ModeReason::boot);
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
    setMode(Mode::loiter, ModeReason::boot);
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
    setMode(Mode::loiter, ModeReason::pilot);
    enterAuto();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(MissionFlight, a_resumed_leg_begins_at_the_airplane) {
    fly({waypoint(500), waypoint(900)});
    reach();
    EXPECT_NE(vehicle.demand.from, vehicle.estimate.position);
    setMode(Mode::loiter, ModeReason::pilot);
    vehicle.estimate.position.longitude_e7 += 4000;
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
        setMode(Mode::loiter, ModeReason::pilot);
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

TEST_F(MissionFlight, a_nav_out_of_range_is_no_end_of_a_chain) {
    parameters.mission_set = 1;
    const mission::Record beyond_the_pole = {16, 0, 0, 5000, 910000000, 80000000};
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
    vehicle.estimate.height_m = 51;
    reach();
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_clear_in_auto_goes_home_and_is_told) {
    fly({waypoint(500), waypoint(900)});
    (void)told();
    ASSERT_EQ(whileBusy(missionClear), MissionResult::accepted);
    pass();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_TRUE(tells("Mission complete"));
    EXPECT_EQ(missionCount(), 0);
}

TEST_F(MissionFlight, a_new_mission_outside_auto_begins_at_its_first) {
    fly({waypoint(500), waypoint(900)});
    reach();
    setMode(Mode::loiter, ModeReason::pilot);
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
    setMode(Mode::loiter, ModeReason::pilot);
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
    vehicle.progress.distance_m = 201;
    pass();
    EXPECT_FALSE(relayGet());
    EXPECT_EQ(vehicle.demand.to.latitude_e7, waypoint(500).x);
    vehicle.progress.distance_m = 199;
    pass();
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, a_record_out_of_range_in_an_image_is_skipped_told_and_counted) {
    const uint16_t before = missionSkipped();
    storeImage(2, {{16, 1, 0, 0, 0, 0},
                   {16, 1, 0, 5000, 470090000, 80000000},
                   {181, 0, 0, 7, 0, 0},
                   {16, 1, 0, 5000, 470190000, 80000000}});
    ASSERT_TRUE(enterAuto());
    (void)told();
    reach();
    EXPECT_EQ(missionCurrent(), 3);
    EXPECT_TRUE(tells("item 2 skipped"));
    EXPECT_EQ(missionSkipped(), before + 1);
}

}  // namespace
}  // namespace firmware

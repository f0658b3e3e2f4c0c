// SPDX-License-Identifier: GPL-3.0-or-later
// What NAV commands do to the airplane.
#include "mission_flight.hpp"

#include "core/maths.hpp"
#include "firmware/guidance/lateral.hpp"
#include "firmware/mission/handlers.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace firmware {
using namespace mission;
namespace {

using core::kPi;

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
    mutable_vehicle.estimate.height_m = 10;
    reach();
    EXPECT_FALSE(vehicle.demand.sloped) << "up";
    reach();
    EXPECT_TRUE(vehicle.demand.sloped) << "down";
    firmware::state::parameters.glide_slope_min_m = 25;
    reach();
    EXPECT_FALSE(vehicle.demand.sloped) << "not worth a slope";
}

TEST_F(MissionFlight, the_height_of_a_circle_is_reached_along_the_way_as_a_waypoints_is) {
    for (uint16_t command : {17, 18, 19}) {
        MissionItem circle = waypoint(1000, 90);
        circle.command = command;
        circle.param1 = 10;
        fly({waypoint(500, 60), circle});
        reach();
        EXPECT_EQ(vehicle.demand.path, Path::circle);
        EXPECT_TRUE(vehicle.demand.sloped) << command;
        EXPECT_FLOAT_EQ(vehicle.demand.from_height_m, 60);
        EXPECT_FLOAT_EQ(vehicle.demand.height_m, 90);
    }
}

TEST_F(MissionFlight, a_waypoint_finishes_within_its_radius_or_past_its_line) {
    MissionItem near = waypoint(500);
    near.param2 = 12;
    fly({near, waypoint(1000), waypoint(1500)});
    mutable_vehicle.progress.distance_m = 12.1f;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.progress.distance_m = 12;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    mutable_vehicle.progress.distance_m = 30.1f;  // WP_RADIUS is 30
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    mutable_vehicle.progress.passed = true;
    pass();
    EXPECT_EQ(missionCurrent(), 3);
}

// 500 m to the side of waypoint(1000): a turn by about a right angle.
MissionItem aside() {
    MissionItem item = waypoint(1000);
    item.y += 66000;
    return item;
}

// At 22 m/s, as guidance begins a leg.
void guideFast() {
    mutable_vehicle.estimate.airspeed_mps = 22;
    mutable_vehicle.estimate.velocity_mps = {22, 0, 0};
    guidance::beginLateral();
    guidance::planLateral();
}

TEST_F(MissionFlight, a_waypoint_without_a_radius_finishes_where_the_turn_to_the_next_begins) {
    fly({waypoint(1000), aside(), waypoint(1500)});
    guideFast();
    mutable_vehicle.progress.distance_m = 110;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.progress.distance_m = 60;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, a_turn_does_not_begin_while_a_condition_runs) {
    constexpr uint16_t kDistance = 114, kSetRelay = 181;
    relaySet(false);
    fly({waypoint(1000), command(kDistance, 40), command(kSetRelay, 0, 1), aside(),
         waypoint(1500)});
    reach();
    guideFast();
    mutable_vehicle.progress.distance_m = 60;
    pass();
    EXPECT_EQ(missionCurrent(), 4);
    mutable_vehicle.progress.distance_m = 39;
    pass(2);
    EXPECT_TRUE(relayGet());
    EXPECT_EQ(missionCurrent(), 5);
}

TEST_F(MissionFlight, a_leg_shorter_than_the_radius_uses_the_radius_only) {
    fly({waypoint(500), waypoint(510), waypoint(900)});
    reach();
    EXPECT_EQ(missionCurrent(), 2);
    mutable_vehicle.progress.passed = true;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    mutable_vehicle.progress.distance_m = 29;
    pass();
    EXPECT_EQ(missionCurrent(), 3);
}

// In a turn the airplane may leave such a leg to the side: along its line it would fly away.
TEST_F(MissionFlight, a_leg_shorter_than_the_radius_that_was_passed_beside_it_begins_anew) {
    fly({waypoint(500), waypoint(510), waypoint(900)});
    reach();
    mutable_vehicle.estimate.position = geo::moved(vehicle.demand.to, {50, 0});
    mutable_vehicle.progress.passed = true;
    mutable_vehicle.progress.distance_m = 50;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    EXPECT_EQ(vehicle.demand.from, vehicle.estimate.position);
    mutable_vehicle.progress.passed = false;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
    mutable_vehicle.progress.passed = true;
    pass();
    EXPECT_EQ(missionCurrent(), 3) << "the new one is long enough to count";
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
    mutable_vehicle.progress.distance_m = 8;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, loiter_unlimited_never_finishes) {
    fly({placed(17, 500, 0, 60), waypoint(900)});
    EXPECT_EQ(vehicle.demand.path, Path::circle);
    EXPECT_FLOAT_EQ(vehicle.demand.radius_m, 60);
    mutable_vehicle.progress.captured = true;
    mutable_vehicle.progress.turned_rad = 1000;
    mutable_vehicle.progress.distance_m = 0;
    pass(100);
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(MissionFlight, the_loiter_direction_is_an_option_in_apm2_and_the_radius_sign_in_apm1) {
    MissionItem left = placed(17, 500, 0, 60);
    left.param3 = -1;
    fly({left});
    EXPECT_TRUE(vehicle.demand.counter_clockwise);
    requestMode(Mode::loiter, ModeReason::ground);
    parameters.mission_set = 1;
    parameters.loiter_radius_m = -70;
    fly({placed(17, 500, 0, 60)});
    EXPECT_TRUE(vehicle.demand.counter_clockwise);
    EXPECT_FLOAT_EQ(vehicle.demand.radius_m, 70);
}

TEST_F(MissionFlight, loiter_turns_counts_from_capture_and_survives_a_resume) {
    fly({placed(18, 500, 0, 60, 3), waypoint(900)});
    mutable_vehicle.progress.turned_rad = 7 * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 1) << "not captured";
    mutable_vehicle.progress.captured = true;
    mutable_vehicle.progress.turned_rad = 2 * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    requestMode(Mode::loiter, ModeReason::pilot);
    pass(5);
    enterAuto();
    mutable_vehicle.progress.captured = true;
    mutable_vehicle.progress.turned_rad = 0.9f * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.progress.turned_rad = 1.01f * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, zero_turns_finish_on_capture) {
    fly({placed(18, 500, 0, 60, 0), waypoint(900)});
    pass(3);
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.progress.captured = true;
    pass();
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, loiter_time_is_tens_of_seconds_from_capture_and_survives_a_resume) {
    fly({placed(19, 500, 0, 60, 20), waypoint(900)});
    seconds(60);
    EXPECT_EQ(missionCurrent(), 1) << "not captured";
    mutable_vehicle.progress.captured = true;
    seconds(15);
    EXPECT_EQ(missionCurrent(), 1);
    requestMode(Mode::loiter, ModeReason::pilot);
    seconds(100);
    enterAuto();
    mutable_vehicle.progress.captured = true;
    seconds(4);
    EXPECT_EQ(missionCurrent(), 1);
    seconds(2);
    EXPECT_EQ(missionCurrent(), 2);
}

TEST_F(MissionFlight, a_restart_forgets_the_turns) {
    fly({placed(18, 500, 0, 60, 3), waypoint(900)});
    mutable_vehicle.progress.captured = true;
    mutable_vehicle.progress.turned_rad = 2.9f * 2 * kPi;
    pass();
    missionRestart();
    pass();
    mutable_vehicle.progress.captured = true;
    mutable_vehicle.progress.turned_rad = 1 * 2 * kPi;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(MissionFlight, return_to_launch_flies_home_at_its_altitude_or_the_parameters) {
    fly({placed(20, 3000, 0, 0), waypoint(900)});
    EXPECT_EQ(vehicle.demand.to, vehicle.home.position);
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 100);
    reach();
    EXPECT_EQ(missionCurrent(), 2);
    requestMode(Mode::loiter, ModeReason::pilot);
    fly({placed(20, 3000, 0, 77)});
    EXPECT_FLOAT_EQ(vehicle.demand.height_m, 77);
}

TEST_F(MissionFlight, takeoff_climbs_to_its_altitude_and_the_next_leg_begins_at_the_airplane) {
    mutable_vehicle.estimate.height_m = 0;
    fly({takeoff(40), waypoint(900)});
    EXPECT_EQ(vehicle.demand.path, Path::takeoff);
    EXPECT_NEAR(vehicle.demand.takeoff_pitch_rad, 12 * kPi / 180, 1e-5);
    mutable_vehicle.estimate.height_m = 38;
    pass();
    EXPECT_EQ(missionCurrent(), 1);
    mutable_vehicle.estimate.height_m = 40;
    mutable_vehicle.estimate.position.latitude_e7 += 5000;
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
    mutable_vehicle.estimate.flying = false;
    mutable_vehicle.progress.flaring = true;
    seconds(9);
    EXPECT_TRUE(vehicle.armed);
    seconds(2);
    EXPECT_FALSE(vehicle.armed) << "disarms when it has stood for LAND_DISARMDELAY";
    pass(2);
    EXPECT_TRUE(missionComplete());
    EXPECT_EQ(vehicle.mode, Mode::automatic);
    EXPECT_EQ(vehicle.demand.path, Path::land);
}

TEST_F(MissionFlight, a_mission_is_not_complete_once_an_item_is_chosen_after_the_landing) {
    fly({waypoint(500), placed(21, 900, 0, 0)});
    reach();
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = false;
    pass(2);
    ASSERT_TRUE(missionComplete());
    EXPECT_FALSE(missionSetCurrent(9));
    EXPECT_TRUE(missionComplete());
    EXPECT_TRUE(missionSetCurrent(1));
    EXPECT_FALSE(missionComplete());
    pass();
    EXPECT_EQ(missionCurrent(), 1);
}

TEST_F(Apm1Flight, any_altitude_of_a_record_above_the_sea_is_a_height) {
    parameters.altitude_absolute = 1;
    EXPECT_FLOAT_EQ(heightOf_m({0x10, 0, 0, INT32_MIN, 0, 0}), -21475236.0f);
    mutable_vehicle.home.altitude_cm = -40000;
    EXPECT_FLOAT_EQ(heightOf_m({0x10, 0, 0, INT32_MAX, 0, 0}), 21475236.0f);
}

TEST_F(MissionFlight, after_a_land_a_takeoff_waits_for_arming) {
    fly({placed(21, 900, 0, 0), takeoff(40), waypoint(900)});
    mutable_vehicle.estimate.flying = false;
    mutable_vehicle.armed = false;
    mutable_vehicle.estimate.height_m = 0;
    pass(3);
    EXPECT_EQ(missionCurrent(), 2);
    mutable_vehicle.estimate.height_m = 60;  // the barometer drifts
    pass(3);
    EXPECT_EQ(missionCurrent(), 2);
    mutable_vehicle.armed = true;
    pass();
    EXPECT_EQ(missionCurrent(), 3);
}

TEST_F(MissionFlight, the_end_of_the_mission_is_reported_and_enters_rtl) {
    fly({waypoint(500)});
    (void)statusTexts();
    reach();
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_TRUE(missionComplete());
    EXPECT_TRUE(hasStatusText("Mission complete"));
    EXPECT_EQ(missionCurrent(), 0);
}

TEST_F(MissionFlight, a_mission_without_a_nav_refuses_auto_with_the_reason) {
    ASSERT_EQ(upload({command(181, 0, 1)}), MissionResult::accepted);
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = false;
    (void)statusTexts();
    EXPECT_FALSE(enterAuto());
    EXPECT_EQ(vehicle.mode, Mode::loiter);
    EXPECT_TRUE(hasStatusText("no NAV"));
    mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
    requestMode(Mode::automatic, ModeReason::pilot);
    EXPECT_EQ(vehicle.mode, Mode::rtl) << "in the air it means home";
}

}  // namespace
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// What DO commands change, and for how long.
#include "mission_flight.hpp"

#include <algorithm>

#include "firmware/mission/handlers.hpp"
#include "hal/trace.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace firmware {
using namespace mission;
namespace {

// SERIAL_FORCE would let the radio arm it past the checks.
TEST_F(MissionFlight, nobody_grants_himself_by_a_mission_what_only_usb_may) {
    constexpr uint8_t kForce = 5, kSetParameter = 0xB4;
    EXPECT_EQ(answer(command(kSetParameter, kForce, 1)), static_cast<MissionResult>(7));
    storeImage(2, {{16, 1, 0, 0, 0, 0},
                   {16, 1, 0, 5000, 470050000, 80000000},
                   {kSetParameter, 0, kForce, 1, 0, 0},
                   {16, 1, 0, 5000, 470190000, 80000000}});
    ASSERT_TRUE(enterAuto());
    reach();
    EXPECT_EQ(parameters.force_everywhere, 0);
}

TEST_F(MissionFlight, set_parameter_leaves_sticks_and_servos_alone_while_armed) {
    constexpr uint8_t kElevon = 200;
    fly({waypoint(500), command(180, kElevon, 1), command(180, 102, 0.75f), waypoint(900)});
    statusTexts();
    reach();
    EXPECT_EQ(parameters.elevon_output, 0);
    EXPECT_TRUE(hasStatusText("Mission: parameter 200 not set"));
    EXPECT_FLOAT_EQ(parameters.roll.axis.p, 0.75f);
}

TEST_F(MissionFlight, change_speed_lasts_until_the_mission_restarts_or_ends) {
    fly({waypoint(500), command(178, 0, 16.5f, 60), waypoint(900), waypoint(1500)});
    reach();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 16.5f);
    EXPECT_EQ(vehicle.demand.throttle_pct, 60);
    reach();
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 16.5f);
    requestMode(Mode::loiter, ModeReason::pilot);
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
    mutable_vehicle.estimate.ground_speed_mps = 10;
    reach();
    seconds(60);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 22);
    mutable_vehicle.estimate.ground_speed_mps = 30;
    seconds(60);
    EXPECT_FLOAT_EQ(vehicle.demand.airspeed_mps, 9);
}

TEST_F(MissionFlight, set_home_between_two_waypoints_sets_home_at_the_first) {
    fly({waypoint(500), command(179, 1), waypoint(900)});
    mutable_vehicle.estimate.position = {waypoint(500).x, waypoint(500).y};
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
       an_advance_over_145_actions_takes_several_frames_of_16_records_and_loses_none) {
    Items items = {waypoint(500)};
    for (int i = 0; i < 145; ++i) items.push_back(command(181, 0, float((i + 1) % 2)));
    items.push_back(waypoint(900));
    fly(items);
    const auto actions = [] {
        const auto& marks = fakes::marks();
        return std::count(marks.begin(), marks.end(),
                          hal::kTraceMission + static_cast<int>(::mission::Event::runs));
    };
    const auto before = actions();
    mutable_vehicle.progress.distance_m = 0;
    int tenths = 0;
    for (auto seen = before; missionCurrent() != 147 ||
                             vehicle.demand.to != geo::Position{waypoint(900).x, waypoint(900).y};
         ++tenths) {
        ASSERT_LT(tenths, 20);
        pass();
        EXPECT_LE(actions() - seen, 2 * 16) << "two frames in a tenth of a second";
        seen = actions();
    }
    EXPECT_EQ(actions() - before, 145);
    // looked at once for the NAV behind them and once to be run, 32 records in a tenth
    EXPECT_EQ(tenths, (146 + 145 + 31) / 32);
    EXPECT_TRUE(relayGet());
}

TEST_F(MissionFlight, set_servo_holds_the_output_until_the_mode_changes) {
    fly({waypoint(500), command(183, 5, 1), command(183, 6, 0), command(183, 7, 1234),
         waypoint(900)});
    reach();
    EXPECT_EQ(outputPulse_us(5), 1900);
    EXPECT_EQ(outputPulse_us(6), 1100);
    EXPECT_EQ(outputPulse_us(7), 1234);
    requestMode(Mode::loiter, ModeReason::pilot);
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

}  // namespace
}  // namespace firmware

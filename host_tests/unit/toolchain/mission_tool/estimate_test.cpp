// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/estimate.hpp"

#include <cmath>

#include "mission_tool_rig.hpp"
#include "toolchain/mission_tool/airplane.hpp"
#include "toolchain/mission_tool/flight_table.hpp"

namespace mission_tool {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;

constexpr char kHome[] = "APM 2.0\n0x10 0 0 0 470000000 80000000\n";
constexpr char kNorth[] = "0x10 1 0 6000 470100000 80000000\n";   // 1112 m
constexpr char kHigher[] = "0x10 1 0 9000 470200000 80000000\n";  // 1112 m on, 30 m up
constexpr double kCruise_mps = 13;

const Power& foamTrainer() {
    static const Power power(airplaneNamed(kUsualAirplane));
    return power;
}
Estimate estimated(const std::string& lines, const Wind& wind = {}) {
    const Document document = loaded(kHome + lines);
    return estimate(document, flightOrder(document), foamTrainer(), wind);
}

TEST(GroundSpeed, is_the_side_of_the_triangle_of_the_wind) {
    EXPECT_NEAR(groundSpeed_mps(13, {5, 0}, 0), 8, 1e-9);          // from ahead
    EXPECT_NEAR(groundSpeed_mps(13, {5, 180}, 0), 18, 1e-9);       // from behind
    EXPECT_NEAR(groundSpeed_mps(13, {5, 90}, 0), 12, 1e-9);        // across
    EXPECT_NEAR(groundSpeed_mps(13, {5, 90}, M_PI / 2), 8, 1e-9);  // going east
    EXPECT_NEAR(groundSpeed_mps(13, {5, {}}, 1), 8, 1e-9);         // the worst
    EXPECT_LT(groundSpeed_mps(13, {14, 0}, 0), 0);
    EXPECT_LT(groundSpeed_mps(13, {14, 90}, 0), 0);
}

TEST(Estimate, has_way_time_and_climb_of_every_leg) {
    const Estimate flight = estimated(std::string(kNorth) + kHigher);
    ASSERT_EQ(flight.stretches.size(), 2u);
    const Stretch& second = flight.stretches[1];
    EXPECT_NEAR(second.length_m, 1112, 2);
    EXPECT_NEAR(second.time_s, 1112 / kCruise_mps, 1);
    EXPECT_NEAR(second.needed_climb_mps, 30 / second.time_s, 0.01);
    EXPECT_NEAR(second.height_m, 90, 1e-6);
    EXPECT_NEAR(flight.climbed_m, 90, 1e-6);
    EXPECT_NEAR(flight.farthest_m, 2224, 3);
}

TEST(Estimate, a_headwind_costs_time_and_energy_and_one_that_is_too_strong_stops_it) {
    const Estimate calm = estimated(kNorth), against = estimated(kNorth, {6, 0});
    EXPECT_NEAR(against.time_s, calm.time_s * kCruise_mps / (kCruise_mps - 6), 1);
    EXPECT_GT(against.used_mah, calm.used_mah * 1.5);
    const Estimate never = estimated(kNorth, {14, 0});
    EXPECT_LE(never.stretches[0].ground_mps, 0);
    EXPECT_EQ(never.time_s, 0);
}

TEST(Estimate, a_climb_is_no_steeper_than_the_airplanes) {
    const Estimate flight = estimated("0x10 1 0 50000 470010000 80000000\n");  // 111 m away, 500 m
    const Stretch& leg = flight.stretches[0];
    EXPECT_NEAR(leg.height_m, flight.largest_climb_mps * leg.time_s, 1e-6);
    EXPECT_LE(flight.largest_climb_mps, 4);
    EXPECT_GT(leg.needed_climb_mps, 50);
}

TEST(Estimate, speeds_are_those_that_the_mission_commands) {
    const Estimate slow = estimated(std::string(kNorth) + "0xB2 0 0 10 -1 0\n" + kHigher);
    EXPECT_NEAR(slow.stretches[1].ground_mps, 10, 0.1);
    const Estimate ground = estimated(std::string(kNorth) + "0xB2 0 1 12 -1 0\n" + kHigher, {5, 0});
    EXPECT_NEAR(ground.stretches[1].ground_mps, 12, 0.1);
}

TEST(Estimate, circles_take_their_turns_or_their_time) {
    const std::string place = " 6000 470100000 80000000\n";
    const Estimate turns = estimated(kNorth + ("0x12 1 3" + place));
    EXPECT_NEAR(turns.stretches[1].length_m, 3 * 2 * M_PI * 60, 1);
    EXPECT_NEAR(turns.stretches[1].time_s, 3 * 2 * M_PI * 60 / kCruise_mps, 1);
    const Estimate time = estimated(kNorth + ("0x13 1 6" + place));
    EXPECT_NEAR(time.stretches[1].time_s, 60, 0.1);
    // a tightly banked wing has more drag
    EXPECT_GT(time.stretches[1].used_mah * 3.6 / 60, foamTrainer().battery_a(kCruise_mps, 0));
}

TEST(Estimate, a_change_of_altitude_beside_a_leg_counts_at_its_end) {
    const Estimate flight = estimated(std::string(kNorth) + "0x71 1 200 8000 0 0\n" + kHigher);
    EXPECT_NEAR(flight.stretches[1].height_m, 80, 1e-6);
}

TEST(Power, balances_the_airplane) {
    const double level_a = foamTrainer().battery_a(13, 0);
    EXPECT_GT(level_a, 1);
    EXPECT_LT(level_a, 8);
    EXPECT_GT(foamTrainer().battery_a(13, 2), level_a * 1.3);
    EXPECT_GT(foamTrainer().battery_a(13, 0, 1.4), level_a);
    EXPECT_NEAR(foamTrainer().battery_a(13, -10), 0.3, 0.05);  // the avionics' alone
    EXPECT_GT(foamTrainer().largestClimb_mps(13), 3);
}

class ShowFlight : public Tool {};

TEST_F(ShowFlight, prints_the_flight_its_sums_and_for_what_airplane_in_what_wind) {
    const std::string mission = MISSIONS "/first_flight.waypoints";
    ASSERT_EQ(tool({"show", mission}), 0) << err_;
    EXPECT_THAT(out_, HasSubstr("In the order of the flight, foam_trainer, calm air, estimated:"));
    EXPECT_THAT(out_, HasSubstr("6 DISTANCE, 7 SET_SERVO"));
    EXPECT_THAT(out_, HasSubstr(" mAh of 2200 ("));
    ASSERT_EQ(tool({"show", mission, "--airplane", "trainer_6kg", "--wind", "6,270"}), 0) << err_;
    EXPECT_THAT(out_, HasSubstr("trainer_6kg, 6.0 m/s from 270, estimated:"));
    EXPECT_THAT(out_, HasSubstr(" mAh of 8000 ("));
    ASSERT_EQ(tool({"show", mission, "--airplane", "trainer_6kg"}), 0) << err_;
    EXPECT_THAT(out_, HasSubstr("15.4 m/s"));  // TRIM_ARSPD_CM of its .param file, at 488 m
}

TEST_F(ShowFlight, wrong_airplanes_and_winds_are_refused) {
    const std::string mission = file("m", kTwoWaypoints);
    EXPECT_EQ(tool({"show", mission, "--airplane", "balloon"}), 1);
    EXPECT_THAT(err_, HasSubstr("balloon.json: no such airplane"));
    EXPECT_EQ(tool({"show", mission, "--wind", "31"}), 2);
    EXPECT_THAT(err_, HasSubstr("expected SPEED or SPEED,FROM_DEGREES"));
    EXPECT_EQ(tool({"show", mission, "--wind", "5,361"}), 2);
    EXPECT_EQ(tool({"show", mission, "--wind", "5,"}), 2);
}

}  // namespace
}  // namespace mission_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// Each finding by its item, its number and its limit; and none where all is well.
#include "toolchain/mission_tool/flight_findings.hpp"

#include "firmware/state/parameters.hpp"
#include "flight_conditions.hpp"

namespace mission_tool {
namespace {

using firmware::state::parameters;
using testing::HasSubstr;
using testing::Not;

TEST(FlightFindings, are_none_of_a_mission_as_it_should_be) {
    EXPECT_EQ(found(good(), within(-200, 800, -200, 900)), "");
    EXPECT_EQ(found(good(), inWind(5)), "");
}

TEST(FlightFindings, a_leg_that_leaves_the_fence_and_one_that_comes_near) {
    EXPECT_EQ(found(good(), within(-200, 800, -200, 500)),
              "3: the leg leaves the fence by 108 m\n4: the leg leaves the fence by 108 m\n");
    EXPECT_EQ(found(good(), within(-200, 570, -200, 900)),
              "2: warning: the leg comes within 14 m of the fence, nearer than 20 m\n"
              "3: warning: the leg comes within 14 m of the fence, nearer than 20 m\n"
              "4: warning: the leg comes within 14 m of the fence, nearer than 20 m\n");
}

TEST(FlightFindings, a_circle_that_leaves_the_fence) {
    const std::string circle = "0x12 1 1 6000 470050000 80000000\n";
    EXPECT_EQ(found(good(circle), within(-200, 600, -200, 200)),
              "2: the circle of 60 m leaves the fence by 16 m\n");
}

TEST(FlightFindings, what_the_firmware_refuses_of_a_fence) {
    Conditions conditions = within(-200, 800, -200, 900);
    conditions.fence.areas.push_back({false, {at(400, -100)}, 50});
    conditions.fence.areas.push_back({false, {at(700, 0), at(700, 50), at(750, 0)}, 0});
    conditions.fence.areas.push_back({true, {at(300, 300)}, 10000});
    EXPECT_EQ(found(good(), conditions), "") << "all kinds of zones";
    conditions.fence.areas[1].radius_m = 0.04;
    conditions.fence.areas[2].rim.pop_back();
    conditions.fence.areas[3].radius_m = 10000.5;
    EXPECT_EQ(
        found(good(), conditions),
        "0: fence: the firmware takes circles of 0.1 to 10000 m, one has a radius of 0.04 m\n"
        "0: fence: a polygon has 2 corners, fewer than 3\n"
        "0: fence: the firmware takes circles of 0.1 to 10000 m, one has a radius of 10000.5 m\n");
    conditions = within(-200, 800, -200, 900);
    conditions.fence.areas.resize(17, {false, {at(400, -100)}, 50});
    EXPECT_EQ(found(good(), conditions),
              "0: fence: the firmware takes 20 points, return point included, this has 21\n");
    conditions = within(-200, 800, -200, 900);
    conditions.fence.way_back = at(900, 0);
    EXPECT_EQ(found(good(), conditions),
              "0: fence: its return point is 100 m outside: the fence is not fit\n");
    conditions.fence.way_back.reset();
    EXPECT_EQ(found(good(), conditions),
              "0: warning: fence: it has no return point: broken, it means RTL\n");
    EXPECT_THAT(found(good(), within(100, 800, -200, 900)),
                HasSubstr("0: home lies 100 m outside the fence\n"));
}

// In every zone to stay in, in none to stay out of.
TEST(FlightFindings, a_leg_that_leaves_one_zone_or_enters_another) {
    Conditions conditions = within(-200, 800, -200, 900);
    conditions.fence.areas.push_back({false, {at(300, 30)}, 50});
    EXPECT_THAT(found(good(), conditions), HasSubstr("2: the leg leaves the fence by 20 m\n"));
    conditions = within(-200, 800, -200, 900);
    conditions.fence.areas.push_back({false, {at(300, -50), at(300, 50), at(400, 0)}, 0});
    EXPECT_THAT(found(good(), conditions), HasSubstr("2: the leg leaves the fence by "));
    conditions = within(-200, 800, -200, 900);
    conditions.fence.areas.push_back({true, {at(0, 0)}, 400});
    EXPECT_THAT(found(good(), conditions), HasSubstr("2: the leg leaves the fence by "))
        << "the larger zone does not make up for the smaller one";
}

TEST(FlightFindings, heights_against_the_limits_of_the_fence) {
    const auto limits = [] {
        parameters.fence_min_m = 30;
        parameters.fence_max_m = 55;
        parameters.rtl_height_cm = 4000;
    };
    EXPECT_EQ(found(good(), {}, limits),
              "0: warning: RTL flies at 40 m (ALT_HOLD_RTL), lower than the lowest place of the "
              "mission, 60 m at item 2\n"
              "2: flies at 60 m above home, over FENCE_MAXALT, 55 m\n"
              "3: flies at 60 m above home, over FENCE_MAXALT, 55 m\n"
              "4: flies at 60 m above home, over FENCE_MAXALT, 55 m\n");
    EXPECT_THAT(found(good(), {},
                      [] {
                          parameters.fence_min_m = 0;
                          parameters.fence_max_m = 90;
                      }),
                HasSubstr("0: RTL flies at 100 m (ALT_HOLD_RTL), over FENCE_MAXALT, 90 m\n"));
}

TEST(FlightFindings, a_circle_that_needs_too_much_bank_in_the_wind) {
    const std::string circle = "0x12 1 1 6000 470050000 80000000\n";
    EXPECT_EQ(found(good(circle), inWind(5)), "");
    EXPECT_EQ(
        found(good(circle), inWind(11.5)),
        "2: warning: the circle of 60 m needs 46 degrees of bank at 24.5 m/s over the ground, "
        "more than 45 (LIM_ROLL_CD and the lowest speed)\n");
    EXPECT_THAT(found(good(circle), {}, [] { parameters.loiter_radius_m = -15; }),
                HasSubstr("2: warning: the circle of 15 m needs 49 degrees of bank at 13.0 m/s"));
}

TEST(FlightFindings, a_leg_too_short_for_its_turns) {
    const std::string hook = "0x10 1 0 6000 470050000 80005000\n";  // 38 m east
    EXPECT_THAT(
        found(good(kNorth + hook)),
        HasSubstr("3: warning: the leg of 38 m is shorter than the 51 m that the turns at its ends "
                  "take at 13.0 m/s, planned with 35 of 45 degrees of bank\n"));
}

TEST(FlightFindings, climbs_and_sinks_that_the_airplane_cannot_fly) {
    EXPECT_THAT(found(good("0x10 1 0 40000 470050000 80000000\n")),
                HasSubstr("2: warning: needs a climb of 10.7 m/s (a gradient of 82 %), more than "
                          "4.0 (TECS_CLMB_MAX): arrives at 181 m, not 400\n"));
    EXPECT_THAT(found(good(std::string(kNorth) + "0x10 1 0 30000 470050000 80400000\n"
                                                 "0x10 1 0 1000 470050000 80450000\n")),
                HasSubstr("4: warning: needs a sink of "));
}

TEST(FlightFindings, a_leg_that_the_wind_forbids) {
    EXPECT_THAT(
        found(good(), inWind(14)),
        HasSubstr("2: is not reached: the wind of 14.0 m/s against an airspeed of 13.0 m/s"));
}

TEST(FlightFindings, neither_takeoff_nor_landing) {
    EXPECT_EQ(found(kHome + std::string(kNorth)),
              "1: warning: no TAKEOFF before it: the flight begins with WAYPOINT\n"
              "1: warning: no LAND: the mission ends in RTL\n");
}

TEST(FlightFindings, a_flight_that_is_longer_than_what_is_looked_at) {
    const std::string all = found(good(std::string(kNorth) + kEast + "0xB1 0 2 0 32767 0\n"));
    EXPECT_THAT(all,
                HasSubstr("warning: more than 5000 NAVs are flown: what follows is not looked at"));
    EXPECT_THAT(all, Not(HasSubstr("no LAND")));
}

TEST(FlightFindings, far_places_and_a_battery_that_does_not_last) {
    const std::string far = "0x10 1 0 6000 471000000 80000000\n";  // 11.1 km, and back
    EXPECT_THAT(found(good(far)),
                HasSubstr("2: warning: 11117 m from home, farther than 5000 m (--range)\n"));
    const std::string circle = "0x12 1 1 6000 470447000 80000000\n";  // 4,970 m
    EXPECT_THAT(found(good(circle)),
                HasSubstr("2: warning: 5029 m from home, farther than 5000 m (--range)\n"));
    std::string laps;
    for (int i = 0; i < 4; ++i) laps += far + kNorth;
    EXPECT_THAT(found(good(laps)), HasSubstr("0: the flight takes "));
    EXPECT_THAT(found(good(laps)), HasSubstr(" mAh, more than the battery's 2200\n"));
}

TEST(FlightFindings, a_leg_longer_than_half_the_globe) {
    const std::string around = "0x10 1 0 6000 -470000000 -1000000000\n";
    EXPECT_THAT(found(good(around)), Not(HasSubstr("half the globe")));
    const std::string antipode = "0x10 1 0 6000 -890000000 -1000000000\n";
    EXPECT_THAT(found("APM 2.0\n0x10 0 0 0 890000000 800000000\n" + std::string(kTakeoff) +
                      antipode + kLand),
                HasSubstr("longer than half the globe, 20004 km"));
}

TEST(FlightFindings, jumps_in_a_circle_with_nothing_between) {
    const std::string circle = "0xB1 0 4 0 5 0\n0xB5 0 0 1 0 0\n0xB1 0 2 0 -1 0\n";
    EXPECT_THAT(found(kHome + std::string(kNorth) + circle + kEast),
                HasSubstr("2: warning: jumps in a circle, 2 to 4 to 2, with neither a NAV nor a "
                          "CONDITION on the way"));
    EXPECT_THAT(found(kHome + std::string(kNorth) + circle + kEast), Not(HasSubstr("4 to 2 to 4")));
    const std::string waits = "0xB1 0 4 0 5 0\n0x70 0 0 0 5 0\n0xB1 0 3 0 -1 0\n";
    EXPECT_THAT(found(kHome + std::string(kNorth) + waits + kEast), Not(HasSubstr("circle,")));
    EXPECT_THAT(found(apm1("0x10 0 6000 470100000 80000000\n0x75 0 3 0 0\n0x75 0 2 0 0\n")),
                Not(HasSubstr("circle,")))
        << "of jumps without a count every verb says it";
}

class Check : public Tool {};

TEST_F(Check, says_each_finding_with_its_item_and_fails_for_errors_alone) {
    EXPECT_EQ(tool({"check", file("m", kTwoWaypoints)}), 0);
    EXPECT_THAT(err_, HasSubstr("m:3:1: warning: item 1: no TAKEOFF before it"));
    EXPECT_THAT(out_, HasSubstr(": the firmware takes it\n"));

    const std::string mission = MISSIONS "/first_flight.waypoints";
    EXPECT_EQ(tool({"check", mission, "--fence", MISSIONS "/survey.plan"}), 0) << err_;
    EXPECT_EQ(err_, "");
    EXPECT_EQ(tool({"check", mission, "--wind", "14"}), 1);
    EXPECT_THAT(err_, HasSubstr(":4:1: item 2: is not reached: the wind of 14.0 m/s"));
    EXPECT_THAT(out_, HasSubstr("takes it, but it cannot be flown as it is written\n"));
    EXPECT_EQ(tool({"check", mission, "--fence", mission}), 1);
    EXPECT_THAT(err_, HasSubstr(": has no fence\n"));
}

}  // namespace
}  // namespace mission_tool

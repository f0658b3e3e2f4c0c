// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/waypoints.hpp"

#include <gmock/gmock.h>

using namespace simulator;
using testing::HasSubstr;
using testing::StartsWith;

static const std::string kHome = "0\t1\t0\t16\t0\t0\t0\t0\t47.3977\t8.5456\t488\t1\n";
static const std::string kTakeoff = "1 0 3 22 15 0 0 0 0 0 40 1\n";

static std::string refusal(const std::string& text) {
    try {
        parseWaypoints(text, "m.txt");
    } catch (const WaypointError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Waypoints, reads_every_column) {
    const auto items = parseWaypoints(
        "QGC WPL 110\r\n" + kHome + "1\t0\t3\t16\t1\t30\t-1\t0.5\t-47.5\t8.25\t60.5\t0\r\n", "m");

    ASSERT_EQ(items.size(), 2u);
    EXPECT_TRUE(items[0].current);
    EXPECT_EQ(items[1].command, 16);
    EXPECT_EQ(items[1].frame, 3);
    EXPECT_EQ(items[1].params[1], 30);
    EXPECT_EQ(items[1].params[3], 0.5);
    EXPECT_EQ(items[1].latitude_deg, -47.5);
    EXPECT_EQ(items[1].altitude_m, 60.5);
    EXPECT_FALSE(items[1].autocontinue);
}

TEST(Waypoints, takes_spaces_blank_lines_and_comments) {
    const auto items = parseWaypoints("QGC WPL 110\n" + kHome + "\n# climb\n" + kTakeoff, "m");

    EXPECT_EQ(items.size(), 2u);
}

TEST(Waypoints, takes_nan_as_a_parameter_and_nowhere_else) {
    EXPECT_TRUE(
        std::isnan(parseWaypoints("QGC WPL 110\n" + kHome + "1 0 3 16 0 0 0 nan 1 1 40 1\n", "m")[1]
                       .params[3]));
    EXPECT_THAT(refusal("QGC WPL 110\n" + kHome + "1 0 3 16 0 0 0 0 nan 1 40 1\n"),
                StartsWith("m.txt:3:18: expected a latitude"));
}

TEST(Waypoints, refuses_another_kind_of_file) {
    EXPECT_EQ(refusal("QGC WPL 120\n" + kHome),
              "m.txt:1:1: expected 'QGC WPL 110', found 'QGC WPL 120'");
    EXPECT_THAT(refusal(""), StartsWith("m.txt:1:1: expected 'QGC WPL 110'"));
}

TEST(Waypoints, names_the_column_that_is_wrong) {
    const std::string good = "QGC WPL 110\n" + kHome;

    EXPECT_EQ(refusal(good + "1 0 3 16 0 0 0 0 47.4 east 40 1\n"),
              "m.txt:3:23: expected a longitude, -180 to 180 degrees, found 'east'");
    EXPECT_EQ(refusal(good + "1 0 3 16 0 0 0 0 97.4 8 40 1\n"),
              "m.txt:3:18: expected a latitude, -90 to 90 degrees, found '97.4'");
    EXPECT_EQ(refusal(good + "1 0 3 16.5 0 0 0 0 47 8 40 1\n"),
              "m.txt:3:7: expected a command number, 1 to 65535, found '16.5'");
    EXPECT_EQ(refusal(good + "1 0 3 16 0 0 0\n"),
              "m.txt:3:15: expected a number as parameter, found the end of the line");
    EXPECT_EQ(refusal(good + "1 0 3 16 0 0 0 0 47 8 40 1 7\n"),
              "m.txt:3:28: expected the end of the line, found '7'");
}

TEST(Waypoints, refuses_items_out_of_order) {
    EXPECT_THAT(refusal("QGC WPL 110\n" + kHome + "2 0 3 22 15 0 0 0 0 0 40 1\n"),
                HasSubstr("3:1: expected index 1"));
}

TEST(Waypoints, refuses_a_mission_of_home_alone) {
    EXPECT_THAT(refusal("QGC WPL 110\n" + kHome), HasSubstr("at least one mission item"));
}

TEST(Waypoints, says_that_a_file_is_not_there) {
    EXPECT_THROW(readWaypoints("/nowhere/at.all"), WaypointError);
}

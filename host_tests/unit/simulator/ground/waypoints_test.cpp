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
    EXPECT_EQ(refusal(""), "m.txt: the file is empty");
    EXPECT_EQ(refusal(std::string("QGC\0\1\2", 6)), "m.txt: not a text file");
    EXPECT_EQ(refusal("\x1b[2J\xff\n"), "m.txt:1:1: expected 'QGC WPL 110', found '?[2J?'");
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

TEST(Waypoints, lists_every_error_at_once) {
    EXPECT_EQ(refusal("QGC WPL 110\n" + kHome +
                      "1 0 3 16 0 0 0 0 97.4 east 40 1\n"
                      "2 0 3 16 0 0 0 0 47 8 40 1\n"
                      "3 0 3 \x07 0 0 0 0 47 8 40\n"),
              "m.txt:3:18: expected a latitude, -90 to 90 degrees, found '97.4'\n"
              "m.txt:3:23: expected a longitude, -180 to 180 degrees, found 'east'\n"
              "m.txt:5:7: expected a command number, 1 to 65535, found '?'\n"
              "m.txt:5:24: expected autocontinue: 0 or 1, found the end of the line");
}

TEST(Waypoints, lists_fifty_errors_and_how_many_more_there_are) {
    std::string text = "QGC WPL 110\n" + kHome;
    for (int i = 1; i <= 63; ++i) text += std::to_string(i) + " 0 3 16 0 0 0 0 47 east 40 1\n";
    const std::string message = refusal(text);
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 50);
    EXPECT_THAT(message, testing::EndsWith("\nand 13 more"));
}

// One line is missing: every index behind it is right in itself.
TEST(Waypoints, reports_a_missing_index_once) {
    std::string text = "QGC WPL 110\n" + kHome;
    for (int i : {1, 3, 4, 5}) text += std::to_string(i) + " 0 3 16 0 0 0 0 47 8 40 1\n";
    EXPECT_EQ(refusal(text), "m.txt:4:1: expected index 2, found '3'");
}

TEST(Waypoints, are_read_as_any_editor_saves_them) {
    const std::string plain = "QGC WPL 110\r\n" + kHome + kTakeoff;
    std::string little = "\xFF\xFE", big = "\xFE\xFF";
    for (const char letter : plain) {
        little += {letter, '\0'};
        big += {'\0', letter};
    }
    for (const std::string& text : {"\xEF\xBB\xBF" + plain, little, big})
        EXPECT_EQ(parseWaypoints(text, "m").size(), 2u);
    EXPECT_EQ(refusal("\xEF\xBB\xBF"
                      "QGC WPL 120\n"),
              "m.txt:1:1: expected 'QGC WPL 110', found 'QGC WPL 120'");
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
    EXPECT_THROW(readWaypoints("/tmp"), WaypointError);
}

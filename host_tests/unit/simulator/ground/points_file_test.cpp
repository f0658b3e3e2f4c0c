// SPDX-License-Identifier: GPL-3.0-or-later
// Files of fence and rally points as Mission Planner writes them.
#include "simulator/ground/points_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace simulator;
using testing::HasSubstr;

constexpr char kFen[] =
    "#saved by APM Planner 1.3.80\n"
    "47.001 8.002\n"
    "47 8\n47 8.004\n47.004 8.004\n47.004 8\n47 8\n";
constexpr char kRal[] =
    "#saved by Mission Planner 1.3.80\n"
    "RALLY\t47.001\t8.002\t60\t0\t0\t0\n"
    "RALLY\t47.003\t8.001\t80\t40\t0\t1\n";

std::string problems(const std::string& text) {
    try {
        (void)parsePoints(text, "f");
    } catch (const WaypointError& error) {
        return error.what();
    }
    return "";
}

TEST(PointsFile, a_fen_begins_with_the_return_point_and_ends_where_the_rim_begins) {
    const MissionFile file = parsePoints(kFen, "f.fen");
    ASSERT_EQ(file.fence.areas.size(), 1u);
    EXPECT_TRUE(file.fence.areas[0].inclusion);
    ASSERT_EQ(file.fence.areas[0].rim.size(), 4u);
    EXPECT_EQ(file.fence.areas[0].rim[0].latitude_deg, 47);
    EXPECT_EQ(file.fence.areas[0].rim[3].longitude_deg, 8);
    ASSERT_TRUE(file.fence.way_back);
    EXPECT_EQ(file.fence.way_back->longitude_deg, 8.002);
}

TEST(PointsFile, mavproxy_writes_no_comment_and_tabs) {
    const MissionFile file = parsePoints("47.001\t8.002\n47\t8\n47\t8.004\n47.004\t8.004\n", "f");
    EXPECT_EQ(file.fence.areas.at(0).rim.size(), 3u);
    EXPECT_TRUE(file.fence.way_back);
}

TEST(PointsFile, a_poly_has_no_return_point) {
    const MissionFile file = parsePoints(
        "#saved by Mission Planner 1.3.80\r\n47 8\r\n47 8.004\r\n47.004 8.004\r\n47 8\r\n",
        "f.poly");
    EXPECT_EQ(file.fence.areas.at(0).rim.size(), 3u);
    EXPECT_FALSE(file.fence.way_back);
}

TEST(PointsFile, a_ral_has_places_and_heights) {
    const MissionFile file = parsePoints(kRal, "f.ral");
    ASSERT_EQ(file.rally.size(), 2u);
    EXPECT_EQ(file.rally[1].place.latitude_deg, 47.003);
    EXPECT_EQ(file.rally[1].height_m, 80);
    EXPECT_FALSE(file.fence.given());
}

TEST(PointsFile, items_of_the_mission_protocol_are_taken_from_a_waypoint_file) {
    const MissionFile file = parsePoints(
        "QGC WPL 110\n0 1 0 16 0 0 0 0 47 8 400 1\n"
        "1 0 3 5001 3 0 0 0 47 8 0 1\n2 0 3 5001 3 0 0 0 47 8.004 0 1\n"
        "3 0 3 5001 3 0 0 0 47.004 8.004 0 1\n4 0 3 5002 3 0 0 0 47.001 8.001 0 1\n"
        "5 0 3 5002 3 0 0 0 47.001 8.002 0 1\n6 0 3 5002 3 0 0 0 47.002 8.002 0 1\n"
        "7 0 3 5003 90 0 0 0 47.001 8.001 0 1\n8 0 3 5004 30 0 0 0 47.002 8.001 0 1\n"
        "9 0 3 5000 0 0 0 0 47.001 8.003 0 1\n10 0 3 5100 0 0 0 0 47.001 8.002 55 1\n",
        "f.waypoints");
    ASSERT_EQ(file.fence.areas.size(), 4u);
    EXPECT_EQ(file.fence.areas[0].rim.size(), 3u);
    EXPECT_FALSE(file.fence.areas[1].inclusion);
    EXPECT_TRUE(file.fence.areas[2].inclusion);
    EXPECT_EQ(file.fence.areas[2].radius_m, 90);
    EXPECT_FALSE(file.fence.areas[3].inclusion);
    EXPECT_EQ(file.fence.way_back->longitude_deg, 8.003);
    ASSERT_EQ(file.rally.size(), 1u);
    EXPECT_EQ(file.rally[0].height_m, 55);
}

TEST(PointsFile, what_is_written_is_read_back) {
    const MissionFile fence = parsePoints(kFen, "f"), rally = parsePoints(kRal, "f");
    const std::string text = fenceAsPoints(fence.fence);
    const MissionFile again = parsePoints(text, "f");
    EXPECT_EQ(fenceAsPoints(again.fence), text);
    EXPECT_EQ(again.fence.areas.at(0).rim.size(), 4u);
    EXPECT_EQ(again.fence.way_back->latitude_deg, 47.001);
    EXPECT_EQ(parsePoints(rallyAsPoints(rally.rally), "f").rally.at(1).height_m, 80);
    Fence circle;
    circle.areas.push_back({true, {{47, 8}}, 50});
    circle.way_back = Place{47, 8};
    EXPECT_EQ(fenceAsPoints(circle), "");
}

TEST(PointsFile, errors_name_line_and_value) {
    EXPECT_EQ(problems("47 8\n47 8\n97 8.004\n47.1 8.1\n"),
              "f:3:1: expected a latitude, -90 to 90 degrees, found '97'");
    EXPECT_EQ(problems("47 8\n47 8\n47 8.1 50\n47.1 8.1\n47.1 8\n"),
              "f:3:1: expected a latitude and a longitude, found '47'");
    EXPECT_EQ(problems("47 8\n47 8\n47 8.1\n"),
              "f:3:1: expected at least three corners of a fence, found '2'");
    EXPECT_EQ(problems("RALLY 47 8\n"), "f:1:1: expected an altitude in metres, found ''");
    EXPECT_THAT(problems("what is this\n"), HasSubstr("expected"));
    EXPECT_THAT(problems(""), HasSubstr("the file is empty"));
}

}  // namespace

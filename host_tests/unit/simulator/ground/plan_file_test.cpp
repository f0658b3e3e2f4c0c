// SPDX-License-Identifier: GPL-3.0-or-later
// Files of QGroundControl by its documentation of the format ("Plan File Format").
#include "simulator/ground/plan_file.hpp"

#include <gmock/gmock.h>

#include <cmath>

using namespace simulator;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

std::string simple(int id, int command, const std::string& params, int frame = 3) {
    return R"({"type":"SimpleItem","autoContinue":true,"command":)" + std::to_string(command) +
           R"(,"doJumpId":)" + std::to_string(id) + R"(,"frame":)" + std::to_string(frame) +
           R"(,"params":[)" + params + "]}";
}
std::string waypoint(int id) { return simple(id, 16, "0,0,0,null,47.4,8.5,60"); }

std::string complex(const std::string& type, const std::string& rest) {
    return R"({"type":"ComplexItem","complexItemType":")" + type + R"(","version":2)" + rest + "}";
}
std::string stored(const std::string& items) {
    return R"(,"TransectStyleComplexItem":{"version":2,"Items":[)" + items + "]}";
}

std::string plan(const std::string& items, const std::string& rest = "",
                 const std::string& home = "[47.3977,8.5456,488]") {
    return R"({"fileType":"Plan","version":1,"groundStation":"QGroundControl",
"mission":{"version":2,"firmwareType":3,"vehicleType":1,"cruiseSpeed":15,"hoverSpeed":5,
"plannedHomePosition":)" +
           home + ",\"items\":[\n" + items + "]}" + rest + "}";
}

MissionFile read(const std::string& text) { return readPlan(text, "m.plan"); }
std::string problems(const std::string& text) {
    std::string all;
    for (const LineError& error : read(text).errors) all += (all.empty() ? "" : "\n") + error.text;
    return all;
}
std::vector<int> commands(const MissionFile& mission) {
    std::vector<int> all;
    for (const WaypointItem& item : mission.items) all.push_back(item.command);
    return all;
}

}  // namespace

TEST(PlanFile, gives_home_and_simple_items) {
    const MissionFile mission =
        read(plan(simple(1, 22, "15,0,0,null,0,0,45") + ",\n" + waypoint(2)));

    ASSERT_TRUE(mission.errors.empty());
    ASSERT_EQ(mission.items.size(), 3u);
    EXPECT_EQ(mission.items[0].frame, 0);
    EXPECT_EQ(mission.items[0].altitude_m, 488);
    EXPECT_EQ(mission.items[1].params[0], 15);
    EXPECT_TRUE(std::isnan(mission.items[1].params[3]));
    EXPECT_EQ(mission.items[2].index, 2);
    EXPECT_EQ(mission.items[2].frame, 3);
    EXPECT_EQ(mission.items[2].latitude_deg, 47.4);
    EXPECT_EQ(mission.items[2].longitude_deg, 8.5);
    EXPECT_EQ(mission.items[2].altitude_m, 60);
    EXPECT_EQ(mission.items[2].line, 5);
}

TEST(PlanFile, flies_what_a_survey_and_a_corridor_have_stored) {
    const MissionFile mission = read(plan(
        waypoint(1) + "," + complex("survey", stored(waypoint(2) + "," + waypoint(3))) + "," +
        complex("CorridorScan", stored(simple(4, 206, "25,0,1,0,0,0,0", 2))) + "," + waypoint(5)));

    EXPECT_EQ(problems(plan(waypoint(1))), "");
    EXPECT_THAT(commands(mission), ElementsAre(16, 16, 16, 16, 206, 16));
    EXPECT_EQ(mission.items[5].index, 5);
}

TEST(PlanFile, expands_a_landing_pattern_as_qgroundcontrol_sends_it) {
    const std::string rest =
        R"(,"altitudesAreRelative":true,"landCoordinate":[47,8,2],"landingApproachCoordinate":[47.01,8.01,40],
"loiterClockwise":false,"loiterRadius":75,"stopTakingPhotos":true,"stopVideoPhotos":false,)";
    const MissionFile circled =
        read(plan(complex("fwLandingPattern", rest + R"("useLoiterToAlt":true)")));

    ASSERT_TRUE(circled.errors.empty());
    EXPECT_TRUE(circled.remarks.empty());
    EXPECT_THAT(commands(circled), ElementsAre(16, 189, 206, 31, 21));
    EXPECT_THAT(circled.items[3].params, ElementsAre(1, -75, 0, 1));
    EXPECT_EQ(circled.items[3].altitude_m, 40);
    EXPECT_EQ(circled.items[4].frame, 3);
    EXPECT_EQ(circled.items[4].altitude_m, 2);

    const MissionFile straight =
        read(plan(complex("fwLandingPattern", rest + R"("useLoiterToAlt":false)")));
    EXPECT_THAT(commands(straight), ElementsAre(16, 189, 206, 16, 21));
    EXPECT_EQ(straight.items[4].frame, 3);

    const std::string above_sea =
        rest.substr(rest.find(",\"landCoordinate")) + R"("altitudesAreRelative":false)";
    const MissionFile absolute = read(plan(complex("fwLandingPattern", above_sea)));
    ASSERT_TRUE(absolute.errors.empty());
    EXPECT_EQ(absolute.items[3].frame, 0);
    EXPECT_EQ(absolute.items[4].frame, 0);
}

TEST(PlanFile, says_what_of_a_landing_pattern_it_leaves_out) {
    const MissionFile mission = read(plan(complex(
        "fwLandingPattern", R"(,"landCoordinate":[47,8,0],"landingApproachCoordinate":[47,8.01,40],
"loiterRadius":75,"stopVideoPhotos":true)")));
    ASSERT_EQ(mission.remarks.size(), 1u);
    EXPECT_THAT(mission.remarks[0].text, HasSubstr("stops a video is left out"));
}

TEST(PlanFile, a_jump_goes_to_the_item_that_has_its_id) {
    const std::string survey = complex("survey", stored(waypoint(71) + "," + waypoint(72)));
    const MissionFile mission = read(plan(waypoint(1) + "," + survey + "," + waypoint(40) + "," +
                                          simple(41, 177, "40,2,0,0,0,0,0", 2)));
    ASSERT_TRUE(mission.errors.empty());
    EXPECT_EQ(mission.items[5].params[0], 4);

    EXPECT_EQ(problems(plan(waypoint(1) + ",\n" + simple(2, 177, "9,2,0,0,0,0,0", 2))),
              "m.plan:5:1: item 2: no item has the doJumpId 9 that this jump goes to");
}

TEST(PlanFile, an_item_that_cannot_be_flown_is_named_by_its_number_and_type) {
    EXPECT_EQ(problems(plan(waypoint(1) + ",\n" + complex("StructureScan", ""))),
              "m.plan:5:1: item 2: a complex item of type '\"StructureScan\"' in which no commands "
              "are stored (TransectStyleComplexItem.Items): only QGroundControl can make them");
    EXPECT_EQ(problems(plan(waypoint(1) + ",\n" + complex("vtolLandingPattern", ""))),
              "m.plan:5:1: item 2: expected a complex item of type survey, CorridorScan, "
              "StructureScan or fwLandingPattern, found '\"vtolLandingPattern\"'");
    EXPECT_THAT(problems(plan(R"({"type":"Item"})")),
                HasSubstr("item 1: expected \"type\": \"SimpleItem\" or \"ComplexItem\""));
}

TEST(PlanFile, a_wrong_value_is_named_by_its_item) {
    const auto problem = [](const std::string& item) { return problems(plan(item)); };
    EXPECT_EQ(problem(simple(1, 16, "0,0,0,0,97,8,60")),
              "m.plan:4:87: item 1: expected a latitude, -90 to 90 degrees, found '97'");
    EXPECT_THAT(problem(simple(1, 16, "0,0,0,0,47,8,null")), HasSubstr("an altitude in metres"));
    EXPECT_THAT(problem(simple(1, 16, "0,0,0,0,47,8")), HasSubstr("\"params\" of seven numbers"));
    EXPECT_THAT(problem(simple(1, 0, "0,0,0,0,47,8,60")),
                HasSubstr("command, 1 to 65535, found '0'"));
    EXPECT_THAT(problem(simple(1, 16, "\"a\",0,0,0,47,8,60")),
                HasSubstr("as parameter, found '\"a\"'"));
    EXPECT_THAT(problems(plan(waypoint(1), "", "[47,8]")),
                HasSubstr("plannedHomePosition: expected"));
    EXPECT_THAT(problems(plan("")), HasSubstr("expected at least one item"));
}

TEST(PlanFile, other_json_and_what_is_none_are_distinguished) {
    EXPECT_EQ(
        problems("{\"a\":1}"),
        "m.plan:1:1: expected a .plan of QGroundControl (\"fileType\": \"Plan\"), found other "
        "JSON");
    EXPECT_THAT(problems(R"({"MAV_AUTOPILOT":3,"items":[]})"), HasSubstr("QGroundControl before"));
    EXPECT_THAT(problems(R"({"type":"FeatureCollection"})"), HasSubstr("GeoJSON"));
    EXPECT_EQ(problems("{\"a\":\n  x}"), "m.plan:2:3: expected JSON, found 'x}'");
    EXPECT_EQ(problems("{\"a\":"), "m.plan:1:6: expected JSON, found the end of the file");
    EXPECT_THAT(problems("{\"a\":1e999}"), HasSubstr("a number that can be held"));
    EXPECT_THAT(problems("{\"a\":{},\"a\":{}}"), HasSubstr("found one twice"));
    EXPECT_THAT(problems(std::string(100'000, '[')), HasSubstr("50 levels"));
    std::string long_list = "[", many_keys = "{";
    for (int i = 0; i < 6000; ++i) {
        long_list += "[],\n";
        many_keys += "\"k" + std::to_string(i) + "\":1,";
    }
    EXPECT_THAT(problems(long_list), HasSubstr("m.plan:5001:1: expected at most 5000"));
    EXPECT_THAT(problems(many_keys), HasSubstr("expected at most 1000 keys"));
    EXPECT_THAT(problems(R"({"fileType":"Plan","version":7})"), HasSubstr("expected version 1"));
}

// By its MissionFile.cs of several years: neither fileType nor types and versions, and params of
// four with the coordinate beside them.
TEST(PlanFile, of_mission_planner_is_read_whatever_it_leaves_out) {
    const MissionFile mission = read(R"({"fileType":null,"geoFence":null,
"groundStation":"MissionPlanner","mission":{"cruiseSpeed":0,"firmwareType":0,"hoverSpeed":0,"items":[
{"autoContinue":false,"command":22,"coordinate":[0,0,40],"doJumpId":0,"frame":3,"params":[15,0,0,0],
"type":null,"camera":null},
{"command":16,"coordinate":[47.1,8.1,60],"doJumpId":0,"frame":3,"params":[0,0,0,0],"type":null},
{"command":177,"doJumpId":0,"frame":3,"params":[2,3,0,0,0,0,0],"type":null}],
"plannedHomePosition":[47,8,400],"vehicleType":0,"version":0},"rallyPoints":null,"version":1})");
    ASSERT_TRUE(mission.errors.empty()) << mission.errors[0].text;
    ASSERT_EQ(mission.items.size(), 4u);
    EXPECT_EQ(mission.items[0].altitude_m, 400);
    EXPECT_EQ(mission.items[1].params[0], 15);
    EXPECT_EQ(mission.items[2].longitude_deg, 8.1);
    EXPECT_EQ(mission.items[2].altitude_m, 60);
    EXPECT_EQ(mission.items[3].params[0], 2) << "jumps go to items by number";
    EXPECT_TRUE(mission.remarks.empty());
}

TEST(PlanFile, of_mission_planner_has_fence_and_rally_points_and_its_errors) {
    const std::string begin = R"({"groundStation":"MissionPlanner","version":1,
"mission":{"version":0,"plannedHomePosition":[47,8,400],"items":[
{"command":16,"coordinate":[)",
                      rest = R"(,8.1,60],"frame":3,"params":[0,0,0,0]}]},
"geoFence":{"breachReturn":[47.1,8.1],"polygon":[[47,8],[47,8.2],[47.2,8]],"version":0},
"rallyPoints":{"points":[[47.1,8.1,50]],"version":0}})";
    const MissionFile mission = read(begin + "47.1" + rest);
    ASSERT_TRUE(mission.errors.empty()) << mission.errors[0].text;
    EXPECT_EQ(mission.fence.areas.at(0).rim.size(), 3u);
    EXPECT_TRUE(mission.fence.way_back);
    EXPECT_EQ(mission.rally.size(), 1u);
    EXPECT_EQ(problems(begin + "97.1" + rest),
              "m.plan:3:1: item 1: expected a latitude, -90 to 90 degrees, found '97.1'");
}

TEST(PlanFile, has_fence_and_rally_points) {
    const MissionFile mission = read(plan(waypoint(1), R"(,"geoFence":{"version":2,
"breachReturn":[47.1,8.1],"polygons":[{"version":1,"inclusion":true,"polygon":[[1,2],[3,4],[5,6]]}],
"circles":[{"version":1,"inclusion":false,"circle":{"center":[7,8],"radius":90}}]},
"rallyPoints":{"version":2,"points":[[47.2,8.2,70]]})"));

    ASSERT_TRUE(mission.errors.empty());
    ASSERT_EQ(mission.fence.areas.size(), 2u);
    EXPECT_EQ(mission.fence.areas[0].rim.size(), 3u);
    EXPECT_TRUE(mission.fence.areas[0].inclusion);
    EXPECT_EQ(mission.fence.areas[1].radius_m, 90);
    EXPECT_FALSE(mission.fence.areas[1].inclusion);
    ASSERT_EQ(mission.rally.size(), 1u);
    EXPECT_EQ(mission.rally[0].height_m, 70);

    const Waypoints fence = fenceItems(mission.fence);
    ASSERT_EQ(fence.size(), 5u);
    EXPECT_EQ(fence[2].command, 5001);
    EXPECT_EQ(fence[2].params[0], 3);
    EXPECT_EQ(fence[2].index, 2);
    EXPECT_EQ(fence[3].command, 5004);
    EXPECT_EQ(fence[3].params[0], 90);
    EXPECT_EQ(fence[4].command, 5000);
    const Waypoints rally = rallyItems(mission.rally);
    EXPECT_EQ(rally.at(0).command, 5100);
    EXPECT_EQ(rally.at(0).frame, 3);
}

TEST(PlanFile, fence_and_rally_points_have_a_version) {
    EXPECT_THAT(problems(plan(waypoint(1), R"(,"rallyPoints":{"points":[]})")),
                HasSubstr("rallyPoints: expected version 2, found nothing"));
    EXPECT_THAT(problems(plan(waypoint(1), R"(,"geoFence":{"version":3})")),
                HasSubstr("geoFence: expected version 2, found '3'"));
    const MissionFile first = read(
        plan(waypoint(1),
             R"(,"geoFence":{"version":1,"polygon":[[1,2],[3,4],[5,6]],"breachReturn":[3,4]})"));
    EXPECT_TRUE(first.errors.empty());
    ASSERT_EQ(first.fence.areas.size(), 1u);
    EXPECT_EQ(first.fence.areas[0].rim.size(), 3u);
}

TEST(PlanFile, a_fence_of_two_corners_is_none) {
    EXPECT_THAT(
        problems(plan(waypoint(1), R"(,"geoFence":{"version":2,"polygons":[
{"version":1,"inclusion":true,"polygon":[[1,2],[3,4]]}]})")),
        HasSubstr("m.plan:5:41: geoFence, polygon: expected at least three corners, found 2"));
}

TEST(PlanFile, what_is_written_is_read_back) {
    const MissionFile mission =
        read(plan(waypoint(1) + "," + simple(2, 177, "1,3,0,0,0,0,0", 2),
                  R"(,"geoFence":{"version":2,"polygons":[{"version":1,"inclusion":false,
"polygon":[[1,2],[3,4],[5,6.25]]}],"circles":[{"version":1,"inclusion":true,"circle":{"center":[7,8],
"radius":90}}],"breachReturn":[1,2]},"rallyPoints":{"version":2,"points":[[47.2,8.2,70]]})"));
    ASSERT_TRUE(mission.errors.empty());
    const MissionFile again = read(planOf(mission, 13));
    ASSERT_TRUE(again.errors.empty());

    EXPECT_EQ(commands(again), commands(mission));
    EXPECT_EQ(again.items[2].params[0], 1);
    EXPECT_TRUE(std::isnan(again.items[1].params[3]));
    EXPECT_EQ(again.items[0].altitude_m, 488);
    ASSERT_EQ(again.fence.areas.size(), 2u);
    EXPECT_EQ(again.fence.way_back->longitude_deg, 2);
    EXPECT_EQ(planOf(again, 13), planOf(mission, 13));
}

TEST(MissionFile, is_recognised_by_what_it_holds) {
    const auto problem = [](const std::string& bytes) {
        const MissionFile mission = readMissionLines(bytes, "m");
        return mission.errors.empty() ? "" : mission.errors[0].text;
    };
    EXPECT_EQ(problem("\xEF\xBB\xBF" + plan(waypoint(1))), "");
    EXPECT_THAT(problem("<?xml version=\"1.0\"?>\n<kml xmlns=\"a\">"),
                HasSubstr("found a KML file"));
    EXPECT_THAT(problem("PK\x03\x04 abc"), HasSubstr("found a compressed file"));
    EXPECT_EQ(problem("hello"), "m:1:1: expected 'QGC WPL 110', found 'hello'");
    std::string wide;
    for (const char c : std::string("QGC WPL 110\n")) wide += {c, '\0'};
    EXPECT_EQ(problem(wide), "m: UTF-16 without a byte order mark: save it as UTF-8");
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Plans of QGroundControl as missions, and missions as plans.
#include "toolchain/mission_tool/waypoint_form.hpp"
#include "mission_tool_rig.hpp"
#include "simulator/input_file.hpp"

namespace mission_tool {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

constexpr char kSurvey[] = MISSIONS "/survey.plan";

std::string planWith(const std::string& items) {
    return R"({"fileType":"Plan","version":1,"groundStation":"QGroundControl","mission":{"version":2,
"firmwareType":3,"vehicleType":1,"plannedHomePosition":[47,8,400],"items":[
)" + items +
           "]}}";
}
std::string item(int command, const std::string& params) {
    return R"({"type":"SimpleItem","command":)" + std::to_string(command) +
           R"(,"doJumpId":1,"frame":3,"params":[)" + params + "]}";
}

class Plan : public Tool {};

TEST_F(Plan, of_a_survey_is_taken_by_the_firmware) {
    EXPECT_EQ(tool({"check", kSurvey}), 0) << err_;
    const Document document = loaded(*simulator::wholeFile(kSurvey));
    EXPECT_EQ(document.entries.size(), 28u);
    EXPECT_EQ(document.fence.areas.size(), 1u);
    EXPECT_EQ(document.rally.size(), 1u);
}

TEST_F(Plan, refusals_name_line_item_and_value) {
    EXPECT_EQ(
        refusalOf(planWith(item(16, "0,0,0,0,47.1,8,60") + ",\n" + item(181, "0,9,0,0,0,0,0"))),
        "m:4:1: item 2: expected 0 or 1, found '9'");
    EXPECT_EQ(
        refusalOf(planWith(item(16, "0,0,0,0,47.1,8,60") + ",\n" + item(601, "0,0,0,0,0,0,0"))),
        "m:4:1: item 2: expected a command of the APM 2.0 set, found '601'");
}

TEST_F(Plan, keeps_the_commands_past_255_that_have_an_id) {
    EXPECT_EQ(
        refusalOf(planWith(item(16, "0,0,0,0,47.1,8,60") + ",\n" + item(2000, "0,3,0,0,0,0,0"))),
        "m:4:1: item 2: expected 1: one picture, a series by time there is none, found '0'");
    const std::string plan = file(
        "m.plan", planWith(item(16, "0,0,0,0,47.1,8,60") + ",\n" + item(530, "0,2,0,0,0,0,0")));
    EXPECT_EQ(tool({"check", plan}), 0) << err_;
}

TEST_F(Plan, converts_to_the_other_forms_and_back_to_the_same_records) {
    const std::string there = path("there.plan"), back = path("back.waypoints"),
                      text = path("text.txt");
    for (const std::string& name : {std::string(MISSIONS "/first_flight.waypoints"),
                                    std::string(MISSIONS "/every_command_2.waypoints"),
                                    std::string(MISSIONS "/beyond.waypoints")}) {
        ASSERT_EQ(tool({"convert", name, "-o", there}), 0) << err_;
        ASSERT_EQ(tool({"convert", there, "-o", back}), 0) << err_;
        ASSERT_EQ(tool({"convert", there, "-o", text}), 0) << err_;
        const Image expected = compiled(*simulator::wholeFile(name));
        EXPECT_EQ(compiled(*simulator::wholeFile(there)), expected);
        EXPECT_EQ(compiled(*simulator::wholeFile(back)), expected);
        EXPECT_EQ(compiled(*simulator::wholeFile(text)), expected);
    }
}

TEST_F(Plan, retains_fence_and_rally_points_or_says_that_it_cannot) {
    ASSERT_EQ(tool({"convert", kSurvey, "-o", path("again.plan")}), 0) << err_;
    const Document again = loaded(*simulator::wholeFile(path("again.plan")));
    ASSERT_EQ(again.fence.areas.size(), 1u);
    EXPECT_EQ(again.fence.areas[0].rim.size(), 4u);
    EXPECT_TRUE(again.fence.way_back);
    EXPECT_EQ(again.rally.size(), 1u);
    EXPECT_THAT(err_, testing::Not(HasSubstr("left out")));

    ASSERT_EQ(tool({"convert", kSurvey, "-o", path("lines.waypoints")}), 0) << err_;
    EXPECT_THAT(err_,
                HasSubstr("lines.waypoints: has no place for the fence and the rally points"));
}

TEST_F(Plan, takes_fence_and_rally_points_from_files_of_mission_planner) {
    const std::string mission = MISSIONS "/first_flight.waypoints", fen = path("f.fen"),
                      ral = path("r.ral"), joined = path("joined.plan");
    ASSERT_EQ(tool({"convert", kSurvey, "-o", fen}), 0) << err_;
    ASSERT_EQ(tool({"convert", kSurvey, "-o", ral}), 0) << err_;
    EXPECT_THAT(*simulator::wholeFile(fen),
                testing::StartsWith("#saved by APM Planner\n47.3982397 "
                                    "8.5458654\n47.3918536 8.5396281\n"));
    EXPECT_THAT(*simulator::wholeFile(ral), HasSubstr("RALLY\t"));
    ASSERT_EQ(tool({"convert", mission, "--fence", fen, "--rally", ral, "-o", joined}), 0) << err_;
    const Document document = loaded(*simulator::wholeFile(joined));
    EXPECT_EQ(document.fence.areas.at(0).rim.size(), 4u);
    EXPECT_TRUE(document.fence.way_back);
    EXPECT_EQ(document.rally.size(), 1u);

    EXPECT_EQ(tool({"check", mission, "--fence", fen, "--rally", ral}), 0) << err_;
    const std::string small = file("small.fen",
                                   "47.3977 8.5456\n47.397 8.545\n47.397 8.546\n"
                                   "47.398 8.546\n47.398 8.545\n");
    EXPECT_EQ(tool({"check", mission, "--fence", small}), 1);
    EXPECT_THAT(err_, HasSubstr("the leg leaves the fence by"));
    EXPECT_EQ(tool({"check", mission, "--fence", ral}), 1);
    EXPECT_THAT(err_, EndsWith("r.ral: has no fence\n"));
    EXPECT_EQ(tool({"check", mission, "--rally", fen}), 1);
    EXPECT_THAT(err_, EndsWith("f.fen: has no rally points\n"));
    EXPECT_EQ(tool({"convert", mission, "-o", path("none.fen")}), 1);
    EXPECT_THAT(err_, EndsWith("has no fence of one polygon with a return point\n"));
    const std::string first = file("m", apm1("0x10 0 6000 470100000 80000000\n"));
    EXPECT_EQ(tool({"rehearse", first, "--fence", fen}), 1);
    EXPECT_THAT(err_, HasSubstr("nor are fence and rally points\n"));
    EXPECT_EQ(tool({"check", fen}), 1);
    EXPECT_THAT(err_, HasSubstr("a file of fence or rally points, which has no mission"));
}

TEST_F(Plan, cannot_hold_the_first_set) {
    const std::string first = file("m", apm1("0x10 0 6000 470100000 80000000\n"));
    EXPECT_EQ(tool({"convert", first, "-o", path("m.plan")}), 1);
    EXPECT_THAT(err_, HasSubstr("holds what a .plan cannot say"));
    EXPECT_FALSE(std::filesystem::exists(path("m.plan")));
    EXPECT_EQ(tool({"convert", first, "-o", path("m.kml")}), 1);
    EXPECT_THAT(err_,
                EndsWith("expected a name that ends in .plan, .waypoints, .txt, .fen or .ral\n"));
}

TEST_F(Plan, foreign_files_are_named) {
    EXPECT_EQ(refusalOf("<?xml version=\"1.0\"?><kml/>"),
              "m:1:1: expected 'QGC WPL 110', a .plan, 'APM 1.0', 'APM 2.0', Intel hex or a "
              "4096-byte image, found a KML file: it has places, but no commands");
}

// Items that are all refused, or all worth a warning.
TEST_F(Plan, a_file_of_many_lines_has_few_warnings_and_its_error_at_the_end) {
    constexpr int kLines = 20'000;
    std::string lines = "QGC WPL 110\n0 1 0 16 0 0 0 0 47 8 400 1\n";
    for (int i = 1; i <= kLines; ++i) lines += std::to_string(i) + " 0 3 17 0 0 80 0 47 8 60 1\n";
    EXPECT_EQ(tool({"check", file("many", lines)}), 1);
    EXPECT_THAT(err_, HasSubstr("more warnings\n"));
    EXPECT_THAT(err_, EndsWith("expected at most 171 items, home included, found 20001\n"));
    EXPECT_LE(std::count(err_.begin(), err_.end(), '\n'), 22);
}

}  // namespace
}  // namespace mission_tool

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/document.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "simulator/report/goals.hpp"

using namespace simulator;
using testing::HasSubstr;
using Json = nlohmann::json;

namespace {

CampaignResult planned(uint64_t seed) {
    return {{"foam_trainer", "missions/box.waypoints", {0, 320}, seed},
            true,
            "",
            {{"crosstrack_rms_m", 1}},
            100,
            {}};
}

// Every figure at so many times its goal in wind.
CampaignResult drawn(uint64_t seed, double times) {
    CampaignResult result{{"drawn", "box", {}, seed, true}, true, "", {}, 300, {}};
    for (const Goal& goal : goals()) result.figures[goal.figure] = goal.windy * times;
    result.world = {{"mass_kg", "mass", "kg", 2.5}, {"thrown", "thrown", "", 1}};
    result.touchdown = {-4, 1};
    return result;
}

Json documentOf(const std::vector<CampaignResult>& results, size_t of) {
    return Json::parse(campaignJson(results, of, 12.34));
}

}  // namespace

TEST(CampaignDocument, has_the_goals_and_every_flight_with_its_command) {
    const Json json = documentOf({planned(1), planned(2)}, 2);
    EXPECT_EQ(json["format"], "apm-campaign");
    EXPECT_EQ(json["version"], 2);
    EXPECT_EQ(json["kind"], "planned");
    EXPECT_EQ(json["wall_s"], 12.3);
    EXPECT_EQ(json["emulated_s"], 200);
    EXPECT_EQ(json["goals"][0]["figure"], "crosstrack_rms_m");
    EXPECT_EQ(json["flights"][1]["command"],
              "toolchain/fly --native --airplane foam_trainer --seed 2 missions/box.waypoints");
    EXPECT_EQ(json["flights"][1]["airplane"], "foam_trainer");
    EXPECT_EQ(json["flights"][1]["completed"], true);
    EXPECT_FALSE(json["flights"][1].contains("failure"));
}

TEST(CampaignDocument, leaves_out_the_goal_that_needs_a_calibrated_compass) {
    for (const auto& goal : documentOf({planned(1)}, 1)["goals"])
        EXPECT_NE(goal["figure"], "yaw_error_rms_deg");
}

TEST(CampaignDocument, distinguishes_an_interrupted_campaign_from_a_whole_one) {
    const std::vector<CampaignResult> two = {planned(1), planned(2)};
    EXPECT_EQ(documentOf(two, 2)["verdict"]["text"], "every flight completed");
    const Json part = documentOf(two, 240);
    EXPECT_EQ(part["verdict"]["text"], "interrupted: 2 of 240 flights were flown, 0 failed");
    EXPECT_EQ(part["verdict"]["good"], false);
    EXPECT_EQ(part["planned"], 240);
    EXPECT_EQ(documentOf({}, 240)["verdict"]["text"],
              "interrupted: 0 of 240 flights were flown, 0 failed");
}

TEST(CampaignDocument, of_drawn_worlds_has_the_limits_and_what_was_drawn) {
    const Json json = documentOf({drawn(1, 1.4), drawn(2, 1.6)}, 2);
    EXPECT_EQ(json["kind"], "drawn");
    EXPECT_EQ(json["limit_times"], 1.5);
    EXPECT_EQ(json["met_all"], 1);
    ASSERT_EQ(json["goals"].size(), goals().size());
    for (size_t i = 0; i < goals().size(); ++i) {
        EXPECT_EQ(json["goals"][i]["figure"], goals()[i].figure);
        EXPECT_EQ(json["goals"][i]["limit"], 1.5 * goals()[i].windy);
        EXPECT_FALSE(json["goals"][i].contains("calm"));
    }
    EXPECT_EQ(json["drawn"][0], Json({{"key", "mass_kg"}, {"name", "mass"}, {"unit", "kg"}}));
    const Json& flight = json["flights"][1];
    EXPECT_EQ(flight["seed"], 2);
    EXPECT_EQ(flight["world"], Json({{"mass_kg", 2.5}, {"thrown", 1.0}}));
    EXPECT_EQ(flight["met_all"], false);
    EXPECT_EQ(json["flights"][0]["met_all"], true);
    EXPECT_EQ(flight["command"], "toolchain/campaign --drawn 2-2");
    EXPECT_EQ(flight["touchdown_m"], Json({-4.0, 1.0}));
    EXPECT_FALSE(flight.contains("report"));
    for (const char* none : {"airplane", "wind", "calm", "mission"})
        EXPECT_FALSE(flight.contains(none)) << none << " is not what was flown";
}

TEST(CampaignDocument, says_why_a_flight_failed_and_where_its_report_is) {
    CampaignResult failed = drawn(7, 0.1);
    failed.failure = "crashed after item 3";
    failed.report = "flights/drawn-7/report.html";
    const Json json = documentOf({failed}, 1);
    EXPECT_EQ(json["verdict"]["text"], "1 flights, 1 failed");
    EXPECT_EQ(json["met_all"], 0);
    EXPECT_EQ(json["flights"][0]["completed"], false);
    EXPECT_EQ(json["flights"][0]["failure"], "crashed after item 3");
    EXPECT_EQ(json["flights"][0]["report"], "flights/drawn-7/report.html");
}

TEST(CampaignDocument, replaces_bytes_that_are_no_text) {
    CampaignResult failed = drawn(7, 0.1);
    failed.failure = "it said \xFF\xFE";
    EXPECT_THAT(campaignJson({failed}, 1, 1), HasSubstr("it said"));
}

TEST(CampaignPage, holds_the_document) {
    const std::string page = campaignPage({planned(1), planned(2)}, 2, 1);
    EXPECT_THAT(page, HasSubstr("\"figure\":\"crosstrack_rms_m\""));
    EXPECT_THAT(page, HasSubstr("toolchain/fly --native --airplane foam_trainer --seed 2"));
}

TEST(WorldValues, are_those_of_a_file_that_the_drawn_program_wrote) {
    const auto values = worldValuesOf(
        R"({"format":"apm-drawn","version":1,"values":[{"key":"span_m","name":"span","unit":"m",
            "value":1.5}]})");
    ASSERT_EQ(values.size(), 1u);
    EXPECT_EQ(values[0].key, "span_m");
    EXPECT_EQ(values[0].unit, "m");
    EXPECT_EQ(values[0].value, 1.5);
    for (const char* other :
         {"", "{", "[]", "7", R"({"format":"other","values":[{}]})", R"({"format":7})",
          R"({"format":"apm-drawn","values":7})", R"({"format":"apm-drawn","values":[1]})"})
        EXPECT_TRUE(worldValuesOf(other).empty()) << other;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "simulator/report/recorded_series.hpp"
#include "talking_board.hpp"

using namespace simulator;
using namespace simulator::live;

TEST(Samples, have_a_value_for_each_series_of_the_document) {
    TalkingBoard board;
    board.runUntil(1'000'000);
    std::set<std::string> declared, given;
    for (const Json& each : seriesJson()) {
        const std::string name = each["name"], kind = each["kind"];
        declared.insert(kind == "truth" ? name : name + ":" + kind);
        EXPECT_TRUE(each["values"].empty());
    }
    const Json sample = Json::parse(sampleJson(board, Telemetry()));
    for (const auto& each : sample["values"].items()) given.insert(each.key());

    EXPECT_EQ(declared, given);
    EXPECT_EQ(sample["time_s"], 1);
    for (const char* name :
         {"lat_deg", "lon_deg", "altitude_m", "height_m", "roll_deg", "pitch_deg", "yaw_deg",
          "airspeed_mps", "ground_speed_mps", "climb_mps", "throttle_percent", "battery_v",
          "wind_mps", "wind_from_deg"})
        EXPECT_TRUE(declared.count(name)) << name;
}

// So that the page of a live flight shows what its report will show.
TEST(Samples, are_called_as_in_a_report) {
    for (const Json& each : seriesJson()) {
        const std::string name = each["name"];
        if (name == "frame_us") continue;  // reports have the mean and the longest of ten
        const auto& all = recordedSeries();
        const auto found = std::find_if(
            all.begin(), all.end(), [&](const RecordedSeries& row) { return row.name == name; });
        ASSERT_NE(found, all.end()) << name;
        EXPECT_EQ(each["title"], found->title) << name;
        EXPECT_EQ(each["unit"], found->unit) << name;
        EXPECT_EQ(each["group"], found->group) << name;
    }
}

TEST(Samples, are_the_truth_and_what_the_board_reports) {
    TalkingBoard board;
    Telemetry telemetry;
    mavlink::Attitude attitude{};
    attitude.roll = 0.5;
    attitude.yaw = -0.1f;
    telemetry.attitude = attitude;
    const Json values = Json::parse(sampleJson(board, telemetry))["values"];

    EXPECT_NEAR(values["lat_deg"].get<double>(), 47.3977, 1e-6);
    EXPECT_NEAR(values["roll_deg:estimate"].get<double>(), 28.65, 0.01);
    EXPECT_NEAR(values["yaw_deg:estimate"].get<double>(), 354.27, 0.01);
    EXPECT_TRUE(values["height_m:estimate"].is_null());
    EXPECT_TRUE(values["wind_from_deg"].is_null());
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "simulator/report/goals.hpp"
#include "simulator/report/recorder.hpp"
#include "simulator/report/status_line.hpp"
#include "simulator/report/summary.hpp"
#include "simulator/report/tables.hpp"

using namespace simulator;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Summary, is_null_where_nothing_is_known) {
    const auto json = nlohmann::json::parse(summaryJson(Summary()));

    for (const char* key :
         {"landed_distance_m", "flight_time_s", "cpu_load", "frame_max_us", "frame_overruns",
          "crosstrack_rms_m", "crosstrack_max_m", "altitude_rms_m", "airspeed_rms_mps",
          "flash_bytes", "ram_static_bytes", "stack_max_bytes"}) {
        ASSERT_TRUE(json.contains(key)) << key;
        EXPECT_TRUE(json[key].is_null()) << key;
    }
    EXPECT_EQ(json["completed"], false);
    EXPECT_TRUE(json["items_reached"].is_null());
    EXPECT_TRUE(json["imu_samples_lost"].is_null());
}

TEST(Summary, says_what_is_known) {
    Summary summary;
    summary.completed = true;
    summary.figures.cpu_load = 0.37039;  // past a budget of 37 %
    summary.figures.frame_overruns = 0;
    summary.items_reached = std::vector<int>{1, 3};
    const auto json = nlohmann::json::parse(summaryJson(summary));

    EXPECT_TRUE(json["reason"].is_null());
    EXPECT_EQ(json["cpu_load"], 0.37039);
    EXPECT_EQ(json["frame_overruns"], 0);
    EXPECT_EQ(json["items_reached"], (std::vector<int>{1, 3}));
}

TEST(Summary, has_the_goals_of_the_air_it_was_flown_in) {
    Summary calm, windy, log;
    windy.wind_mps = 5;
    log.from_log = true;
    const auto goals = [](const Summary& s) {
        return nlohmann::json::parse(summaryJson(s))["goals"];
    };

    EXPECT_EQ(goals(calm)["landed_distance_m"], *goalOf("landed_distance_m", false, false));
    EXPECT_EQ(goals(windy)["crosstrack_rms_m"], *goalOf("crosstrack_rms_m", true, false));
    EXPECT_FALSE(goals(calm).contains("yaw_error_rms_deg")) << "its compass is not calibrated";
    EXPECT_TRUE(goals(log).is_null());
}

TEST(Summary, names_the_tasks_whose_names_are_known) {
    Summary summary;
    summary.figures.tasks = {{0, 10, 1600, 800}, {1, 5, 160, 80}};
    summary.task_names = {{1, "runRadio", 2, 250, "fast"}};
    const auto json = nlohmann::json::parse(summaryJson(summary));

    EXPECT_FALSE(json["tasks"][0].contains("name"));
    EXPECT_EQ(json["tasks"][1]["name"], "runRadio");
    EXPECT_EQ(tablesOf(summary).front().rows.back().front(), "runRadio");
}

TEST(TaskNames, are_absent_beside_foreign_firmware) {
    EXPECT_TRUE(readTaskNames("/no/such/folder/other.elf").empty());
}

TEST(Summary, survives_text_that_is_no_utf8) {
    Summary summary;
    summary.texts = {{1, "\xff\xfe"}};

    EXPECT_NO_THROW(summaryJson(summary));
}

TEST(FlightCsv, has_a_unit_in_every_head_that_needs_one_and_gaps_for_the_unknown) {
    Sample sample{};
    sample.time_s = 1.5;
    const std::string csv = flightCsv({sample});
    const std::string heads = csv.substr(0, csv.find('\n'));
    const std::string row = csv.substr(csv.find('\n') + 1);

    EXPECT_THAT(heads, HasSubstr("time_s"));
    EXPECT_THAT(heads, HasSubstr("equivalent_airspeed_mps"));
    EXPECT_EQ(std::count(heads.begin(), heads.end(), ','), std::count(row.begin(), row.end(), ','));
    EXPECT_THAT(row, HasSubstr("1.50,,0,0,"));  // the mode was never sent
}

TEST(StatusLine, waits_for_the_first_heartbeat) {
    EXPECT_THAT(statusText(Telemetry(), Sample{}, 5, 10, std::nullopt),
                HasSubstr("no heartbeat yet"));
}

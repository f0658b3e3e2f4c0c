// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "simulator/report/chart.hpp"
#include "simulator/report/flight_charts.hpp"
#include "simulator/report/page.hpp"
#include "simulator/report/recorder.hpp"
#include "simulator/report/status_line.hpp"
#include "simulator/report/summary.hpp"
#include "simulator/report/tables.hpp"

using namespace simulator;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Ticks, are_round_numbers_inside_the_range) {
    EXPECT_THAT(ticks(0, 100, 5), ElementsAre(0, 20, 40, 60, 80, 100));
    EXPECT_THAT(ticks(-3, 7, 2), ElementsAre(0, 5));
    EXPECT_EQ(ticks(0.11, 0.19, 4).size(), 4u);
}

TEST(Chart, labels_both_axes) {
    Chart chart;
    chart.x_label = "time, s";
    chart.y_label = "height, m";
    chart.lines = {{"truth", "#123456", Stroke::solid, {{0, 0}, {10, 5}}}};
    const std::string svg = drawChart(chart);

    EXPECT_THAT(svg, HasSubstr("time, s"));
    EXPECT_THAT(svg, HasSubstr("height, m"));
    EXPECT_THAT(svg, HasSubstr("#123456"));
}

TEST(Chart, breaks_a_line_where_nothing_is_known) {
    Chart chart;
    chart.lines = {{"", "#000", Stroke::solid, {{0, 0}, {1, 1}, {2, NAN}, {3, 1}, {4, 0}}}};
    const std::string svg = drawChart(chart);
    const size_t path = svg.find("<path d=\"M");
    const std::string points = svg.substr(path, svg.find("\" stroke", path) - path);

    EXPECT_EQ(std::count(points.begin(), points.end(), 'M'), 2);
}

TEST(Chart, draws_an_empty_series_without_complaint) {
    EXPECT_THAT(drawChart(Chart()), Not(HasSubstr("nan")));
}

TEST(Chart, escapes_what_comes_from_outside) {
    EXPECT_EQ(escaped("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
}

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
    summary.figures.cpu_load = 0.25;
    summary.figures.frame_overruns = 0;
    summary.items_reached = std::vector<int>{1, 3};
    const auto json = nlohmann::json::parse(summaryJson(summary));

    EXPECT_TRUE(json["reason"].is_null());
    EXPECT_EQ(json["cpu_load"], 0.25);
    EXPECT_EQ(json["frame_overruns"], 0);
    EXPECT_EQ(json["items_reached"], (std::vector<int>{1, 3}));
}

TEST(Summary, names_the_tasks_whose_names_are_known) {
    Summary summary;
    summary.figures.tasks = {{0, 10, 1600, 800}, {1, 5, 160, 80}};
    summary.task_names = {{1, "runRadio", 2, 250, "fast"}};
    const auto json = nlohmann::json::parse(summaryJson(summary));

    EXPECT_FALSE(json["tasks"][0].contains("name"));
    EXPECT_EQ(json["tasks"][1]["name"], "runRadio");
    EXPECT_THAT(reportPage(summary, {Sample{}, Sample{}}, Plan()), HasSubstr("runRadio"));
}

TEST(TaskNames, are_absent_beside_foreign_firmware) {
    EXPECT_TRUE(readTaskNames("/no/such/folder/other.elf").empty());
}

TEST(SummaryTable, marks_what_is_past_its_limit) {
    Summary calm, windy;
    calm.crosstrack_rms_m = windy.crosstrack_rms_m = 4;
    windy.wind_mps = 5;

    EXPECT_THAT(summaryTable(calm), HasSubstr("✗"));
    EXPECT_THAT(summaryTable(windy), Not(HasSubstr("✗")));
}

TEST(FlightCharts, draw_the_circle_with_the_autopilots_own_radius) {
    Plan plan;
    plan.navs = {{1, 18, Point{0, 300}, 60, {}, 0, false, {}, 0.0}};
    Summary unknown, known;
    known.loiter_radius_m = 60;
    const std::vector<Sample> samples = {Sample{}, Sample{}};

    EXPECT_GT(FlightCharts(known, samples, plan).map().size(),
              FlightCharts(unknown, samples, plan).map().size() + 500);
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

TEST(Report, is_complete_in_itself) {
    Summary summary;
    summary.reason = "crashed after item 3";
    const std::string page = reportPage(summary, {Sample{}, Sample{}}, Plan());

    EXPECT_THAT(page, HasSubstr("crashed after item 3"));
    EXPECT_THAT(page, HasSubstr("Gyro bias"));
    EXPECT_THAT(page, Not(HasSubstr("http")));
    EXPECT_THAT(page, Not(HasSubstr("<script")));
    EXPECT_THAT(page, Not(HasSubstr("src=")));
}

TEST(Report, holds_the_processor_load_against_the_budget_of_its_board) {
    Summary summary;
    summary.figures.cpu_load = 0.36;
    summary.board = "apm1";
    EXPECT_THAT(summaryTable(summary), testing::ContainsRegex("36.0</td><td[^>]*>≤ 37<.*✓"));
    summary.board = "apm2";
    EXPECT_THAT(summaryTable(summary), testing::ContainsRegex("36.0</td><td[^>]*>≤ 33<.*✗"));
}

TEST(Report, leaves_out_what_a_foreign_firmware_does_not_report) {
    const std::string page = reportPage(Summary(), {Sample{}, Sample{}}, Plan());

    EXPECT_THAT(page, Not(HasSubstr("Processor load")));
    EXPECT_THAT(page, Not(HasSubstr("Tasks")));
    EXPECT_THAT(page, Not(HasSubstr("Static RAM")));
}

TEST(StatusLine, waits_for_the_first_heartbeat) {
    EXPECT_THAT(statusText(Telemetry(), Sample{}, 5, 10, std::nullopt),
                HasSubstr("no heartbeat yet"));
}

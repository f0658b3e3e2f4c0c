// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/recorded_flight.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "simulator/report/names.hpp"
#include "simulator/report/recorded_series.hpp"

using namespace simulator;

static std::vector<Sample> flown(size_t count) {
    std::vector<Sample> samples(count);
    for (size_t i = 0; i < count; ++i) {
        samples[i].time_s = 0.1 * static_cast<double>(i + 1);
        samples[i].truth.height_m = static_cast<double>(i);
    }
    return samples;
}

TEST(RecordedSeries, have_names_that_differ_by_kind_at_least) {
    std::set<std::string> seen;
    for (const RecordedSeries& row : recordedSeries())
        EXPECT_TRUE(seen.insert(std::string(row.name) + ":" + row.kind).second) << row.name;
}

TEST(RecordedSeries, without_a_value_are_left_out) {
    FlightDocument document;
    addSeries(document, flown(10));
    for (const DocumentSeries& series : document.series) {
        EXPECT_NE(series.kind, "estimate") << series.name;
        EXPECT_EQ(series.values.size(), document.times[series.time].size());
    }
}

TEST(RecordedSeries, of_a_long_flight_are_thinned) {
    FlightDocument document;
    addSeries(document, flown(20'000));
    EXPECT_LE(document.times[0].size(), 6000u);
    EXPECT_GE(document.times[0].size(), 4000u);
    EXPECT_NEAR(document.times[0][1] - document.times[0][0], 0.4, 1e-9);
}

TEST(RecordedSeries, of_no_samples_are_none) {
    FlightDocument document;
    addSeries(document, {});
    EXPECT_TRUE(document.series.empty());
}

TEST(Failsafes, last_from_their_text_to_the_one_that_ends_them) {
    const auto bands = failsafeBands({{10, "GPS lost: dead reckoning"},
                                      {15, "Compass lost"},
                                      {20, "GPS back"},
                                      {30, "GPS lost: dead reckoning"}},
                                     99);
    ASSERT_EQ(bands.size(), 3u);
    EXPECT_EQ(bands[0].to_s, 20);
    EXPECT_EQ(bands[1].from_s, 30);
    EXPECT_EQ(bands[1].to_s, 99);
    EXPECT_EQ(bands[2].name, "Compass lost");
}

TEST(RecordedFlight, has_bands_of_modes_and_of_injected_faults) {
    Summary summary;
    summary.emulated_s = 100;
    summary.events = {{1, "mode FBWA"}, {5, "armed"}, {6, "mode AUTO"}, {9, "flies item 2"}};
    summary.faults = {{"gps:lost", 60, 1e9}, {"baro:lost", 200, 300}};
    const FlightDocument document = documentOf(summary, flown(3), MissionFile());

    ASSERT_EQ(document.bands.size(), 3u);
    EXPECT_EQ(document.bands[0].to_s, 6);
    EXPECT_EQ(document.bands[1].name, "AUTO");
    EXPECT_EQ(document.bands[1].to_s, 100);
    EXPECT_EQ(document.bands[2].kind, "fault");
    EXPECT_EQ(document.bands[2].to_s, 100);
    EXPECT_EQ(document.events[1].kind, "armed");
    EXPECT_EQ(document.events.back().text, "fault injected: gps:lost");
}

TEST(RecordedFlight, names_a_fault_that_was_injected_on_the_way_once) {
    Summary summary;
    summary.emulated_s = 100;
    summary.events = {{60, "gps:lost"}, {61, "wind 6 m/s from 270 deg"}, {90, "gps:lost is over"}};
    summary.faults = {{"gps:lost", 60, 90}};
    const FlightDocument document = documentOf(summary, flown(3), MissionFile());

    ASSERT_EQ(document.events.size(), 3u);
    EXPECT_EQ(document.events[0].text, "fault injected: gps:lost");
    for (const DocumentEvent& event : document.events) EXPECT_EQ(event.kind, "fault") << event.text;
}

TEST(RecordedFlight, is_titled_by_what_flew_and_names_a_board_where_there_is_one) {
    Summary summary;
    summary.mission = "square.waypoints";
    summary.firmware = "firmware_apm2.elf";
    summary.board = "apm2";
    summary.seed = 3;
    EXPECT_EQ(documentOf(summary, flown(3), MissionFile()).title,
              "square.waypoints · firmware_apm2.elf on apm2 · seed 3");
    summary.firmware = "natively compiled";
    summary.board = "native";
    summary.provenance.native = true;
    EXPECT_EQ(documentOf(summary, flown(3), MissionFile()).title,
              "square.waypoints · natively compiled · seed 3");
}

TEST(RecordedFlight, has_the_heights_of_its_plan_above_the_sea) {
    MissionFile mission;
    mission.items = parseWaypoints(
        "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47.4\t8.5\t488\t1\n"
        "1\t0\t3\t18\t2\t0\t0\t0\t47.41\t8.51\t60\t1\n2\t0\t3\t178\t0\t13\t-1\t0\t0\t0\t0\t1\n",
        "plan");
    const DocumentPlan plan = planOf(mission, 75.0);

    ASSERT_EQ(plan.items.size(), 2u);
    EXPECT_EQ(plan.home->altitude_m, 488.0);
    EXPECT_EQ(plan.items[0].name, "LOITER_TURNS");
    EXPECT_EQ(plan.items[0].place->altitude_m, 548.0);
    EXPECT_EQ(plan.items[0].radius_m, 75.0);
    EXPECT_FALSE(plan.items[1].place);
    EXPECT_EQ(plan.items[1].text, "do change speed, parameters 0 13 -1 0");
}

TEST(RecordedFlight, has_the_first_polygon_to_stay_in_as_the_fence_and_the_rest_as_zones) {
    MissionFile mission;
    const std::vector<Place> triangle = {{47, 8}, {47, 9}, {48, 9}};
    mission.fence.areas = {{false, triangle, 0}, {true, triangle, 0}, {true, {{47.1, 8.2}}, 80}};
    const DocumentPlan plan = planOf(mission, {});

    EXPECT_EQ(plan.fence.size(), 3u);
    ASSERT_EQ(plan.zones.size(), 2u);
    EXPECT_FALSE(plan.zones[0].keeps_in);
    EXPECT_EQ(plan.zones[0].rim.size(), 3u);
    EXPECT_FALSE(plan.zones[0].radius_m);
    EXPECT_TRUE(plan.zones[1].keeps_in);
    EXPECT_EQ(plan.zones[1].rim.at(0).longitude_deg, 8.2);
    EXPECT_EQ(plan.zones[1].radius_m, 80.0);
}

TEST(RecordedFlight, has_places_on_the_meridian_of_greenwich_and_on_the_equator) {
    MissionFile mission;
    mission.items = parseWaypoints(
        "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t51.4\t0\t40\t1\n"
        "1\t0\t3\t16\t0\t0\t0\t0\t51.41\t0\t60\t1\n"
        "2\t0\t3\t16\t0\t0\t0\t0\t0\t9.5\t60\t1\n3\t0\t3\t16\t0\t0\t0\t0\t0\t0\t60\t1\n",
        "plan");
    const DocumentPlan plan = planOf(mission, {});

    ASSERT_EQ(plan.items.size(), 3u);
    ASSERT_TRUE(plan.items[0].place);
    EXPECT_EQ(plan.items[0].place->latitude_deg, 51.41);
    EXPECT_TRUE(plan.items[1].place);
    EXPECT_FALSE(plan.items[2].place) << "0, 0 is where the airplane is";
}

TEST(Names, fall_back_to_numbers) {
    EXPECT_EQ(commandName(16), "WAYPOINT");
    EXPECT_EQ(commandName(999), "COMMAND 999");
    EXPECT_EQ(logEventName(999), "event 999");
    EXPECT_EQ(logErrorName(18, 1, true), "BARO: barometer lost");
    EXPECT_EQ(logErrorName(99, 7, false), "subsystem 99: code 7");
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/flight_document.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

using namespace simulator;
using nlohmann::json;

static FlightDocument small() {
    FlightDocument document;
    document.kind = "simulated";
    document.title = "a flight";
    document.times = {{0, 0.1}};
    document.series = {{"height_m", "height", "m", "height", "truth", 0, {1, 2}}};
    document.events = {{1.5, "text", "said", 4}};
    document.bands = {{"mode", "AUTO", 1, 2}};
    document.deviations = {{"Crosstrack, RMS", 1.5, "m", 1.2}, {"Flight time", 300, "s", {}}};
    document.plan.home = DocumentPlace{47.5, 8.5, 488.0};
    document.plan.items = {{1, "TAKEOFF", "takeoff, 45 m", {}, {}}};
    return document;
}

TEST(FlightDocument, says_what_it_is) {
    const json made = json::parse(flightJson(small()));

    EXPECT_EQ(made["format"], "apm-flight");
    EXPECT_EQ(made["version"], 1);
    EXPECT_EQ(made["kind"], "simulated");
    EXPECT_FALSE(made.contains("verdict"));
}

TEST(FlightDocument, holds_series_events_bands_and_plan) {
    const json made = json::parse(flightJson(small()));

    EXPECT_EQ(made["series"][0]["name"], "height_m");
    EXPECT_EQ(made["series"][0]["kind"], "truth");
    EXPECT_TRUE(made["series"][0]["values"].contains("i16"));
    EXPECT_TRUE(made["times"][0].contains("f32"));
    EXPECT_EQ(made["events"][0]["severity"], 4);
    EXPECT_EQ(made["bands"][0]["to_s"], 2.0);
    EXPECT_EQ(made["plan"]["home"]["altitude_m"], 488.0);
    EXPECT_FALSE(made["plan"]["items"][0].contains("lat_deg"));
}

TEST(FlightDocument, says_of_what_has_a_goal_whether_it_is_met) {
    const json made = json::parse(flightJson(small()));

    EXPECT_EQ(made["deviations"][0]["met"], false);
    EXPECT_FALSE(made["deviations"][1].contains("met"));
}

TEST(FlightDocument, survives_text_that_is_no_utf8) {
    FlightDocument document = small();
    document.events[0].text = "\xff\xfe";

    EXPECT_NO_THROW(flightJson(document));
}

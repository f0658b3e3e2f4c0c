// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/generator.hpp"

#include <algorithm>
#include <set>

#include "simulator/devices/faults.hpp"

namespace simulator::chaos {

TEST(Generator, the_same_seed_gives_the_same_scenario) {
    const auto parameters = readParameterRows(PARAMETERS);
    std::set<std::string> all;
    for (uint64_t seed = 1; seed <= 100; ++seed) {
        const std::string text = textOf(drawScenario(seed, parameters));
        EXPECT_EQ(text, textOf(drawScenario(seed, parameters)));
        all.insert(text);
    }
    EXPECT_EQ(all.size(), 100u);
}

TEST(Generator, leaves_out_parameters_that_end_the_link) {
    const auto parameters = readParameterRows(PARAMETERS);
    EXPECT_GT(parameters.size(), 150u);
    for (const ParameterRow& row : parameters) {
        EXPECT_LE(row.lowest, row.highest) << row.name;
        EXPECT_NE(row.name.rfind("SERIAL", 0), 0u);
        EXPECT_NE(row.name, "SYSID_THISMAV");
    }
    EXPECT_THROW(readParameterRows("/nowhere.csv"), ScenarioError);
}

TEST(Generator, draws_every_kind_of_event_and_only_faults_that_exist) {
    const auto parameters = readParameterRows(PARAMETERS);
    std::set<std::string> kinds, faults;
    for (uint64_t seed = 1; seed <= 2000; ++seed) {
        const Scenario scenario = drawScenario(seed, parameters);
        EXPECT_GE(scenario.seconds, 60);
        EXPECT_LE(scenario.seconds, 195);
        EXPECT_TRUE(std::is_sorted(
            scenario.events.begin(), scenario.events.end(),
            [](const Event& one, const Event& other) { return one.at_s < other.at_s; }));
        for (const Event& event : scenario.events) {
            kinds.insert(event.kind());
            if (event.kind() != "fault") continue;
            const bool sag = event.words[1].rfind("supply:sag", 0) == 0;  // of any depth
            faults.insert(sag ? "supply:sag" : event.words[1]);
            EXPECT_TRUE(parseFault(event.words[1] + "@1")) << event.words[1];
        }
    }
    EXPECT_EQ(kinds, (std::set<std::string>{"clear", "command", "count", "current", "fault",
                                            "frame", "item", "mode", "noise", "override", "param",
                                            "restart", "sticks", "switch", "transmitter", "usb"}));
    size_t possible = 0;
    for (int sensor = 0; sensor < kFaulty; ++sensor)
        for (int kind = 1; kind < kFaultKinds; ++kind)
            possible += canFail(static_cast<Faulty>(sensor), static_cast<FaultKind>(kind));
    EXPECT_EQ(faults.size(), possible - 1) << "a cut of the supply is a restart";
}

TEST(Generator, draws_every_condition_and_faults_and_restarts_in_every_part_of_a_flight) {
    const auto parameters = readParameterRows(PARAMETERS);
    const Conditions usual;
    std::set<std::string> unusual;
    int early = 0, late = 0, early_restarts = 0, stormy = 0, armed_standing = 0;
    for (uint64_t seed = 1; seed <= 500; ++seed) {
        const Scenario s = drawScenario(seed, parameters);
        for (const Condition& each : kConditions)
            if (s.conditions.*each.value != usual.*each.value) unusual.insert(each.name);
        for (const Event& event : s.events) {
            const bool before = event.at_s < s.begins_s + 15;
            if (event.kind() == "fault") ++(before ? early : late);
            if (event.kind() == "restart") early_restarts += before;
            if (event.kind() == "mode") armed_standing += before;
        }
        EXPECT_LE(s.wind_mps, 12);
        stormy += s.wind_mps > 10;
    }
    EXPECT_EQ(unusual.size(), kConditions.size());
    EXPECT_GT(early, 100);
    EXPECT_GT(late, 300);
    EXPECT_GT(early_restarts, 20);
    EXPECT_GT(armed_standing, 50);
    EXPECT_GT(stormy, 10);
}

TEST(Generator, missions_begin_at_home_and_end_with_a_landing) {
    const auto parameters = readParameterRows(PARAMETERS);
    for (uint64_t seed = 1; seed <= 200; ++seed) {
        const Waypoints mission = drawScenario(seed, parameters).mission;
        EXPECT_EQ(mission[0].command, mavlink::MavCmd::nav_waypoint);
        EXPECT_EQ(mission[1].command, mavlink::MavCmd::nav_takeoff);
        EXPECT_EQ(mission.back().command, mavlink::MavCmd::nav_land);
        for (size_t i = 0; i < mission.size(); ++i)
            EXPECT_EQ(mission[i].index, static_cast<int>(i));
    }
}

// A CONDITION_CHANGE_ALT without a height is an order to fly into the ground.
TEST(Generator, a_quarter_has_a_fence_with_home_inside_and_points_for_the_board) {
    const auto parameters = readParameterRows(PARAMETERS);
    int fences = 0, kinds[2][2] = {};
    for (uint64_t seed = 1; seed <= 1000; ++seed) {
        const Scenario scenario = drawScenario(seed, parameters);
        if (!scenario.fence.given()) continue;
        ++fences;
        EXPECT_LE(fenceItems(scenario.fence).size(), 20u) << seed;
        const WaypointItem& home = scenario.mission[0];
        for (const FenceArea& area : scenario.fence.areas) {
            ++kinds[area.inclusion][area.isCircle()];
            double nearest_m = 1e9;
            for (const Place& place : area.rim) {
                const double north_m = (place.latitude_deg - home.latitude_deg) * 111'319;
                const double east_m = (place.longitude_deg - home.longitude_deg) * 111'319 *
                                      std::cos(home.latitude_deg * M_PI / 180);
                nearest_m = std::min(nearest_m, std::hypot(north_m, east_m));
            }
            if (area.isCircle() && area.inclusion)
                EXPECT_LT(nearest_m, area.radius_m - 100) << seed;
            else
                EXPECT_GT(nearest_m, area.radius_m + 40) << seed;
        }
    }
    EXPECT_NEAR(fences, 250, 40);
    for (const auto& side : kinds)
        for (const int count : side) EXPECT_GT(count, 30);
}

TEST(Generator, missions_change_to_heights_to_fly_at) {
    const auto parameters = readParameterRows(PARAMETERS);
    int changes = 0;
    for (uint64_t seed = 1; seed <= 200; ++seed) {
        for (const WaypointItem& item : drawScenario(seed, parameters).mission) {
            if (item.command != mavlink::MavCmd::condition_change_alt) continue;
            ++changes;
            EXPECT_GE(item.altitude_m, 40) << seed;
            EXPECT_LE(item.altitude_m, 100) << seed;
        }
    }
    EXPECT_GT(changes, 20);
}

TEST(Generator, a_transmitter_of_nine_channels_doubles_and_misses_no_edge) {
    const auto parameters = readParameterRows(PARAMETERS);
    int nine = 0;
    for (uint64_t seed = 1; seed <= 2000; ++seed) {
        std::set<std::string> faults;
        for (const Event& event : drawScenario(seed, parameters).events)
            if (event.kind() == "fault") faults.insert(event.words[1]);
        if (faults.count("radio:nine_channels") == 0) continue;
        ++nine;
        EXPECT_EQ(faults.count("radio:extra_edge") + faults.count("radio:missed_edge"), 0u) << seed;
    }
    EXPECT_GT(nine, 20);
}

}  // namespace simulator::chaos

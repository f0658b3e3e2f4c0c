// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/shrink.hpp"

#include <algorithm>

namespace simulator::chaos {

Scenario withEvents(int count) {
    Scenario scenario;
    scenario.seconds = 128;
    scenario.wind_mps = 5;
    scenario.gusts = true;
    scenario.conditions.tube = 0;
    scenario.conditions.declination_deg = 9;
    scenario.mission.resize(8);
    for (int i = 0; i < 8; ++i) scenario.mission[static_cast<size_t>(i)].index = i;
    for (int i = 0; i < count; ++i)
        scenario.events.push_back({i * 1.0, {"sticks", std::to_string(i)}});
    return scenario;
}

bool has(const Scenario& scenario, const char* word) {
    return std::any_of(scenario.events.begin(), scenario.events.end(),
                       [word](const Event& event) { return event.words[1] == word; });
}

TEST(Shrink, finds_the_two_of_fifty_events_that_fail_together) {
    const Scenario least = shrink(
        withEvents(50),
        [](const Scenario& each) { return has(each, "7") && has(each, "41") && each.seconds > 60; },
        10'000);
    ASSERT_EQ(least.events.size(), 2u);
    EXPECT_EQ(least.events[0].words[1], "7");
    EXPECT_EQ(least.events[1].words[1], "41");
    EXPECT_GT(least.seconds, 60);
    EXPECT_LE(least.seconds, 61.1);
    EXPECT_EQ(least.wind_mps, 0);
    EXPECT_FALSE(least.gusts);
    EXPECT_EQ(least.conditions.tube, 1);
    EXPECT_EQ(least.conditions.declination_deg, 9) << "that of the mission's place";
    EXPECT_EQ(least.mission.size(), 3u) << "home, take-off, landing";
    EXPECT_EQ(least.mission.back().index, 2);
}

TEST(Shrink, keeps_what_the_failure_needs) {
    const Scenario least = shrink(
        withEvents(3),
        [](const Scenario& each) { return each.wind_mps > 0 && each.mission.size() >= 6; }, 10'000);
    EXPECT_TRUE(least.events.empty());
    EXPECT_EQ(least.wind_mps, 5);
    EXPECT_EQ(least.mission.size(), 6u);
    EXPECT_LE(least.seconds, 1.1);
}

TEST(Shrink, leaves_out_the_zones_that_are_not_needed) {
    Scenario scenario = withEvents(1);
    for (const double radius_m : {100.0, 200.0, 300.0})
        scenario.fence.areas.push_back({false, {{47, 8}}, radius_m});
    scenario.fence.way_back = Place{47, 8};
    const auto needs = [](double radius_m) {
        return [radius_m](const Scenario& each) {
            return radius_m == 0 ||
                   std::any_of(each.fence.areas.begin(), each.fence.areas.end(),
                               [=](const FenceArea& area) { return area.radius_m == radius_m; });
        };
    };
    const Scenario one = shrink(scenario, needs(200), 10'000);
    ASSERT_EQ(one.fence.areas.size(), 1u);
    EXPECT_EQ(one.fence.areas[0].radius_m, 200);
    EXPECT_FALSE(shrink(scenario, needs(0), 10'000).fence.given());
}

TEST(Shrink, ends_with_the_tries_in_a_scenario_that_still_fails) {
    unsigned tried = 0;
    const auto fails = [&tried](const Scenario& each) {
        ++tried;
        return has(each, "7") && has(each, "41");
    };
    const Scenario least = shrink(withEvents(50), fails, 20);
    EXPECT_EQ(tried, 20u);
    EXPECT_TRUE(fails(least));
}

}  // namespace simulator::chaos

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/document.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

using namespace simulator::chaos;
using testing::HasSubstr;
using Json = nlohmann::json;

namespace {

Scenario scenarioWith(const std::vector<Event>& events) {
    Scenario scenario;
    scenario.airplane = "flying_wing";
    scenario.wind_mps = 4.567;
    scenario.events = events;
    return scenario;
}
const Scenario kCalm =
    scenarioWith({{70, {"fault", "gps:lost", "20"}}, {120, {"fault", "gps:lost", "9"}}});
const Scenario kRough = scenarioWith(
    {{60, {"sticks", "1100", "1500", "1500", "1500"}}, {80, {"fault", "supply:sag_3.75v", "1"}}});

Outcome outcomeOf(bool crashed) {
    Outcome outcome;
    outcome.emulated_s = 100;
    outcome.airborne = true;
    outcome.crashed = crashed;
    return outcome;
}

struct Flown {
    Totals totals;
    std::vector<FlownScenario> flights;

    void add(uint64_t seed, const Scenario& scenario, const Outcome& outcome) {
        totals.add(scenario, outcome);
        flights.push_back(flownScenario(seed, scenario, outcome));
    }
    Json document(const ChaosRun& run) const {
        return Json::parse(chaosJson(run, totals, flights));
    }
};

ChaosRun runOf(uint64_t planned) {
    return {planned, "natively compiled firmware", "", "build/chaos", 12.34};
}

}  // namespace

TEST(ChaosDocument, counts_what_was_drawn_and_what_became_of_those_flights) {
    Flown flown;
    flown.add(7, kCalm, outcomeOf(false));
    flown.add(8, kRough, outcomeOf(true));
    const Json json = flown.document(runOf(2));

    EXPECT_EQ(json["format"], "apm-campaign");
    EXPECT_EQ(json["kind"], "chaos");
    EXPECT_EQ(json["verdict"], Json({{"good", true}, {"text", "nothing was violated"}}));
    EXPECT_EQ(json["flown"], 2);
    EXPECT_EQ(json["crashed"], 1);
    EXPECT_EQ(json["must_survive"], 1);
    EXPECT_EQ(json["airplanes"][0]["flights"], 2);
    ASSERT_EQ(json["events"].size(), 3u);
    EXPECT_EQ(json["events"][0], Json({{"name", "fault gps:lost"},
                                       {"times", 2},
                                       {"flights", 1},
                                       {"crashed", 0},
                                       {"violated", 0}}));
    EXPECT_EQ(json["events"][1]["name"], "fault supply:sag")
        << "its depth is another one each time";
    EXPECT_EQ(
        json["events"][2],
        Json({{"name", "sticks"}, {"times", 1}, {"flights", 1}, {"crashed", 1}, {"violated", 0}}));
}

TEST(ChaosDocument, has_every_flight_with_its_command) {
    Flown flown;
    flown.add(8, kRough, outcomeOf(true));
    ChaosRun run = runOf(1);
    run.option = " --elf";
    const Json flight = flown.document(run)["flights"][0];

    EXPECT_EQ(flight["command"], "toolchain/chaos --elf --seed 8 --flights 1");
    EXPECT_EQ(flight["airplane"], "flying_wing");
    EXPECT_EQ(flight["wind_mps"], 4.57);
    EXPECT_EQ(flight["crashed"], true);
    EXPECT_EQ(flight["must_survive"], false);
    EXPECT_EQ(flight["events"], Json({{"fault supply:sag", 1}, {"sticks", 1}}));
    EXPECT_FALSE(flight.contains("replay"));
}

TEST(ChaosDocument, names_what_was_violated_and_the_scenario_that_shows_it) {
    Flown flown;
    Outcome outcome = outcomeOf(false);
    outcome.violations = {{41.3, "mission_jump", "item 3 after 1"}, {50, "mission_jump", "again"}};
    flown.add(9, kCalm, outcome);
    flown.flights[0].file = "mission_jump_9.scenario";
    const Json json = flown.document(runOf(1));

    EXPECT_EQ(json["verdict"],
              Json({{"good", false}, {"text", "of 1 flights 1 violated an invariant"}}));
    EXPECT_EQ(json["violations"], Json::array({{{"name", "mission_jump"}, {"flights", 1}}}));
    EXPECT_EQ(json["flights"][0]["violations"][0],
              Json({{"time_s", 41.3}, {"name", "mission_jump"}, {"numbers", "item 3 after 1"}}));
    EXPECT_EQ(json["flights"][0]["replay"],
              "toolchain/chaos --replay build/chaos/mission_jump_9.scenario");
    EXPECT_THAT(chaosPage(runOf(1), flown.totals, flown.flights), HasSubstr("item 3 after 1"));
}

TEST(ChaosDocument, distinguishes_an_interrupted_run_from_a_whole_one) {
    Flown flown;
    flown.add(7, kCalm, outcomeOf(false));
    const Json json = flown.document(runOf(100));

    EXPECT_EQ(json["verdict"]["good"], false);
    EXPECT_EQ(json["verdict"]["text"],
              "interrupted: 1 of 100 flights were flown, 0 violated an invariant");
}

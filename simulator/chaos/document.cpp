// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/document.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "simulator/report/page.hpp"

namespace simulator::chaos {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 2;  // simulator/campaign/document.cpp

double rounded(double value, double parts) { return std::round(value * parts) / parts; }

std::string verdictText(const ChaosRun& run, const Totals& totals) {
    const std::string violated = std::to_string(totals.violated()) + " violated an invariant";
    if (totals.flights() < run.planned)
        return "interrupted: " + std::to_string(totals.flights()) + " of " +
               std::to_string(run.planned) + " flights were flown, " + violated;
    if (totals.violated() == 0) return "nothing was violated";
    return "of " + std::to_string(totals.flights()) + " flights " + violated;
}

Json drawnOf(const std::map<std::string, Drawn>& all) {
    Json json = Json::array();
    for (const auto& [name, drawn] : all)
        json.push_back({{"name", name},
                        {"times", drawn.times},
                        {"flights", drawn.flights},
                        {"crashed", drawn.crashed},
                        {"violated", drawn.violated}});
    return json;
}

Json violationsOf(const Outcome& outcome) {
    Json json = Json::array();
    for (const invariants::Violation& each : outcome.violations)
        json.push_back({{"time_s", rounded(each.time_s, 100)},
                        {"name", each.name},
                        {"numbers", each.numbers}});
    return json;
}

Json flightOf(const ChaosRun& run, const FlownScenario& flown) {
    const std::string command = "toolchain/chaos" + run.option;
    Json json = {{"seed", flown.seed},
                 {"command", command + " --seed " + std::to_string(flown.seed) + " --flights 1"},
                 {"airplane", flown.airplane},
                 {"wind_mps", rounded(flown.wind_mps, 100)},
                 {"gusts", flown.gusts},
                 {"emulated_s", rounded(flown.outcome.emulated_s, 10)},
                 {"airborne", flown.outcome.airborne},
                 {"crashed", flown.outcome.crashed},
                 {"must_survive", flown.must_survive},
                 {"events", flown.events},
                 {"violations", violationsOf(flown.outcome)}};
    if (flown.file.empty()) return json;
    json["scenario"] = flown.file;
    json["replay"] = command + " --replay " + run.folder + "/" + flown.file;
    return json;
}

std::string documentOf(const ChaosRun& run, const Totals& totals,
                       const std::vector<FlownScenario>& flights, int indent) {
    Json json = {{"format", "apm-campaign"}, {"version", kVersion}, {"kind", "chaos"}};
    json["verdict"] = {{"good", totals.violated() == 0 && totals.flights() == run.planned},
                       {"text", verdictText(run, totals)}};
    json["firmware"] = run.firmware;
    json["planned"] = run.planned;
    json["flown"] = totals.flights();
    json["wall_s"] = rounded(run.wall_s, 10);
    json["emulated_s"] = std::round(totals.emulated_s());
    json["airborne"] = totals.airborne();
    json["crashed"] = totals.crashed();
    json["must_survive"] = totals.promised();
    json["violated"] = totals.violated();
    json["airplanes"] = drawnOf(totals.airplanes());
    json["events"] = drawnOf(totals.events());
    json["violations"] = Json::array();
    for (const auto& [name, count] : totals.violations())
        json["violations"].push_back({{"name", name}, {"flights", count}});
    json["flights"] = Json::array();
    for (const FlownScenario& flown : flights) json["flights"].push_back(flightOf(run, flown));
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

FlownScenario flownScenario(uint64_t seed, const Scenario& scenario, const Outcome& outcome) {
    return {seed,
            scenario.airplane,
            scenario.wind_mps,
            scenario.gusts,
            promisesToSurvive(scenario),
            eventsIn(scenario),
            outcome,
            ""};
}

std::string chaosJson(const ChaosRun& run, const Totals& totals,
                      const std::vector<FlownScenario>& flights) {
    return documentOf(run, totals, flights, 1) + "\n";
}

std::string chaosPage(const ChaosRun& run, const Totals& totals,
                      const std::vector<FlownScenario>& flights) {
    return campaignPageOf(documentOf(run, totals, flights, -1));
}

}  // namespace simulator::chaos

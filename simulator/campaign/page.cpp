// SPDX-License-Identifier: GPL-3.0-or-later
// The campaign's document, which its page shows: every flight with its figures, and their goals.
#include "simulator/report/page.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "simulator/campaign/statistics.hpp"
#include "simulator/report/goals.hpp"

namespace simulator {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;

size_t failures(const std::vector<CampaignResult>& results) {
    return static_cast<size_t>(
        std::count_if(results.begin(), results.end(),
                      [](const CampaignResult& r) { return !r.failure.empty(); }));
}

Json flightOf(const CampaignResult& result) {
    const CampaignFlight& flight = result.flight;
    Json json = {{"airplane", flight.airplaneName()},
                 {"mission", flight.missionName()},
                 {"wind", flight.wind.name()},
                 {"calm", flight.wind.calm()},
                 {"seed", flight.seed},
                 {"command", flight.replay(true)},
                 {"command_on_the_chip", flight.replay(false)},
                 {"figures", result.figures}};
    if (!result.failure.empty()) json["failure"] = result.failure;
    if (result.touchdown) json["touchdown_m"] = {result.touchdown->first, result.touchdown->second};
    return json;
}

Json goalOf(const Goal& goal) {
    return {{"figure", goal.figure},
            {"name", goal.name},
            {"unit", goal.unit},
            {"calm", goal.calm},
            {"windy", goal.windy}};
}

}  // namespace

std::string flownText(size_t flown, size_t planned, size_t failed) {
    const std::string said = ", " + std::to_string(failed) + " failed";
    if (flown == planned) return std::to_string(flown) + " flights" + said;
    return "interrupted: " + std::to_string(flown) + " of " + std::to_string(planned) +
           " flights were flown" + said;
}

std::string campaignPage(const std::vector<CampaignResult>& results, size_t planned,
                         double wall_s) {
    const size_t failed = failures(results);
    const bool good = failed == 0 && results.size() == planned;
    double emulated_s = 0;
    for (const auto& result : results) emulated_s += result.emulated_s;
    Json json = {{"format", "apm-campaign"}, {"version", kVersion}};
    json["verdict"] = {
        {"good", good},
        {"text", good ? "every flight completed" : flownText(results.size(), planned, failed)}};
    json["wall_s"] = std::round(wall_s * 10) / 10;
    json["emulated_s"] = std::round(emulated_s);
    json["goals"] = Json::array();
    for (const Goal& goal : goals())
        if (!goal.calibrated) json["goals"].push_back(goalOf(goal));
    json["flights"] = Json::array();
    for (const auto& result : results) json["flights"].push_back(flightOf(result));
    return campaignPageOf(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace simulator

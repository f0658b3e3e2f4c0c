// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/document.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "simulator/campaign/shares.hpp"
#include "simulator/report/goals.hpp"
#include "simulator/report/page.hpp"

namespace simulator {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 2;

size_t failures(const std::vector<CampaignResult>& results) {
    return static_cast<size_t>(
        std::count_if(results.begin(), results.end(),
                      [](const CampaignResult& r) { return !r.failure.empty(); }));
}

bool areDrawn(const std::vector<CampaignResult>& results) {
    return !results.empty() && results.front().flight.drawn;
}

Json plannedOf(const CampaignFlight& flight) {
    return {{"airplane", flight.airplaneName()},
            {"mission", flight.missionName()},
            {"wind", flight.wind.name()},
            {"calm", flight.wind.calm()},
            {"command_on_the_chip", flight.replay(false)}};
}

Json drawnOf(const CampaignResult& result) {
    Json json = {{"met_all", excessOf(result) <= 1}, {"world", Json::object()}};
    for (const WorldValue& each : result.world) json["world"][each.key] = each.value;
    return json;
}

Json flightOf(const CampaignResult& result) {
    const CampaignFlight& flight = result.flight;
    Json json = {{"seed", flight.seed},
                 {"command", flight.replay(true)},
                 {"completed", result.failure.empty()},
                 {"figures", result.figures}};
    json.update(flight.drawn ? drawnOf(result) : plannedOf(flight));
    if (!result.failure.empty()) json["failure"] = result.failure;
    if (!result.report.empty()) json["report"] = result.report;
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

Json limitOf(const Share& share) {
    return {{"figure", share.figure},
            {"name", share.name},
            {"unit", share.unit},
            {"limit", share.limit}};
}

// What is drawn, by the first flight that has it.
Json drawnNames(const std::vector<CampaignResult>& results) {
    Json names = Json::array();
    for (const CampaignResult& result : results) {
        for (const WorldValue& each : result.world)
            names.push_back({{"key", each.key}, {"name", each.name}, {"unit", each.unit}});
        if (!names.empty()) break;
    }
    return names;
}

void addDemands(Json& json, const std::vector<CampaignResult>& results) {
    json["goals"] = Json::array();
    if (areDrawn(results)) {
        json["limit_times"] = kDrawnTimes;
        json["met_all"] = meetingAll(results);
        json["drawn"] = drawnNames(results);
        for (const Share& share : sharesOf(results)) json["goals"].push_back(limitOf(share));
        return;
    }
    for (const Goal& goal : goals())
        if (!goal.calibrated) json["goals"].push_back(goalOf(goal));
}

std::string documentOf(const std::vector<CampaignResult>& results, size_t planned, double wall_s,
                       int indent) {
    const size_t failed = failures(results);
    const bool good = failed == 0 && results.size() == planned;
    double emulated_s = 0;
    for (const auto& result : results) emulated_s += result.emulated_s;
    Json json = {{"format", "apm-campaign"},
                 {"version", kVersion},
                 {"kind", areDrawn(results) ? "drawn" : "planned"}};
    json["verdict"] = {
        {"good", good},
        {"text", good ? "every flight completed" : flownText(results.size(), planned, failed)}};
    json["planned"] = planned;
    json["wall_s"] = std::round(wall_s * 10) / 10;
    json["emulated_s"] = std::round(emulated_s);
    addDemands(json, results);
    json["flights"] = Json::array();
    for (const auto& result : results) json["flights"].push_back(flightOf(result));
    // texts come from outside: a byte that is no UTF-8 is replaced, not thrown over
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string flownText(size_t flown, size_t planned, size_t failed) {
    const std::string said = ", " + std::to_string(failed) + " failed";
    if (flown == planned) return std::to_string(flown) + " flights" + said;
    return "interrupted: " + std::to_string(flown) + " of " + std::to_string(planned) +
           " flights were flown" + said;
}

std::string campaignJson(const std::vector<CampaignResult>& results, size_t planned,
                         double wall_s) {
    return documentOf(results, planned, wall_s, 1) + "\n";
}

std::string campaignPage(const std::vector<CampaignResult>& results, size_t planned,
                         double wall_s) {
    return campaignPageOf(documentOf(results, planned, wall_s, -1));
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/recorded_flight.hpp"

#include <algorithm>

#include "simulator/report/names.hpp"
#include "simulator/report/recorded_series.hpp"
#include "simulator/report/tables.hpp"

namespace simulator {
namespace {

// Of a flight that somebody acted upon (simulator/live/chronicle.cpp).
constexpr char kMode[] = "mode ", kWind[] = "wind ", kOver[] = " is over";

bool begins(const std::string& text, const std::string& with) { return text.rfind(with, 0) == 0; }
bool ends(const std::string& text, const std::string& with) {
    return text.size() >= with.size() &&
           text.compare(text.size() - with.size(), with.npos, with) == 0;
}

DocumentItem itemOf(const WaypointItem& item, double home_altitude_m,
                    std::optional<double> loiter_radius_m) {
    DocumentItem made{item.index, commandName(item.command), itemText(item), {}, {}};
    if (!item.isPlaced()) return made;
    const double above_m = item.relative() ? home_altitude_m : 0;
    made.place = {item.latitude_deg, item.longitude_deg, above_m + item.altitude_m};
    if (item.isCircle()) made.radius_m = item.params[2] != 0 ? item.params[2] : loiter_radius_m;
    return made;
}

std::string kindOf(const std::string& event) {
    if (begins(event, kMode)) return "mode";
    if (begins(event, kWind) || ends(event, kOver)) return "fault";
    if (event == "armed" || event == "disarmed") return "armed";
    return "item";
}

bool isFailsafe(const std::string& text) {
    const auto& all = failsafeTexts();
    return std::any_of(all.begin(), all.end(),
                       [&](const FailsafeTexts& each) { return begins(text, each.begins); });
}

std::vector<DocumentEvent> eventsOf(const Summary& summary) {
    std::vector<DocumentEvent> events;
    const auto isFault = [&](const std::string& text) {
        return std::any_of(summary.faults.begin(), summary.faults.end(),
                           [&](const FaultSpan& fault) { return fault.name == text; });
    };
    for (const Event& event : summary.events)
        if (!isFault(event.text))  // they follow below
            events.push_back({event.time_s, kindOf(event.text), event.text, {}});
    for (const Event& text : summary.texts)
        events.push_back(
            {text.time_s, isFailsafe(text.text) ? "failsafe" : "text", text.text, text.severity});
    for (const Event& violation : summary.violations)
        events.push_back({violation.time_s, "error", "violated: " + violation.text, 2});
    for (const FaultSpan& fault : summary.faults)
        if (fault.from_s <= summary.emulated_s)
            events.push_back({fault.from_s, "fault", "fault injected: " + fault.name, {}});
    std::stable_sort(events.begin(), events.end(),
                     [](auto& a, auto& b) { return a.time_s < b.time_s; });
    return events;
}

void addModes(std::vector<DocumentBand>& bands, const Summary& summary) {
    DocumentBand* last = nullptr;
    for (const Event& event : summary.events) {
        if (!begins(event.text, kMode)) continue;
        if (last != nullptr) last->to_s = event.time_s;
        bands.push_back(
            {"mode", event.text.substr(sizeof kMode - 1), event.time_s, summary.emulated_s});
        last = &bands.back();
    }
}

std::vector<DocumentBand> bandsOf(const Summary& summary) {
    std::vector<DocumentBand> bands;
    addModes(bands, summary);
    for (const DocumentBand& band : failsafeBands(summary.texts, summary.emulated_s))
        bands.push_back(band);
    for (const FaultSpan& fault : summary.faults)
        if (fault.from_s < summary.emulated_s)
            bands.push_back(
                {"fault", fault.name, fault.from_s, std::min(fault.to_s, summary.emulated_s)});
    return bands;
}

std::string titleOf(const Summary& summary) {
    const Provenance& from = summary.provenance;
    std::string title = summary.mission;
    if (!from.airplane.empty()) title += " · " + from.airplane;
    title += " · " + summary.firmware;
    if (!from.native) title += " on " + summary.board;
    if (!from.wind.empty()) title += " · " + from.wind;
    return title + " · seed " + std::to_string(summary.seed);
}

}  // namespace

DocumentPlan planOf(const MissionFile& mission, std::optional<double> loiter_radius_m) {
    DocumentPlan plan;
    const double home_m = mission.items.empty() ? 0 : mission.items[0].altitude_m;
    for (const WaypointItem& item : mission.items) {
        if (item.index == 0)
            plan.home = {item.latitude_deg, item.longitude_deg, item.altitude_m};
        else
            plan.items.push_back(itemOf(item, home_m, loiter_radius_m));
    }
    for (const FenceArea& area : mission.fence.areas) {
        DocumentZone zone = {area.inclusion, {}, {}};
        for (const Place& place : area.rim)
            zone.rim.push_back({place.latitude_deg, place.longitude_deg, {}});
        if (area.isCircle()) zone.radius_m = area.radius_m;
        if (area.inclusion && !area.isCircle() && plan.fence.empty())
            plan.fence = zone.rim;
        else
            plan.zones.push_back(zone);
    }
    for (const RallyPlace& rally : mission.rally)
        plan.rally.push_back(
            {rally.place.latitude_deg, rally.place.longitude_deg, home_m + rally.height_m});
    return plan;
}

std::vector<DocumentBand> failsafeBands(const std::vector<Event>& texts, double end_s) {
    std::vector<DocumentBand> bands;
    for (const FailsafeTexts& each : failsafeTexts()) {
        bool open = false;
        for (const Event& said : texts) {
            if (!open && begins(said.text, each.begins)) {
                bands.push_back({"failsafe", each.begins, said.time_s, end_s});
                open = true;
            } else if (open && !each.ends.empty() && begins(said.text, each.ends)) {
                bands.back().to_s = said.time_s;
                open = false;
            }
        }
    }
    return bands;
}

FlightDocument documentOf(const Summary& summary, const std::vector<Sample>& samples,
                          const MissionFile& mission) {
    FlightDocument document;
    document.kind = "simulated";
    document.title = titleOf(summary);
    document.good = summary.completed;
    document.verdict = summary.completed ? "mission completed" : summary.reason;
    document.provenance = summary.provenance;
    document.plan = planOf(mission, summary.loiter_radius_m);
    addSeries(document, samples);
    document.events = eventsOf(summary);
    document.bands = bandsOf(summary);
    document.deviations = deviationsOf(summary);
    document.tables = tablesOf(summary);
    return document;
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/flight_document.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "simulator/report/document_numbers.hpp"

namespace simulator {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;

Json rounded(double value, double parts) { return std::round(value * parts) / parts; }
Json time(double time_s) { return rounded(time_s, 1e3); }

Json placeOf(const DocumentPlace& place) {
    Json json = {{"lat_deg", rounded(place.latitude_deg, 1e7)},
                 {"lon_deg", rounded(place.longitude_deg, 1e7)}};
    if (place.altitude_m) json["altitude_m"] = rounded(*place.altitude_m, 1e2);
    return json;
}

Json placesOf(const std::vector<DocumentPlace>& places) {
    Json json = Json::array();
    for (const DocumentPlace& place : places) json.push_back(placeOf(place));
    return json;
}

Json itemOf(const DocumentItem& item) {
    Json json = {{"index", item.index}, {"name", item.name}, {"text", item.text}};
    if (item.place) json.update(placeOf(*item.place));
    if (item.radius_m) json["radius_m"] = *item.radius_m;
    return json;
}

Json zoneOf(const DocumentZone& zone) {
    Json json = {{"keeps", zone.keeps_in ? "in" : "out"}, {"rim", placesOf(zone.rim)}};
    if (zone.radius_m) json["radius_m"] = *zone.radius_m;
    return json;
}

Json planOf(const DocumentPlan& plan) {
    Json json = Json::object();
    if (plan.home) json["home"] = placeOf(*plan.home);
    json["items"] = Json::array();
    for (const DocumentItem& item : plan.items) json["items"].push_back(itemOf(item));
    json["fence"] = placesOf(plan.fence);
    if (!plan.zones.empty()) json["zones"] = Json::array();
    for (const DocumentZone& zone : plan.zones) json["zones"].push_back(zoneOf(zone));
    json["rally"] = placesOf(plan.rally);
    return json;
}

Json valuesOf(const std::vector<double>& values) {
    if (values.empty()) return Json::array();
    const Steps steps = stepsOf(values);
    return {{"i16", steps.base64}, {"scale", steps.scale}, {"offset", steps.offset}};
}

Json seriesOf(const DocumentSeries& series) {
    Json json = {{"name", series.name},
                 {"title", series.title},
                 {"unit", series.unit},
                 {"group", series.group}};
    if (!series.kind.empty()) json["kind"] = series.kind;
    json["time"] = series.time;
    json["values"] = valuesOf(series.values);
    return json;
}

Json eventOf(const DocumentEvent& event) {
    Json json = {{"time_s", time(event.time_s)}, {"kind", event.kind}, {"text", event.text}};
    if (event.severity) json["severity"] = *event.severity;
    return json;
}

Json bandOf(const DocumentBand& band) {
    return {{"kind", band.kind},
            {"name", band.name},
            {"from_s", time(band.from_s)},
            {"to_s", time(band.to_s)}};
}

Json deviationOf(const Deviation& deviation) {
    Json json = {{"name", deviation.name},
                 {"value", rounded(deviation.value, 1e3)},
                 {"unit", deviation.unit}};
    if (!deviation.goal) return json;
    json["goal"] = *deviation.goal;
    json["met"] = deviation.met();
    return json;
}

Json tableOf(const DocumentTable& table) {
    return {
        {"title", table.title}, {"note", table.note}, {"heads", table.heads}, {"rows", table.rows}};
}

template <class Entry>
Json listOf(const std::vector<Entry>& entries, Json (*one)(const Entry&)) {
    Json json = Json::array();
    for (const Entry& entry : entries) json.push_back(one(entry));
    return json;
}

Json floats(const std::vector<double>& times) { return {{"f32", floatsOf(times)}}; }

}  // namespace

std::string flightJson(const FlightDocument& document) {
    Json json = {{"format", "apm-flight"},
                 {"version", kVersion},
                 {"kind", document.kind},
                 {"title", document.title}};
    if (!document.verdict.empty())
        json["verdict"] = {{"good", document.good}, {"text", document.verdict}};
    json["provenance"] = Json::parse(provenanceJson(document.provenance));
    json["plan"] = planOf(document.plan);
    json["series"] = listOf(document.series, seriesOf);
    json["times"] = listOf(document.times, floats);
    json["events"] = listOf(document.events, eventOf);
    json["bands"] = listOf(document.bands, bandOf);
    json["deviations"] = listOf(document.deviations, deviationOf);
    json["tables"] = listOf(document.tables, tableOf);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/document.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "simulator/live/command_names.hpp"
#include "simulator/live/held_mission.hpp"
#include "simulator/live/order.hpp"

namespace simulator::live {
namespace {

// Hundredths say all there is to say of a moment.
double rounded(double time_s) { return std::round(time_s * 100) / 100; }

Json placeJson(const WaypointItem& item) {
    return {{"lat_deg", item.latitude_deg}, {"lon_deg", item.longitude_deg}};
}

Json placeJson(const WaypointItem& item, double home_m) {
    Json json = placeJson(item);
    json["altitude_m"] = item.altitude_m + (item.relative() ? home_m : 0);
    return json;
}

Json itemJson(const WaypointItem& item, double home_m) {
    Json json = {{"index", item.index},
                 {"name", item.index == 0 ? "HOME" : commandName(item.command)},
                 {"text", itemText(item)}};
    if (item.isPlaced()) json.update(placeJson(item, home_m));
    return json;
}

// The first polygon to stay in is the fence, the others are beside it.
void putZone(Json& plan, const FenceArea& area) {
    Json rim = Json::array();
    for (const Place& place : area.rim)
        rim.push_back({{"lat_deg", place.latitude_deg}, {"lon_deg", place.longitude_deg}});
    if (area.inclusion && !area.isCircle() && plan["fence"].empty()) {
        plan["fence"] = rim;
        return;
    }
    Json zone = {{"keeps", area.inclusion ? "in" : "out"}, {"rim", rim}};
    if (area.isCircle()) zone["radius_m"] = area.radius_m;
    plan["zones"].push_back(zone);
}

}  // namespace

Json eventJson(const ChronicleEvent& event) {
    Json json = {{"time_s", rounded(event.time_s)}, {"kind", event.kind}, {"text", event.text}};
    if (event.severity) json["severity"] = *event.severity;
    return json;
}

Json bandJson(const Band& band) {
    Json json = {{"kind", band.kind}, {"name", band.name}, {"from_s", rounded(band.from_s)}};
    if (band.to_s) json["to_s"] = rounded(*band.to_s);
    return json;
}

Json planJson(const PlanDownload& plans, const Truth& start) {
    Json json = {{"items", Json::array()}, {"fence", Json::array()}, {"rally", Json::array()}};
    const Waypoints& mission = plans.items(0);
    const bool has_home = !mission.empty() && mission[0].isPlaced();
    const double home_m = has_home ? mission[0].altitude_m : start.altitude_m;
    json["home"] = {{"lat_deg", start.latitude_deg},
                    {"lon_deg", start.longitude_deg},
                    {"altitude_m", start.altitude_m}};
    if (has_home) json["home"] = placeJson(mission[0], 0);
    for (const WaypointItem& item : mission) json["items"].push_back(itemJson(item, home_m));
    for (const FenceArea& area : heldFence(plans.items(1)).areas) putZone(json, area);
    for (const WaypointItem& point : plans.items(2))
        json["rally"].push_back(placeJson(point, home_m));
    return json;
}

std::string documentJson(const Origin& origin, const PlanDownload& plans,
                         const Chronicle& chronicle) {
    Json json = {{"format", "apm-flight"}, {"version", 1}, {"kind", "live"}};
    json["title"] = origin.title;
    json["provenance"] = Json::parse(origin.provenance);
    json["plan"] = planJson(plans, origin.start);
    json["offers"] = {{"modes", modeNames()}, {"faults", faultNames()}};
    json["times"] = Json::array();
    json["series"] = seriesJson();
    json["events"] = Json::array();
    for (const ChronicleEvent& event : chronicle.events())
        json["events"].push_back(eventJson(event));
    json["bands"] = Json::array();
    for (const Band& band : chronicle.bands()) json["bands"].push_back(bandJson(band));
    return dumped(json);
}

std::string dumped(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace simulator::live

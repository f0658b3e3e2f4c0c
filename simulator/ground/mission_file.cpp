// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/mission_file.hpp"

#include <utility>

#include "simulator/ground/plan_file.hpp"
#include "simulator/ground/points_file.hpp"
#include "simulator/ground/text_file.hpp"
#include "simulator/input_file.hpp"

namespace simulator {
namespace {

constexpr struct {
    const char *holds, *kind;
} kForeign[] = {
    {"<kml", "a KML file: it has places, but no commands"},
    {"<gpx", "a GPX file: it has places, but no commands"},
    {"<?xml", "an XML file"},
    {"PK\x03\x04", "a compressed file (of KML it is .kmz)"},
};

constexpr uint8_t kGlobal = 0, kAboveHome = 3;  // MAV_FRAME

void addPoint(Waypoints& to, uint16_t command, double param1, const Place& place,
              double altitude_m = 0) {
    WaypointItem item;
    item.index = static_cast<int>(to.size());
    item.command = command;
    item.frame = command == mavlink::MavCmd::nav_rally_point ? kAboveHome : kGlobal;
    item.params[0] = param1;
    item.latitude_deg = place.latitude_deg;
    item.longitude_deg = place.longitude_deg;
    item.altitude_m = altitude_m;
    to.push_back(item);
}

}  // namespace

Waypoints fenceItems(const Fence& fence) {
    Waypoints items;
    for (const FenceArea& area : fence.areas) {
        const uint16_t polygon = area.inclusion ? kPolygonInside : kPolygonOutside;
        const uint16_t circle = area.inclusion ? kCircleInside : kCircleOutside;
        const double param1 =
            area.isCircle() ? area.radius_m : static_cast<double>(area.rim.size());
        for (const Place& place : area.rim)
            addPoint(items, area.isCircle() ? circle : polygon, param1, place);
    }
    if (fence.way_back)
        addPoint(items, mavlink::MavCmd::nav_fence_return_point, 0, *fence.way_back);
    return items;
}

Waypoints rallyItems(const std::vector<RallyPlace>& rally) {
    Waypoints items;
    for (const RallyPlace& each : rally)
        addPoint(items, mavlink::MavCmd::nav_rally_point, 0, each.place, each.height_m);
    return items;
}

std::string foreignMission(const std::string& text) {
    constexpr size_t kHead = 500;
    const std::string head = text.substr(0, kHead);
    const size_t first = head.find_first_not_of(" \t\r\n");
    if (looksLikePoints(text)) return "a file of fence or rally points, which has no mission";
    for (const auto& each : kForeign) {
        const size_t at = head.find(each.holds);
        const bool is_tag = each.holds[0] == '<';
        const bool xml = is_tag && first != std::string::npos && head[first] == '<';
        if (at != std::string::npos && (xml || at == 0)) return each.kind;
    }
    return "";
}

MissionFile readMissionLines(const std::string& bytes, const std::string& name) {
    MissionFile mission;
    if (const std::string why = whyNoText(bytes); !why.empty()) {
        mission.errors.push_back({1, 1, name + ": " + why});
        return mission;
    }
    const std::string text = decodedText(bytes);
    if (looksLikeJson(text)) return readPlan(text, name);
    if (const std::string kind = foreignMission(text); !kind.empty()) {
        mission.errors.push_back({1, 1, name + ": expected QGC WPL 110 or a .plan, found " + kind});
        return mission;
    }
    WaypointReading reading = readWaypointLines(bytes, name);
    mission.items = std::move(reading.items);
    mission.errors = std::move(reading.errors);
    return mission;
}

void throwErrors(const MissionFile& mission) {
    std::vector<std::string> texts;
    for (const LineError& error : mission.errors) texts.push_back(error.text);
    if (!texts.empty()) throw WaypointError(listed(texts));
}

MissionFile parseMissionFile(const std::string& bytes, const std::string& name) {
    MissionFile mission = readMissionLines(bytes, name);
    throwErrors(mission);
    return mission;
}

MissionFile readMissionFile(const std::string& path) {
    const auto bytes = wholeFile(path);
    if (!bytes) throw WaypointError(path + ": cannot be read");
    return parseMissionFile(*bytes, path);
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// A mission and what belongs to it, fence and rally points, from any file that ground stations
// write: QGC WPL 110, or QGroundControl's .plan.
#pragma once
#include <optional>

#include "simulator/ground/waypoints.hpp"

namespace simulator {

// MAV_CMD_NAV_FENCE_...
constexpr uint16_t kPolygonInside = 5001, kPolygonOutside = 5002, kCircleInside = 5003,
                   kCircleOutside = 5004;

struct Place {
    double latitude_deg = 0, longitude_deg = 0;
};

struct FenceArea {
    bool inclusion = true;   // to be stayed in; else to be stayed out of
    std::vector<Place> rim;  // corners; of a circle its centre alone
    double radius_m = 0;     // of a circle; 0: a polygon
    bool isCircle() const { return radius_m > 0; }
};

struct Fence {
    std::vector<FenceArea> areas;
    std::optional<Place> way_back;
    bool given() const { return !areas.empty() || way_back; }
};

struct RallyPlace {
    Place place;
    double height_m = 0;  // above home
};

struct Remark {
    int line, column;  // of the file
    std::string text;  // what of the file is not flown
};

struct MissionFile {
    Waypoints items;
    Fence fence;
    std::vector<RallyPlace> rally;
    std::vector<Remark> remarks;
    std::vector<LineError> errors;

    // Not empty: the board has the mission already, and the items only say where it leads. These
    // NAVs are reached, in this order.
    std::vector<int> stored_navs = {};
};

// Never throws: what cannot be read is in `errors`.
MissionFile readMissionLines(const std::string& bytes, const std::string& name);

void throwErrors(const MissionFile& mission);  // if there are any; a WaypointError

// Throw WaypointError.
MissionFile parseMissionFile(const std::string& bytes, const std::string& name);
MissionFile readMissionFile(const std::string& path);

// As the mission protocol carries them: MAV_CMD_NAV_FENCE_... and MAV_CMD_NAV_RALLY_POINT.
Waypoints fenceItems(const Fence& fence);
Waypoints rallyItems(const std::vector<RallyPlace>& rally);

// What a text is that holds no mission for us ("a KML file: ..."); empty: not known.
std::string foreignMission(const std::string& text);

}  // namespace simulator

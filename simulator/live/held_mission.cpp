// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/held_mission.hpp"

namespace simulator::live {
namespace {

constexpr uint16_t kReturnPoint = 5000, kCorner = 5001, kCornerOutside = 5002, kCircle = 5003,
                   kCircleOutside = 5004, kRallyPoint = 5100;  // MAV_CMD

Place placeOf(const WaypointItem& item) { return {item.latitude_deg, item.longitude_deg}; }

bool isCorner(const WaypointItem& item) {
    return item.command == kCorner || item.command == kCornerOutside;
}

// The polygon that begins at `from`; empty: it is not whole.
std::vector<Place> polygonAt(const Waypoints& items, size_t from) {
    const double corners = items[from].params[0];
    std::vector<Place> rim;
    for (size_t i = from; i < items.size() && static_cast<double>(rim.size()) < corners; ++i) {
        if (items[i].command != items[from].command || items[i].params[0] != corners) break;
        rim.push_back(placeOf(items[i]));
    }
    return static_cast<double>(rim.size()) == corners ? rim : std::vector<Place>();
}

}  // namespace

Fence heldFence(const Waypoints& items) {
    Fence fence;
    for (size_t i = 0; i < items.size(); ++i) {
        const WaypointItem& item = items[i];
        if (item.command == kReturnPoint) fence.way_back = placeOf(item);
        if (item.command == kCircle || item.command == kCircleOutside)
            fence.areas.push_back({item.command == kCircle, {placeOf(item)}, item.params[0]});
        if (!isCorner(item)) continue;
        const std::vector<Place> rim = polygonAt(items, i);
        if (rim.empty()) continue;
        fence.areas.push_back({item.command == kCorner, rim, 0});
        i += rim.size() - 1;
    }
    return fence;
}

MissionFile heldMission(const Waypoints& mission, const Waypoints& fence, const Waypoints& rally) {
    MissionFile held;
    held.items = mission;
    held.fence = heldFence(fence);
    for (const WaypointItem& item : rally)
        if (item.command == kRallyPoint) held.rally.push_back({placeOf(item), item.altitude_m});
    return held;
}

}  // namespace simulator::live

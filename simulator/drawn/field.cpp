// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/drawn/field.hpp"

#include <algorithm>
#include <cmath>

#include "simulator/airplane/earth.hpp"

namespace simulator::drawn {
namespace {

constexpr int kWaypoint = 16, kLoiterTurns = 18, kLand = 21, kTakeoff = 22, kChangeSpeed = 178;
constexpr int kAbsolute = 0, kAboveHome = 3;

// Places are along the runway and to its right.
class Layout {
public:
    explicit Layout(const WorldOptions& world) : world_(world) {
        WaypointItem& home = add(kWaypoint, 0);
        home.frame = kAbsolute;
        home.latitude_deg = world.latitude_deg;
        home.longitude_deg = world.longitude_deg;
        home.altitude_m = world.altitude_m;
    }

    WaypointItem& add(int command, double altitude_m) {
        WaypointItem item;
        item.index = static_cast<int>(items_.size());
        item.frame = kAboveHome;
        item.command = static_cast<uint16_t>(command);
        item.altitude_m = altitude_m;
        items_.push_back(item);
        return items_.back();
    }
    WaypointItem& addAt(int command, double ahead_m, double right_m, double altitude_m) {
        const double heading = world_.heading_deg * M_PI / 180;
        const double c = std::cos(heading), s = std::sin(heading);
        const Place place = moved({world_.latitude_deg, world_.longitude_deg}, world_.altitude_m,
                                  c * ahead_m - s * right_m, s * ahead_m + c * right_m);
        WaypointItem& item = add(command, altitude_m);
        item.latitude_deg = place.latitude_deg;
        item.longitude_deg = place.longitude_deg;
        return item;
    }
    Waypoints done() const { return items_; }

private:
    const WorldOptions& world_;
    Waypoints items_;
};

}  // namespace

Waypoints boxMission(const WorldOptions& world, const FieldPlan& field) {
    constexpr double kLeg_m = 600, kHeight_m = 100, kFinal_m = 30;
    const double climb_m = std::min(50.0, field.climb * kLeg_m);
    const double final_m = kFinal_m / field.slope, low_m = kFinal_m + 5;
    const double gate_m = -final_m - 200;
    Layout box(world);
    box.add(kTakeoff, 50).params[0] = 15;
    box.addAt(kWaypoint, kLeg_m, 0, kHeight_m);
    box.addAt(kWaypoint, 2 * kLeg_m, 0, kHeight_m);
    box.addAt(kWaypoint, 2 * kLeg_m, kLeg_m, kHeight_m + climb_m);
    box.addAt(kWaypoint, kLeg_m, kLeg_m, kHeight_m + climb_m);
    box.addAt(kWaypoint, 0, kLeg_m, kHeight_m);
    box.addAt(kWaypoint, 0, 0, kHeight_m);
    box.addAt(kWaypoint, kLeg_m, 0, kHeight_m);
    box.addAt(kLoiterTurns, kLeg_m, -400, kHeight_m).params[0] = 2;
    box.addAt(kWaypoint, 0, -400, 70);
    box.addAt(kWaypoint, gate_m, -400, 45);
    WaypointItem& speed = box.add(kChangeSpeed, 0);
    speed.params[1] = field.approach_mps;
    speed.params[2] = -1;
    box.addAt(kWaypoint, gate_m, 0, low_m);
    box.addAt(kWaypoint, -final_m, 0, kFinal_m);
    box.addAt(kLand, 0, 0, 0);
    return box.done();
}

Waypoints tuningMission(const WorldOptions& world) {
    Layout field(world);
    field.add(kTakeoff, 60).params[0] = 15;
    field.addAt(kWaypoint, 800, 0, 120);
    field.addAt(kLand, 0, 0, 0);
    return field.done();
}

}  // namespace simulator::drawn

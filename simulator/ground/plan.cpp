// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/plan.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {

double distance_m(const Point& a, const Point& b) {
    return std::hypot(a.north_m - b.north_m, a.east_m - b.east_m);
}

LocalFrame::LocalFrame(double latitude_deg, double longitude_deg)
    : latitude_deg_(latitude_deg), longitude_deg_(longitude_deg) {
    constexpr double kRadius_m = 6378137, kEccentricity2 = 6.69437999014e-3;  // WGS84
    constexpr double kDegree = M_PI / 180;
    const double sine = std::sin(latitude_deg * kDegree);
    const double w = std::sqrt(1 - kEccentricity2 * sine * sine);
    metres_per_degree_north_ = kRadius_m * (1 - kEccentricity2) / (w * w * w) * kDegree;
    metres_per_degree_east_ = kRadius_m / w * std::cos(latitude_deg * kDegree) * kDegree;
}

Point LocalFrame::at(double latitude_deg, double longitude_deg) const {
    return {(latitude_deg - latitude_deg_) * metres_per_degree_north_,
            std::remainder(longitude_deg - longitude_deg_, 360) * metres_per_degree_east_};
}

Along along(const Point& from, const Point& to, const Point& place) {
    const double length = distance_m(from, to);
    if (length < 0.01) return {0, 0, 0};
    const double north = (to.north_m - from.north_m) / length;
    const double east = (to.east_m - from.east_m) / length;
    const double dn = place.north_m - from.north_m, de = place.east_m - from.east_m;
    return {dn * north + de * east, de * north - dn * east, length};
}

const PlannedNav* Plan::nav(int item) const {
    const auto found =
        std::find_if(navs.begin(), navs.end(), [&](auto& nav) { return nav.item == item; });
    return found == navs.end() ? nullptr : &*found;
}

std::optional<Point> Plan::landing() const {
    if (navs.empty() || navs.back().command != mavlink::MavCmd::nav_land) return std::nullopt;
    return navs.back().place;
}

double Plan::height_m(const PlannedNav& nav, const Point& from, const Point& place) {
    if (!nav.place) return nav.height_m;
    const Along on = along(from, *nav.place, place);
    const double share = on.length_m > 0 ? std::clamp(on.along_m / on.length_m, 0.0, 1.0) : 1;
    return nav.from_height_m + share * (nav.height_m - nav.from_height_m);
}

std::vector<int> navsInTurn(const Waypoints& items) {
    constexpr uint16_t kJump = 177;  // MAV_CMD_DO_JUMP
    constexpr int kMaxSteps = 100'000;
    const double count = static_cast<double>(items.size());
    std::vector<int> navs;
    std::vector<double> taken(items.size(), 0);  // of a jump: times
    size_t i = 1;
    for (int steps = 0; i < items.size() && steps < kMaxSteps; ++steps, ++i) {
        const WaypointItem& item = items[i];
        if (item.isNav()) navs.push_back(item.index);
        if (item.command != kJump) continue;
        const double target = item.params[0], times = item.params[1];
        const bool ahead = target > static_cast<double>(i) && target < count;
        const bool again = target >= 1 && target < static_cast<double>(i) && taken[i] < times;
        if (!again && !(ahead && (times < 0 || taken[i] < times))) continue;
        ++taken[i];
        i = static_cast<size_t>(target) - 1;
    }
    return navs;
}

Plan makePlan(const Waypoints& items, const LocalFrame& frame) {
    Plan plan;
    std::optional<double> airspeed;
    std::optional<Point> last;
    double last_height_m = 0;
    bool loose = true;
    for (size_t i = 1; i < items.size(); ++i) {
        const WaypointItem& item = items[i];
        if (item.command == mavlink::MavCmd::do_change_speed && item.params[0] == 0 &&
            item.params[1] > 0) {
            airspeed = item.params[1];
        }
        if (!item.isNav()) continue;
        const double height = item.altitude_m - (item.relative() ? 0 : items[0].altitude_m);
        PlannedNav nav{item.index,    item.command, {},       height, last,
                       last_height_m, loose,        airspeed, {}};
        if (item.isCircle()) nav.circle_m = item.params[2];
        if (item.isPlaced()) nav.place = frame.at(item.latitude_deg, item.longitude_deg);
        if (nav.place && item.isCircle()) nav.from_height_m = height;
        plan.navs.push_back(nav);
        last = nav.place;
        last_height_m = height;
        loose = item.isCircle() || !nav.place;
    }
    return plan;
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/fence_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "firmware/mission/fence_rally_items.hpp"
#include "storage/eeprom_map.hpp"

namespace mission_tool {
namespace {

using simulator::distance_m;
using simulator::Fence;
using simulator::FenceArea;
using simulator::Point;

double toSegment_m(const Point& place, const Point& a, const Point& b) {
    const double north = b.north_m - a.north_m, east = b.east_m - a.east_m;
    const double length2 = north * north + east * east;
    const double share =
        length2 > 0 ? std::clamp(((place.north_m - a.north_m) * north +
                                  (place.east_m - a.east_m) * east) / length2, 0.0, 1.0)
                    : 0;
    return distance_m(place, {a.north_m + share * north, a.east_m + share * east});
}

bool isWithin(const Point& place, const std::vector<Point>& rim) {
    bool within = false;
    for (size_t i = 0, j = rim.size() - 1; i < rim.size(); j = i++) {
        const Point &a = rim[i], &b = rim[j];
        if ((a.north_m > place.north_m) == (b.north_m > place.north_m)) continue;
        const double share = (place.north_m - a.north_m) / (b.north_m - a.north_m);
        if (place.east_m < a.east_m + share * (b.east_m - a.east_m)) within = !within;
    }
    return within;
}

std::string meters(double value_m) {
    char text[32];
    std::snprintf(text, sizeof text, "%g m", value_m);
    return text;
}

}  // namespace

FenceCheck::FenceCheck(const Fence& fence, const simulator::LocalFrame& frame) {
    for (const FenceArea& area : fence.areas) {
        Area added = {area.inclusion, {}, area.radius_m};
        for (const auto& place : area.rim)
            added.rim.push_back(frame.at(place.latitude_deg, place.longitude_deg));
        areas_.push_back(added);
    }
}

double FenceCheck::Area::beyond_m(const Point& place) const {
    if (radius_m > 0) return distance_m(place, rim[0]) - radius_m;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (size_t i = 0, j = rim.size() - 1; i < rim.size(); j = i++)
        nearest_m = std::min(nearest_m, toSegment_m(place, rim[j], rim[i]));
    return isWithin(place, rim) ? -nearest_m : nearest_m;
}

// As the firmware has it: in every area to stay in and in none to stay out of.
double FenceCheck::outside_m(const Point& place) const {
    double worst_m = -std::numeric_limits<double>::infinity();
    for (const Area& area : areas_) {
        const double beyond_m = area.beyond_m(place);
        worst_m = std::max(worst_m, area.inclusion ? beyond_m : -beyond_m);
    }
    return worst_m;
}

double FenceCheck::outsideOnLeg_m(const Point& from, const Point& to) const {
    constexpr double kStep_m = 2;
    constexpr int kMaxSteps = 2000;
    const double steps = std::clamp(std::ceil(distance_m(from, to) / kStep_m), 1.0, 1.0 * kMaxSteps);
    double worst_m = outside_m(from);
    for (int i = 1; i <= static_cast<int>(steps); ++i) {
        const double share = i / steps;
        worst_m = std::max(worst_m, outside_m({from.north_m + share * (to.north_m - from.north_m),
                                               from.east_m + share * (to.east_m - from.east_m)}));
    }
    return worst_m;
}

double FenceCheck::outsideOnCircle_m(const Point& centre, double radius_m) const {
    constexpr int kParts = 120;
    double worst_m = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < kParts; ++i) {
        const double angle = 2 * M_PI * i / kParts;
        worst_m = std::max(worst_m, outside_m({centre.north_m + radius_m * std::cos(angle),
                                               centre.east_m + radius_m * std::sin(angle)}));
    }
    return worst_m;
}

std::vector<FenceProblem> problemsOf(const Fence& fence, const simulator::LocalFrame& frame) {
    std::vector<FenceProblem> found;
    const auto refused = [&](const std::string& text) { found.push_back({true, text}); };
    for (const FenceArea& area : fence.areas) {
        const auto radius_dm = std::lround(area.radius_m * 10);
        if (area.isCircle() && (radius_dm < 1 || area.radius_m > firmware::mission::kLargestRadius_m))
            refused("the firmware takes circles of 0.1 to " +
                    std::to_string(std::lround(firmware::mission::kLargestRadius_m)) +
                    " m, one has a radius of " + meters(area.radius_m));
        if (!area.isCircle() && area.rim.size() < 3)
            refused("a polygon has " + std::to_string(area.rim.size()) + " corners, fewer than 3");
    }
    const size_t points = simulator::fenceItems(fence).size();
    if (points > storage::kFencePoints)
        refused("the firmware takes " + std::to_string(storage::kFencePoints) +
                " points, return point included, this has " + std::to_string(points));
    if (!fence.way_back) {
        if (!fence.areas.empty())
            found.push_back({false, "it has no return point: broken, it means RTL"});
        return found;
    }
    const double beyond_m = FenceCheck(fence, frame).outside_m(
        frame.at(fence.way_back->latitude_deg, fence.way_back->longitude_deg));
    if (!fence.areas.empty() && beyond_m >= 0)
        refused("its return point is " + std::to_string(std::lround(beyond_m)) +
                " m outside: the fence is not fit");
    return found;
}

}  // namespace mission_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// The mission as geometry: for every NAV command the leg that leads to it, in metres north and
// east of home. A leg begins at the place of the NAV before it, or, where that has none, wherever
// the airplane is when it sets out.
#pragma once
#include <optional>
#include <vector>

#include "simulator/ground/waypoints.hpp"

namespace simulator {

struct Point {
    double north_m = 0, east_m = 0;
};
double distance_m(const Point& a, const Point& b);

// Tangent plane at one place, with the WGS84 ellipsoid's radii of curvature there.
class LocalFrame {
public:
    LocalFrame(double latitude_deg, double longitude_deg);
    Point at(double latitude_deg, double longitude_deg) const;

private:
    double latitude_deg_, longitude_deg_;
    double metres_per_degree_north_, metres_per_degree_east_;
};

// Where `place` is along and across the line `from` to `to`; across is positive to the right.
struct Along {
    double along_m, across_m, length_m;
};
Along along(const Point& from, const Point& to, const Point& place);

struct PlannedNav {
    int item;  // index in the file
    uint16_t command;
    std::optional<Point> place;  // empty: takeoff, return, or "here"
    double height_m;             // above home, at the end
    std::optional<Point> from;   // empty: where the airplane is
    double from_height_m;
    bool from_circle;  // the leg leaves a circle, or the take-off run, at any bearing
    std::optional<double> airspeed_mps;  // demanded by a DO_CHANGE_SPEED before it
    std::optional<double> circle_m;      // radius, below 0 to the left; 0: the autopilot's own
};

struct Plan {
    std::vector<PlannedNav> navs;
    const PlannedNav* nav(int item) const;  // nullptr: no NAV has this index
    std::optional<Point> landing() const;   // of the last NAV, when it is a LAND
    // The height the leg to `nav` asks for at `place`, begun at `from`.
    static double height_m(const PlannedNav& nav, const Point& from, const Point& place);
};

// The items that are reached, in their order, with the jumps between them. One back for ever counts
// as passed over: with it no flight ends.
std::vector<int> navsInTurn(const Waypoints& items);

Plan makePlan(const Waypoints& items, const LocalFrame& frame);

}  // namespace simulator

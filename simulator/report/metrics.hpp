// SPDX-License-Identifier: GPL-3.0-or-later
// How well the mission was flown, from the truth against the plan. What counts:
//  crosstrack  on straight legs, the approach to a LAND down to 5 m included, from 5 s after the
//              leg began (15 s when it leaves a circle or the take-off run, at any bearing)
//  settled     the same crosstrack from five seconds later
//  altitude    against the straight line between the heights of a leg's ends, on legs to
//              waypoints and on circles, counted as above; not in the approach to a LAND; of it
//              level on circles and legs whose ends are within 1 m of one height, and sloped
//  airspeed    equivalent airspeed against the demanded cruise speed, where altitude counts
//  slowest     equivalent airspeed on legs and circles from their first moment on, at 5 m or more
//              above the ground
//  radius      distance from a circle's centre against its radius, from 5 s after the airplane
//              has come to a tenth of a radius from it
#pragma once
#include <optional>

#include "simulator/ground/plan.hpp"
#include "simulator/world.hpp"

namespace simulator {

class Spread {
public:
    void add(double error);
    std::optional<double> rms() const;  // empty when nothing was added
    std::optional<double> max() const;

private:
    double squares_ = 0, max_ = 0;
    long count_ = 0;
};

// What the plan says of this moment; empty where it says nothing.
struct Planned {
    std::optional<double> height_m, crosstrack_m, airspeed_mps;
    bool counts = false;  // the leg has been captured
};

class Metrics {
public:
    Metrics(const Plan& plan, std::optional<double> cruise_speed_mps)
        : plan_(plan), cruise_speed_mps_(cruise_speed_mps) {}
    void setCruiseSpeed(std::optional<double> mps) { cruise_speed_mps_ = mps; }
    // The autopilot's own, for circles whose radius is 0.
    void setLoiterRadius(std::optional<double> m) { loiter_radius_m_ = m; }
    // The zero of a plan's heights: where the airplane was armed, which may be a ramp.
    void setHomeHeight(double m) { home_height_m_ = m; }

    // `item`: index of the NAV being flown in AUTO, 0 when none. In order of time.
    Planned sample(double time_s, const Truth& truth, const Point& place, int item);

    Spread crosstrack, settled, altitude, level, sloped, airspeed, radius;
    std::optional<double> slowest_mps;  // empty where none of it was flown

private:
    void begin(double time_s, const Point& place, int item);
    void measureStraight(Planned& planned, const Truth& truth, const Point& place,
                         double captured_s);
    void measureCircle(Planned& planned, const Point& place, double time_s);
    void measureHeight(double error_m);

    const Plan& plan_;
    std::optional<double> cruise_speed_mps_, loiter_radius_m_;
    double home_height_m_ = 0;
    const PlannedNav* nav_ = nullptr;
    Point from_;
    double begun_s_ = 0;
    std::optional<double> circling_s_;  // since when
};

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// How well the mission was flown, from the truth against the plan. What counts:
//  crosstrack  on straight legs, the approach to a LAND down to 5 m included, from 5 s after the
//              leg began (15 s when it leaves a circle or the take-off run, at any bearing)
//  altitude    against the straight line between the heights of a leg's ends, on legs to
//              waypoints and on circles, counted as above; not in the approach to a LAND
//  airspeed    equivalent airspeed against the demanded cruise speed, where altitude counts
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

    // `item`: index of the NAV being flown in AUTO, 0 when none. In order of time.
    Planned sample(double time_s, const Truth& truth, const Point& place, int item);

    Spread crosstrack, altitude, airspeed;

private:
    void begin(double time_s, const Point& place, int item);
    void judgeStraight(Planned& planned, const Truth& truth, const Point& place);
    void judgeCircle(Planned& planned) const;

    const Plan& plan_;
    std::optional<double> cruise_speed_mps_;
    const PlannedNav* nav_ = nullptr;
    Point from_;
    double begun_s_ = 0;
};

}  // namespace simulator

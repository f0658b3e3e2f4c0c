// SPDX-License-Identifier: GPL-3.0-or-later
// What an airplane of simulator/airplanes draws from its battery in steady flight: the simulator's
// own aerodynamics, propeller, motor and battery, brought into balance.
#pragma once
#include <map>
#include <tuple>

#include "simulator/airplane/parameters.hpp"

namespace mission_tool {

class Power {
public:
    explicit Power(const simulator::AirplaneParameters& airplane);

    double capacity_mah() const { return capacity_mah_; }
    // load: of the wings, 1 in level flight. More than full throttle gives: what full throttle draws.
    double battery_a(double airspeed_mps, double climb_mps, double load = 1) const;
    // That full throttle keeps up; below 0 when it does not even fly level.
    double largestClimb_mps(double airspeed_mps) const;

private:
    double drag_n(double airspeed_mps, double load) const;
    struct Steady {
        double thrust_n, battery_a;
    };
    Steady steady(double throttle, double airspeed_mps) const;

    simulator::AirplaneParameters airplane_;  // its battery half full, and staying so
    double capacity_mah_;
    mutable std::map<std::tuple<int, int, int>, double> known_;  // cm/s, cm/s, %
};

}  // namespace mission_tool

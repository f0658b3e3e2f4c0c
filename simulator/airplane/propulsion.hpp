// SPDX-License-Identifier: GPL-3.0-or-later
// Battery, speed controller, motor and propeller; the propeller turns as their torques allow.
#pragma once
#include "simulator/airplane/parameters.hpp"

namespace simulator {

class Propulsion {
public:
    explicit Propulsion(const AirplaneParameters& p);

    // `ahead_mps`: air speed along the shaft.
    void advance(double dt_s, double throttle, double ahead_mps, double density_kgm3);
    double thrust_n(double ahead_mps, double density_kgm3) const;
    double torque_nm(double ahead_mps, double density_kgm3) const;  // that the propeller takes
    double slipstream_pa(double thrust_n) const;  // dynamic pressure added at the tail

    double battery_v() const { return battery_v_; }
    double battery_a() const { return battery_a_; }
    double used_mah() const { return used_mah_; }
    double shaft_rads() const { return shaft_rads_; }
    double throttle() const { return throttle_; }  // after the controller's own lag

private:
    double openCircuit_v() const;

    const AirplaneParameters& p_;
    double shaft_rads_ = 0, throttle_ = 0;
    double used_mah_ = 0, battery_a_ = 0;
    double battery_v_;  // found by what is used: it comes last
};

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// Servos follow their demand with a lag and no faster than they can turn, and not at all within
// their deadband; a linkage turns what they do into the surface's travel.
#pragma once
#include "simulator/airplane/aerodynamics.hpp"
#include "simulator/airplane/parameters.hpp"

namespace simulator {

class Servos {
public:
    explicit Servos(const AirplaneParameters& p) : p_(p) {}

    void advance(double dt_s, const Controls& demand);
    const Controls& at() const { return surfaces_; }
    void put(const Controls& at) { at_ = surfaces_ = at; }  // servos and surfaces

private:
    double follow(double at, double demand, double dt_s) const;
    double linked(double travel) const;

    const AirplaneParameters& p_;
    Controls at_, surfaces_;
};

}  // namespace simulator

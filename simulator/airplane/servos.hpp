// SPDX-License-Identifier: GPL-3.0-or-later
// Servos follow their demand with a lag and no faster than they can turn.
#pragma once
#include "simulator/airplane/aerodynamics.hpp"
#include "simulator/airplane/parameters.hpp"

namespace simulator {

class Servos {
public:
    explicit Servos(const AirplaneParameters& p) : p_(p) {}

    void advance(double dt_s, const Controls& demand);
    const Controls& at() const { return at_; }
    void put(const Controls& at) { at_ = at; }

private:
    double follow(double at, double demand, double dt_s) const;

    const AirplaneParameters& p_;
    Controls at_;
};

}  // namespace simulator

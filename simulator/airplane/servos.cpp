// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/servos.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {

double Servos::follow(double at, double demand, double dt_s) const {
    if (std::abs(demand - at) < p_.linkage.deadband) return at;
    const double most = p_.controls.rate_per_s * dt_s;
    const double wanted = (demand - at) * dt_s / (p_.controls.lag_s + dt_s);
    return at + std::clamp(wanted, -most, most);
}

double Servos::linked(double travel) const {
    return travel * (1 - p_.linkage.curve + p_.linkage.curve * travel * travel);
}

void Servos::advance(double dt_s, const Controls& demand) {
    at_.aileron = follow(at_.aileron, demand.aileron, dt_s);
    at_.elevator = follow(at_.elevator, demand.elevator, dt_s);
    at_.rudder = follow(at_.rudder, demand.rudder, dt_s);
    at_.flap = follow(at_.flap, demand.flap, dt_s);
    surfaces_ = at_;
    for (double* surface : {&surfaces_.aileron, &surfaces_.elevator, &surfaces_.rudder})
        *surface = linked(*surface);
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/servos.hpp"

#include <algorithm>

namespace simulator {

double Servos::follow(double at, double demand, double dt_s) const {
    const double most = p_.controls.rate_per_s * dt_s;
    const double wanted = (demand - at) * dt_s / (p_.controls.lag_s + dt_s);
    return at + std::clamp(wanted, -most, most);
}

void Servos::advance(double dt_s, const Controls& demand) {
    at_.aileron = follow(at_.aileron, demand.aileron, dt_s);
    at_.elevator = follow(at_.elevator, demand.elevator, dt_s);
    at_.rudder = follow(at_.rudder, demand.rudder, dt_s);
}

}  // namespace simulator

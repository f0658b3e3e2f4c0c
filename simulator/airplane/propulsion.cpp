// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/propulsion.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {

Propulsion::Propulsion(const AirplaneParameters& p) : p_(p), battery_v_(openCircuit_v()) {}

double Propulsion::openCircuit_v() const {
    const auto& b = p_.battery;
    const double charge = std::max(0.0, 1 - used_mah_ / b.capacity_mah);
    const double cell_v =
        charge > b.knee_charge
            ? b.knee_v + (b.full_v - b.knee_v) * (charge - b.knee_charge) / (1 - b.knee_charge)
            : b.empty_v + (b.knee_v - b.empty_v) * charge / b.knee_charge;
    return cell_v * b.cells;
}

// T = CT rho n^2 D^4 with CT a parabola in J = V / (n D), written so that n may be 0.
double Propulsion::thrust_n(double ahead_mps, double density_kgm3) const {
    const auto& s = p_.propeller;
    const double d = s.diameter_m, tip = shaft_rads_ / (2 * M_PI) * d;  // n D
    const double v = std::max(0.0, ahead_mps);
    return density_kgm3 * d * d * (s.thrust0 * tip * tip + s.thrust1 * tip * v + s.thrust2 * v * v);
}

double Propulsion::torque_nm(double ahead_mps, double density_kgm3) const {
    const auto& s = p_.propeller;
    const double d = s.diameter_m, tip = shaft_rads_ / (2 * M_PI) * d;
    const double v = std::max(0.0, ahead_mps);
    return density_kgm3 * d * d * d *
           (s.torque0 * tip * tip + s.torque1 * tip * v + s.torque2 * v * v);
}

double Propulsion::slipstream_pa(double thrust_n) const {
    const double disc_m2 = M_PI / 4 * p_.propeller.diameter_m * p_.propeller.diameter_m;
    return std::max(0.0, p_.propeller.slipstream * thrust_n / disc_m2);
}

void Propulsion::advance(double dt_s, double throttle, double ahead_mps, double density_kgm3) {
    const auto& m = p_.motor;
    throttle_ += (throttle - throttle_) * (1 - std::exp(-dt_s / m.lag_s));
    const double duty = throttle_ < 1e-3 ? 0 : std::pow(throttle_, m.throttle_exponent);
    const double back_v = shaft_rads_ * m.volts_per_rads;
    const double current_a = std::max(0.0, (duty * battery_v_ - back_v) / m.resistance_ohm);

    const double friction_nm = shaft_rads_ > 1 ? m.idle_a * m.volts_per_rads : 0;
    const double torque_nm =
        current_a * m.volts_per_rads - friction_nm - this->torque_nm(ahead_mps, density_kgm3);
    shaft_rads_ = std::max(0.0, shaft_rads_ + torque_nm / p_.propeller.inertia_kgm2 * dt_s);

    battery_a_ = duty * current_a + p_.battery.avionics_a;
    used_mah_ += battery_a_ * dt_s / 3.6;
    battery_v_ = openCircuit_v() - battery_a_ * p_.battery.resistance_ohm;
}

}  // namespace simulator

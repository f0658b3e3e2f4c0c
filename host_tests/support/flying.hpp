// SPDX-License-Identifier: GPL-3.0-or-later
// What the flight tests share: still air at sea level, a trimmed start, a pilot good enough to
// take off and land.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>

#include "simulator/airplane/airplane.hpp"

namespace simulator {

inline WorldOptions stillAir() {
    WorldOptions options;
    options.altitude_m = 0;
    options.latitude_deg = 47;
    return options;
}

inline double seconds(const Truth& truth) { return static_cast<double>(truth.time_us) * 1e-6; }

struct Trim {
    double alpha_rad;
    Controls controls;
    double thrust_n, lift_coefficient, drag_coefficient;
};

// From the textbook's equations for straight and level flight, not from the simulation.
inline Trim trimmed(const AirplaneParameters& p, double speed_mps, double density_kgm3 = 1.225) {
    const double pressure = 0.5 * density_kgm3 * speed_mps * speed_mps * p.area_m2;
    const double elevator_rad = p.controls.elevator_deg * M_PI / 180;
    Trim trim{};
    for (int i = 0; i < 50; ++i) {
        trim.lift_coefficient =
            (p.mass_kg * kGravity_mss - trim.thrust_n * std::sin(trim.alpha_rad)) / pressure;
        trim.drag_coefficient = polar(p, trim.alpha_rad).drag;
        trim.thrust_n = trim.drag_coefficient * pressure / std::cos(trim.alpha_rad);
        Propulsion blower(p);
        const double blown = 1 + blower.slipstream_pa(trim.thrust_n) / (pressure / p.area_m2);
        const double deflection =
            -(p.pitch.at_zero + p.pitch.alpha * std::sin(trim.alpha_rad)) / p.pitch.elevator;
        trim.alpha_rad =
            (trim.lift_coefficient - p.lift.at_zero - p.lift.elevator * deflection) / p.lift.alpha;
        trim.controls.elevator = deflection / elevator_rad / blown;
    }
    double low = 0, high = 1;  // throttle, by halving
    for (int i = 0; i < 30; ++i) {
        Propulsion propulsion(p);
        trim.controls.throttle = (low + high) / 2;
        for (int k = 0; k < 800; ++k)
            propulsion.advance(Airplane::kStep_s, trim.controls.throttle, speed_mps, density_kgm3);
        (propulsion.thrust_n(speed_mps, density_kgm3) < trim.thrust_n ? low : high) =
            trim.controls.throttle;
    }
    return trim;
}

inline Motion levelFlight(double speed_mps, double alpha_rad, double height_m) {
    Motion motion;
    motion.position_m = {0, 0, -height_m};
    motion.velocity_mps = {speed_mps, 0, 0};
    motion.attitude = quaternion(0, alpha_rad, 0);
    return motion;
}

// The same airplane without the propeller's torque on the airframe and its trim against it.
inline AirplaneParameters symmetric(AirplaneParameters p) {
    p.roll.at_zero = 0;
    p.propeller.torque0 = p.propeller.torque1 = p.propeller.torque2 = 0;
    return p;
}

inline void fly(Airplane& airplane, double duration_s,
                const std::function<Controls(const Truth&)>& pilot,
                const std::function<void(const Truth&)>& watch = nullptr) {
    const auto steps = static_cast<int>(duration_s / Airplane::kStep_s + 0.5);
    for (int i = 0; i < steps; ++i) {
        airplane.step(pilot(airplane.truth()));
        if (watch) watch(airplane.truth());
    }
}

// Holds wings level, a heading on the ground and a pitch attitude.
inline Controls holdAttitude(const Truth& t, double pitch_rad, double throttle) {
    const auto limit = [](double value) { return std::clamp(value, -1.0, 1.0); };
    Controls out;
    out.aileron = limit(-1.5 * t.roll_rad - 0.15 * t.roll_rate_rads);
    out.elevator = limit(2.5 * (pitch_rad - t.pitch_rad) - 0.25 * t.pitch_rate_rads);
    out.rudder = t.on_ground ? limit(-1.5 * t.yaw_rad - 0.3 * t.yaw_rate_rads) : 0;
    out.throttle = throttle;
    return out;
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// Forces and moments of the air on the airframe, from stability derivatives and a smooth stall
// (the blending of Beard and McLain, Small Unmanned Aircraft, section 4.2).
#pragma once
#include "simulator/airplane/parameters.hpp"
#include "simulator/airplane/vector.hpp"

namespace simulator {

struct Loads {
    Vec3 force_n, moment_nm;  // body axes, about the centre of gravity
};

struct Controls {
    double aileron = 0, elevator = 0, rudder = 0;  // -1..1 of their full deflections
    double throttle = 0, flap = 0;                 // 0..1
};

struct Flow {
    Vec3 velocity_mps;  // of the airplane through the air, body axes
    Vec3 rates_rads;    // likewise
    double density_kgm3;
    double tail_pressure_pa;  // added by the propeller to the dynamic pressure at the tail

    double speed_mps() const { return length(velocity_mps); }
    double alpha_rad() const { return std::atan2(velocity_mps.z, velocity_mps.x); }
    double beta_rad() const {
        return std::atan2(velocity_mps.y, std::hypot(velocity_mps.x, velocity_mps.z));
    }
};

// Of the whole airplane by its angle of attack, rates and elevator 0.
struct Polar {
    double stalled;  // 0..1
    double lift, drag;
};
Polar polar(const AirplaneParameters& p, double alpha_rad);

Loads aerodynamics(const AirplaneParameters& p, const Flow& flow, const Controls& controls);

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/aerodynamics.hpp"

#include <algorithm>

#include "simulator/constants.hpp"

namespace simulator {
namespace {

constexpr double kTiny = 1e-9;
constexpr double kStill_mps = 0.1;  // below, the angles of the flow mean nothing

// What every coefficient is multiplied with or needs more than once.
struct State {
    double speed, alpha, sin_alpha, beta;
    Vec3 ahead;    // direction of flight through the air
    double level;  // its length in the plane of symmetry
    Polar polar;
    double p, q, r;                    // rates, made dimensionless
    double aileron, elevator, rudder;  // radians, of the free stream's dynamic pressure
    double flap;                       // 0 .. 1
};

State stateOf(const AirplaneParameters& p, const Flow& flow, const Controls& controls) {
    State s;
    s.speed = std::max(flow.speed_mps(), kStill_mps);
    s.ahead = flow.velocity_mps * (1 / s.speed);
    s.level = std::max(kTiny, std::sqrt(s.ahead.x * s.ahead.x + s.ahead.z * s.ahead.z));
    s.alpha = flow.alpha_rad();
    s.sin_alpha = s.ahead.z / s.level;
    s.beta = std::atan2(s.ahead.y, s.level);
    s.polar = polar(p, s.alpha);
    const double span = p.span_m / (2 * s.speed), chord = p.chord_m / (2 * s.speed);
    s.p = flow.rates_rads.x * span;
    s.q = flow.rates_rads.y * chord;
    s.r = flow.rates_rads.z * span;
    const double blown = 1 + flow.tail_pressure_pa / (0.5 * flow.density_kgm3 * s.speed * s.speed);
    s.aileron = controls.aileron * p.controls.aileron_deg * kRadians;
    s.elevator = controls.elevator * p.controls.elevator_deg * kRadians * blown;
    s.rudder = controls.rudder * p.controls.rudder_deg * kRadians * blown;
    s.flap = controls.flap;
    return s;
}

// Lift is across the flow in the plane of symmetry, drag along it.
Vec3 forceCoefficients(const AirplaneParameters& p, const State& s) {
    const double lift = s.polar.lift + p.lift.pitch_rate * s.q + p.lift.elevator * s.elevator +
                        p.flaps.lift * s.flap;
    const double drag = s.polar.drag + p.drag.beta2 * s.beta * s.beta + p.flaps.drag * s.flap;
    const double side = p.side.beta * s.beta + p.side.roll_rate * s.p + p.side.yaw_rate * s.r +
                        p.side.rudder * s.rudder;
    return Vec3{lift * s.sin_alpha, side, -lift * s.ahead.x / s.level} - s.ahead * drag;
}

Vec3 momentCoefficients(const AirplaneParameters& p, const State& s) {
    const double flying = 1 - p.roll.stall_loss * s.polar.stalled;
    return {p.roll.at_zero + p.roll.beta * s.beta + p.roll.yaw_rate * s.r +
                flying * (p.roll.roll_rate * s.p + p.roll.aileron * s.aileron) +
                p.roll.rudder * s.rudder,
            p.pitch.at_zero + p.pitch.alpha * s.sin_alpha + p.pitch.pitch_rate * s.q +
                p.pitch.elevator * s.elevator + p.pitch.stall * s.polar.stalled * s.sin_alpha +
                p.flaps.pitch * s.flap,
            p.yaw.beta * s.beta + p.yaw.roll_rate * s.p + p.yaw.yaw_rate * s.r +
                p.yaw.aileron * s.aileron + p.yaw.rudder * s.rudder};
}

}  // namespace

Polar polar(const AirplaneParameters& p, double alpha_rad) {
    const double above = std::exp(-p.lift.stall_sharpness * (alpha_rad - p.lift.stall_alpha_rad));
    const double below = std::exp(p.lift.stall_sharpness * (alpha_rad + p.lift.stall_alpha_rad));
    const double stall = (1 + above + below) / ((1 + above) * (1 + below));
    const double sine = std::sin(alpha_rad);
    const double attached = p.lift.at_zero + p.lift.alpha * alpha_rad;
    const double plate = 2 * std::copysign(sine * sine, alpha_rad) * std::cos(alpha_rad);
    return {stall, (1 - stall) * attached + stall * plate,
            p.drag.parasite + (1 - stall) * p.drag.induced * attached * attached +
                stall * p.drag.plate * sine * sine};
}

Loads aerodynamics(const AirplaneParameters& p, const Flow& flow, const Controls& controls) {
    const State s = stateOf(p, flow, controls);
    const double force_n = 0.5 * flow.density_kgm3 * s.speed * s.speed * p.area_m2;
    const Vec3 c = momentCoefficients(p, s);
    return {forceCoefficients(p, s) * force_n,
            Vec3{c.x * p.span_m, c.y * p.chord_m, c.z * p.span_m} * force_n};
}

}  // namespace simulator

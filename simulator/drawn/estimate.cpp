// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/drawn/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "simulator/airplane/aerodynamics.hpp"
#include "simulator/airplane/atmosphere.hpp"

namespace simulator::drawn {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kTailSlope = 4.0;     // lift slope of a tail of aspect ratio 4, per radian
constexpr double kTailPressure = 0.9;  // share of the free stream's dynamic pressure there
constexpr double kFlapEffect = 0.5;    // of a control surface of a third of the chord
constexpr double kOswald = 0.8;
constexpr double kCruiseToStall = 1.5;

void giveShape(AirplaneParameters& p, const Design& d) {
    p.mass_kg = d.mass_kg;
    p.area_m2 = d.mass_kg / d.wing_loading_kgm2;
    p.span_m = std::sqrt(d.aspect_ratio * p.area_m2);
    p.chord_m = p.area_m2 / p.span_m;
    // radii of gyration by span and length, as light airplanes have them
    const double length_m = p.chord_m * (d.tail_arm_chords + 1.5);
    const auto inertia = [&d](double radius_m) { return d.mass_kg * radius_m * radius_m; };
    p.inertia_kgm2.xx = inertia(0.13 * p.span_m);
    p.inertia_kgm2.yy = inertia(0.19 * length_m);
    p.inertia_kgm2.zz = 0.92 * (p.inertia_kgm2.xx + p.inertia_kgm2.yy);
    p.inertia_kgm2.xz = 0.03 * p.inertia_kgm2.xx;
}

void giveForces(AirplaneParameters& p, const Design& d) {
    p.lift.at_zero = 0.26;
    p.lift.alpha = 2 * M_PI * d.aspect_ratio / (d.aspect_ratio + 2);  // Helmbold's, for high ones
    p.lift.pitch_rate = 2 * kTailSlope * kTailPressure * d.tail_volume;
    p.lift.elevator = -kTailSlope * kTailPressure * kFlapEffect * d.tail_volume / d.tail_arm_chords;
    p.lift.stall_alpha_rad = 0.26;
    p.lift.stall_sharpness = 50;
    p.drag.parasite = 0.037;
    p.drag.induced = 1 / (M_PI * kOswald * d.aspect_ratio);
    p.drag.beta2 = 0.25;
    p.drag.plate = 1.6;
    const double fin_area = d.fin_volume * d.aspect_ratio / d.tail_arm_chords;  // of the wing's
    p.side.beta = -0.2 - 2.5 * fin_area;
    p.side.yaw_rate = 2 * 2.5 * d.fin_volume;
    p.side.rudder = -2.5 * kFlapEffect * fin_area;
}

void giveMoments(AirplaneParameters& p, const Design& d) {
    const double cruise_lift = 0.5;
    p.pitch.alpha = -p.lift.alpha * d.static_margin;
    p.pitch.pitch_rate = -2.2 * kTailSlope * kTailPressure * d.tail_volume * d.tail_arm_chords;
    p.pitch.elevator = kTailSlope * kTailPressure * kFlapEffect * d.tail_volume;
    p.pitch.stall = -0.3;
    // in trim at the cruising lift with the elevator in the middle
    const double alpha = (cruise_lift - p.lift.at_zero) / p.lift.alpha;
    p.pitch.at_zero = -p.pitch.alpha * std::sin(alpha);
    p.roll.at_zero = 0.001;
    p.roll.beta = -p.lift.alpha / 4 * d.dihedral_deg * kDegree;
    p.roll.roll_rate = -p.lift.alpha / 10;
    p.roll.yaw_rate = cruise_lift / 4;
    p.roll.aileron = 0.21;
    p.roll.rudder = -0.005;
    p.roll.stall_loss = 0.7;
    const double arm_spans = d.tail_arm_chords / d.aspect_ratio;
    p.yaw.beta = 2.5 * d.fin_volume - 0.02;
    p.yaw.yaw_rate = -2 * 2.5 * d.fin_volume * arm_spans - 0.01;
    p.yaw.roll_rate = -cruise_lift / 8;
    p.yaw.aileron = -0.01;
    p.yaw.rudder = 2.5 * kFlapEffect * d.fin_volume * 1.6;
}

void giveControls(AirplaneParameters& p) {
    p.controls = {};
    p.controls.aileron_deg = 20;
    p.controls.elevator_deg = 25;
    p.controls.rudder_deg = 25;
    p.controls.nose_wheel_deg = 15;
    p.controls.rate_per_s = 8;
    p.controls.lag_s = 0.03;
}

Contact wheel(const char* name, const Vec3& place_m, double stiffness_nm, double damping_nsm) {
    return {name, place_m, true, false, stiffness_nm, damping_nsm, 0.06, 0.7, 4};
}
Contact skid(const char* name, const Vec3& place_m, double stiffness_nm, double damping_nsm,
             double breaks_at_mps) {
    return {name, place_m, false, false, stiffness_nm, damping_nsm, 0.5, 0.5, breaks_at_mps};
}

// Places by the chord and the span, springs by the mass.
void giveGround(AirplaneParameters& p, const Design& d) {
    const double c = p.chord_m, half_m = p.span_m / 2, tail_m = d.tail_arm_chords * c,
                 m = p.mass_kg;
    p.grip = {500 * m, 10 * m};
    if (!d.thrown) {
        const double under_m = std::max(0.6 * c, p.propeller.diameter_m * 0.6);
        p.contacts = {wheel("nose wheel", {1.4 * c, 0, under_m}, 330 * m, 10 * m),
                      wheel("left wheel", {-0.33 * c, -0.23 * half_m, under_m}, 580 * m, 13 * m),
                      wheel("right wheel", {-0.33 * c, 0.23 * half_m, under_m}, 580 * m, 13 * m)};
        p.contacts[0].steered = true;
    } else {
        p.launch = {1.15 * stallSpeed_mps(p), 30, 15, 0.3};
    }
    p.contacts.insert(p.contacts.end(),
                      {skid("nose", {2 * c, 0, 0.16 * c}, 1200 * m, 17 * m, d.thrown ? 5 : 2.5),
                       skid("belly", {0, 0, 0.43 * c}, 1200 * m, 17 * m, d.thrown ? 5 : 4),
                       skid("tail", {-tail_m, 0, d.thrown ? 0.2 * c : 0}, 660 * m, 9 * m, 3),
                       skid("left wing tip", {0, -half_m, -0.5 * c}, 420 * m, 7 * m, 3),
                       skid("right wing tip", {0, half_m, -0.5 * c}, 420 * m, 7 * m, 3),
                       skid("fin", {-tail_m, 0, -c}, 420 * m, 7 * m, 3)});
}

}  // namespace

// A propeller that stands at the thrust wanted with the pitch speed wanted, and a motor and a
// battery that turn it so at full throttle.
void givePropulsion(AirplaneParameters& p, const Design& d) {
    auto& prop = p.propeller;
    prop.thrust0 = 0.100, prop.thrust1 = -0.060, prop.thrust2 = -0.070;
    prop.torque0 = 0.0083, prop.torque1 = 0.0020, prop.torque2 = -0.0118;
    prop.slipstream = 0.3;
    constexpr double kNoThrust = 0.84;  // the advance ratio there
    const double cruise_mps = kCruiseToStall * stallSpeed_mps(p);
    const double tip_mps = d.pitch_speed_ratio * cruise_mps / kNoThrust;  // n D
    const double thrust_n = d.thrust_to_weight * d.mass_kg * kGravity_mss;
    prop.diameter_m = std::sqrt(thrust_n / (kSeaLevelDensity_kgm3 * prop.thrust0)) / tip_mps;
    prop.inertia_kgm2 = 0.045 * std::pow(prop.diameter_m, 5);

    auto& battery = p.battery;
    battery.cells = d.mass_kg < 0.9 ? 2 : d.mass_kg < 2.5 ? 3 : d.mass_kg < 5 ? 4 : 6;
    battery.avionics_a = 0.35;
    battery.full_v = 4.2, battery.knee_v = 3.6, battery.empty_v = 3.0, battery.knee_charge = 0.12;
    const double shaft_rads = 2 * M_PI * tip_mps / prop.diameter_m;
    const double torque_nm =
        kSeaLevelDensity_kgm3 * std::pow(prop.diameter_m, 3) * prop.torque0 * tip_mps * tip_mps;
    const double volts = battery.cells * 3.9;
    auto& motor = p.motor;
    motor.volts_per_rads = 0.78 * volts / shaft_rads;  // the rest falls in wires and windings
    const double current_a = torque_nm / motor.volts_per_rads;
    motor.resistance_ohm = 0.15 * volts / current_a;
    battery.resistance_ohm = 0.07 * volts / current_a;
    motor.idle_a = 0.03 * current_a;
    motor.throttle_exponent = 1;
    motor.lag_s = 0.04;
    constexpr double kFullThrottle_h = 0.2;
    battery.capacity_mah = std::round(current_a * kFullThrottle_h * 10) * 100;
}

double stallSpeed_mps(const AirplaneParameters& p) {
    double most = 0;
    for (double alpha = 0; alpha < 0.4; alpha += 0.002) most = std::max(most, polar(p, alpha).lift);
    return std::sqrt(2 * p.mass_kg * kGravity_mss / (kSeaLevelDensity_kgm3 * p.area_m2 * most));
}

double climbGradient(const AirplaneParameters& p, double airspeed_mps, double density_kgm3) {
    const double weight_n = p.mass_kg * kGravity_mss;
    const double pressure_n = 0.5 * density_kgm3 * airspeed_mps * airspeed_mps * p.area_m2;
    const double lift = weight_n / pressure_n;
    const double drag_n = pressure_n * (p.drag.parasite + p.drag.induced * lift * lift);
    // the shaft at full throttle, where the motor's torque is the propeller's
    double slow_rads = 0, fast_rads = 4.2 * p.battery.cells / p.motor.volts_per_rads;
    const auto& prop = p.propeller;
    const double d = prop.diameter_m;
    for (int i = 0; i < 60; ++i) {
        const double shaft_rads = (slow_rads + fast_rads) / 2, tip = shaft_rads / (2 * M_PI) * d;
        const double current_a = (3.8 * p.battery.cells - shaft_rads * p.motor.volts_per_rads) /
                                 (p.motor.resistance_ohm + p.battery.resistance_ohm);
        const double brake_nm = density_kgm3 * d * d * d *
                                (prop.torque0 * tip * tip + prop.torque1 * tip * airspeed_mps +
                                 prop.torque2 * airspeed_mps * airspeed_mps);
        const bool faster = (current_a - p.motor.idle_a) * p.motor.volts_per_rads > brake_nm;
        (faster ? slow_rads : fast_rads) = shaft_rads;
    }
    const double tip = slow_rads / (2 * M_PI) * d;
    const double thrust_n = density_kgm3 * d * d *
                            (prop.thrust0 * tip * tip + prop.thrust1 * tip * airspeed_mps +
                             prop.thrust2 * airspeed_mps * airspeed_mps);
    return (thrust_n - drag_n) / weight_n;
}

AirplaneParameters estimate(const Design& design) {
    AirplaneParameters airplane;
    giveShape(airplane, design);
    giveForces(airplane, design);
    giveMoments(airplane, design);
    giveControls(airplane);
    givePropulsion(airplane, design);
    giveGround(airplane, design);
    return airplane;
}

}  // namespace simulator::drawn

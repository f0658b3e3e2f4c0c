// SPDX-License-Identifier: GPL-3.0-or-later
// An airplane as data: simulator/airplanes/*.json, every value required but "launch", "elevons",
// "v_tail", "flaperons", "flaps", "imu_place_m" and "linkage", none unknown.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "simulator/airplane/vector.hpp"

namespace simulator {

struct Contact {
    std::string name;
    Vec3 place_m;  // body axes from the centre of gravity
    bool wheel = false;
    bool steered = false;  // turns with the rudder
    double stiffness_nm = 0, damping_nsm = 0;
    double rolling = 0, sliding = 0;  // friction along the wheel and across; equal for a skid
    double breaks_at_mps = 0;         // a faster touch is a crash
};

// Derivatives are per radian and dimensionless as in textbooks: rates by b/2V (roll, yaw) and c/2V.
// A positive aileron rolls right, a positive elevator pitches up, a positive rudder yaws right.
// Of elevons the aileron is half their difference and the elevator half their sum; of a V-tail the
// elevator is half the sum and the rudder half the difference, of flaperons aileron and flap.
struct AirplaneParameters {
    double mass_kg = 0;
    struct {
        double xx = 0, yy = 0, zz = 0, xz = 0;
    } inertia_kgm2;
    double area_m2 = 0, span_m = 0, chord_m = 0;
    struct {
        double at_zero = 0, alpha = 0, pitch_rate = 0, elevator = 0;
        double stall_alpha_rad = 0, stall_sharpness = 0;
    } lift;
    struct {
        double parasite = 0, induced = 0, beta2 = 0, plate = 0;
    } drag;
    struct {
        double beta = 0, roll_rate = 0, yaw_rate = 0, rudder = 0;
    } side;
    struct {
        double at_zero = 0, beta = 0, roll_rate = 0, yaw_rate = 0, aileron = 0, rudder = 0;
        double stall_loss = 0;  // of damping and aileron when wholly stalled
    } roll;
    struct {
        double at_zero = 0, alpha = 0, pitch_rate = 0, elevator = 0, stall = 0;
    } pitch;
    struct {
        double beta = 0, roll_rate = 0, yaw_rate = 0, aileron = 0, rudder = 0;
    } yaw;
    struct {
        double aileron_deg = 0, elevator_deg = 0, rudder_deg = 0, nose_wheel_deg = 0;
        double rate_per_s = 0, lag_s = 0;  // of a servo whose full travel is -1..1
    } controls;
    // What stands between a servo and what it was sent: it stays where it is while it is no farther
    // off than the deadband, and the surface moves by (1 - curve) x + curve x^3 of its travel x.
    struct {
        double deadband = 0, curve = 0;
    } linkage;
    Vec3 imu_place_m;        // body axes from the centre of gravity
    bool elevons = false;    // output 1 moves the right one, output 2 the left one; no rudder
    bool v_tail = false;     // outputs 2 and 4: both alike pitch up, a longer one of 4 yaws right
    bool flaperons = false;  // output 5 the left one, 6 the right one: a longer pulse is down
    struct {
        double lift = 0, drag = 0, pitch = 0;  // added when they are wholly out
    } flaps;
    struct {
        double diameter_m = 0, inertia_kgm2 = 0;
        double thrust0 = 0, thrust1 = 0, thrust2 = 0;  // CT = thrust0 + thrust1 J + thrust2 J^2
        double torque0 = 0, torque1 = 0, torque2 = 0;  // CQ likewise
        double slipstream = 0;  // share of the disc loading that blows over the tail
    } propeller;
    struct {
        double volts_per_rads = 0, resistance_ohm = 0, idle_a = 0;
        double throttle_exponent = 0;  // duty = throttle ^ exponent: the ESC's curve
        double lag_s = 0;
    } motor;
    struct {
        double cells = 0, capacity_mah = 0, resistance_ohm = 0, avionics_a = 0;
        double full_v = 0, knee_v = 0, empty_v = 0, knee_charge = 0;  // of a cell
    } battery;
    struct {
        double stiffness_nm = 0, damping_nsm = 0;  // along the ground, before a contact slips
    } grip;
    std::vector<Contact> contacts;
    // Thrown or shot from a ramp instead of rolling on wheels; speed 0: it has wheels.
    struct {
        double speed_mps = 0, acceleration_mss = 0, pitch_deg = 0, height_m = 0;
    } launch;
};

// `name` is a file in simulator/airplanes without its .json, or the path of a .json file.
// Throws AirplaneError with one line that names the file and what is wrong with it.
AirplaneParameters loadAirplane(const std::string& name);
std::string airplanePath(const std::string& name);
// The text of such a file; `about` is its first line.
std::string airplaneText(AirplaneParameters airplane, const std::string& about);

class AirplaneError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace simulator

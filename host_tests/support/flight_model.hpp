// SPDX-License-Identifier: GPL-3.0-or-later
// A light airplane for closed-loop tests: a point mass with lift, drag and thrust of a 1.2 kg
// foam trainer, attitude loops as lags, in a wind with first-order (Dryden-like) gusts.
#pragma once
#include <algorithm>
#include <cmath>
#include <random>

namespace flight_model {

struct Wind {
    double north_mps = 0, east_mps = 0;  // where it blows to
    double gust_mps = 0;                 // RMS of each component
    unsigned seed = 1;
};

class Airplane {
public:
    explicit Airplane(const Wind& wind = {}) : wind_(wind), noise_(wind.seed) {
        velocity_n += wind.north_mps;
        velocity_e += wind.east_mps;
    }

    // demands
    double roll_demand = 0, pitch_demand = 0, throttle = 0.45;
    // state, SI units, velocities over ground
    double north = 0, east = 0, height = 100;
    double velocity_n = 12, velocity_e = 0, climb = 0;
    double roll = 0, roll_rate = 0, pitch = 0.06, thrust = 0;
    // results of the last step
    double airspeed = 12, forward_mss = 0, alpha = 0;
    double wind_n = 0, wind_e = 0, wind_up = 0;  // gusts included

    void blow(double north_mps, double east_mps) {
        wind_.north_mps = north_mps;
        wind_.east_mps = east_mps;
    }

    void step(double dt) {
        gusts(dt);
        roll_rate += ((roll_demand - roll) / 0.5 - roll_rate) * dt / 0.08;
        roll += roll_rate * dt;
        pitch += (pitch_demand - pitch) * dt / 0.35;

        const double an = velocity_n - wind_n, ae = velocity_e - wind_e, au = climb - wind_up;
        const double horizontal = std::max(0.1, std::hypot(an, ae));
        airspeed = std::max(1.0, std::hypot(horizontal, au));
        const double path = std::atan2(au, horizontal);
        alpha = std::clamp((pitch - path) / std::max(0.5, std::cos(roll)), -0.2, 0.25);

        const double q_s = 0.5 * 1.225 * airspeed * airspeed * kArea;
        const double cl = 0.25 + 4.6 * alpha;
        const double lift = q_s * cl;
        const double drag = q_s * (0.035 + cl * cl / (kPi * 6.5 * 0.8));
        const double full = std::max(0.0, 14.0 - 0.5 * airspeed);  // N, a trainer's propeller
        thrust += (full * throttle * throttle - thrust) * dt / 0.25;

        // unit vectors: t along the air path, s to the right of it, u its upward normal
        const double cn = an / horizontal, ce = ae / horizontal;
        const double cg = horizontal / airspeed, sg = au / airspeed;
        const double along = thrust - drag, right = lift * std::sin(roll),
                     up = lift * std::cos(roll);
        const double accel_n = (along * cg * cn - right * ce - up * sg * cn) / kMass;
        const double accel_e = (along * cg * ce + right * cn - up * sg * ce) / kMass;
        const double accel_u = (along * sg + up * cg) / kMass - 9.80665;
        velocity_n += accel_n * dt;
        velocity_e += accel_e * dt;
        climb += accel_u * dt;
        north += velocity_n * dt;
        east += velocity_e * dt;
        height += climb * dt;
        forward_mss = along / kMass - 9.80665 * sg;  // what the accelerometer measures of it
    }

private:
    static constexpr double kPi = 3.14159265358979, kMass = 1.2, kArea = 0.28;

    void gusts(double dt) {
        std::normal_distribution<double> normal;
        const auto drift = [&](double& gust, double length_m) {
            const double rate = airspeed / length_m;
            gust += -gust * rate * dt + wind_.gust_mps * std::sqrt(2 * rate * dt) * normal(noise_);
        };
        drift(gust_n_, 150);
        drift(gust_e_, 150);
        drift(gust_up_, 60);
        wind_n = wind_.north_mps + gust_n_;
        wind_e = wind_.east_mps + gust_e_;
        wind_up = 0.7 * gust_up_;
    }

    Wind wind_;
    std::mt19937 noise_;
    double gust_n_ = 0, gust_e_ = 0, gust_up_ = 0;
};

}  // namespace flight_model

// SPDX-License-Identifier: GPL-3.0-or-later
// A flight worked out on paper and the sensors' view of it: coordinated turns up to 45 degrees of
// bank, climbs, changes of speed and gusts; every error of the sensors the project names. Truth
// and readings come 200 times a second.
#pragma once
#include <cmath>
#include <cstdint>
#include <deque>
#include <random>
#include <vector>

#include "core/maths.hpp"

namespace flight {

constexpr double kDt_s = 0.005;
constexpr double kGravity = 9.80665;
constexpr double kDegree = M_PI / 180;

struct V3 {
    double x = 0, y = 0, z = 0;
};
inline V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline V3 operator*(V3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline core::Vector3 single(V3 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// north, east, down -> body
inline V3 toBody(V3 v, double roll, double pitch, double yaw) {
    const double cy = cos(yaw), sy = sin(yaw), cp = cos(pitch), sp = sin(pitch), cr = cos(roll),
                 sr = sin(roll);
    const V3 a = {cy * v.x + sy * v.y, -sy * v.x + cy * v.y, v.z};
    const V3 b = {cp * a.x - sp * a.z, a.y, sp * a.x + cp * a.z};
    return {b.x, cr * b.y + sr * b.z, -sr * b.y + cr * b.z};
}

struct Truth {
    double time_s = 0, roll = 0, pitch = 0, yaw = 0;  // radians
    double airspeed = 0;                              // true
    V3 velocity, position, rate, force, wind;         // NED, NED, body, body, NED
};

// One thing to fly: bank, climb angle and speed are approached as an autopilot would.
struct Leg {
    double seconds, bank_deg, climb_deg, speed_mps;
};

struct Errors {
    double gyro_bias_dps = 0.6, gyro_noise_dps = 0.12, gyro_vibration_dps = 0.8;
    double accel_bias_g = 0.004, accel_noise_g = 0.006, accel_vibration_g = 0.08;
    double compass_noise_mg = 2, compass_offset_mg = 0;
    double gps_noise_mps = 0.05, gps_wander_m = 0.6, gps_wander_up_m = 1.5, gps_age_s = 0.243;
    double baro_noise_pa = 2, baro_drift_pa = 4;
    double airspeed_noise_mps = 0.15, airspeed_ratio = 0.02;
    double gust_mps = 1, wind_north_mps = 0, wind_east_mps = 0;
};

// A first-order Gauss-Markov process.
struct Wander {
    double sigma, time_s, value = 0;
    void start(std::mt19937& random) { value = sigma * std::normal_distribution<>()(random); }
    double step(double dt_s, std::mt19937& random) {
        const double share = exp(-dt_s / time_s);
        value =
            value * share + sigma * sqrt(1 - share * share) * std::normal_distribution<>()(random);
        return value;
    }
};

class Flight {
public:
    Flight(std::vector<Leg> legs, Errors errors, uint32_t seed, double heading_deg = 20)
        : legs_(std::move(legs)), errors_(errors), random_(seed) {
        truth_.yaw = heading_deg * kDegree;
        gyro_bias_ = gaussian3(errors.gyro_bias_dps * kDegree);
        accel_bias_ = gaussian3(errors.accel_bias_g * kGravity);
        compass_offset_ = gaussian3(errors.compass_offset_mg);
        airspeed_factor_ = sqrt(1 + errors.airspeed_ratio * gaussian());
        for (Wander* w : {&wander_north_, &wander_east_, &wander_up_, &drift_}) w->start(random_);
    }

    // False at the end of the last leg.
    bool step() {
        while (leg_ < legs_.size() && leg_time_s_ >= legs_[leg_].seconds) {
            leg_time_s_ = 0;
            ++leg_;
        }
        if (leg_ == legs_.size()) return false;
        leg_time_s_ += kDt_s;
        fly(legs_[leg_]);
        const Seen seen = {truth_.time_s, truth_.velocity, truth_.position};
        seen_.push_back(seen);
        if (seen_.size() > 400) seen_.pop_front();
        return true;
    }

    const Truth& truth() const { return truth_; }

    V3 gyro() {
        return truth_.rate + gyro_bias_ +
               gaussian3(noise(errors_.gyro_noise_dps, errors_.gyro_vibration_dps) * kDegree);
    }
    V3 accel() {
        return truth_.force + accel_bias_ +
               gaussian3(noise(errors_.accel_noise_g, errors_.accel_vibration_g) * kGravity);
    }
    V3 compass() {  // the field at 64 degrees of dip
        const V3 field = {210, 0, 430};
        return toBody(field, truth_.roll, truth_.pitch, truth_.yaw) + compass_offset_ +
               gaussian3(errors_.compass_noise_mg);
    }
    V3 compassOffset() const { return compass_offset_; }
    V3 gyroBias() const { return gyro_bias_; }

    struct Fix {
        V3 velocity, position;  // north, east, down
    };
    Fix gps() {  // to be asked five times a second
        size_t i = seen_.size() - 1;
        while (i > 0 && seen_[i].time_s > truth_.time_s - errors_.gps_age_s + 1e-6) --i;
        Fix fix = {seen_[i].velocity + gaussian3(errors_.gps_noise_mps), seen_[i].position};
        fix.position.x += wander_north_.step(0.2, random_);
        fix.position.y += wander_east_.step(0.2, random_);
        fix.position.z += wander_up_.step(0.2, random_);
        return fix;
    }
    double baroHeight_m() {  // to be asked every 12.5 ms
        constexpr double kMetresPerPascal = 1 / 12.0;
        return -truth_.position.z - kMetresPerPascal * (drift_.step(0.0125, random_) +
                                                        errors_.baro_noise_pa * gaussian());
    }
    double airspeed_mps() {
        return truth_.airspeed * airspeed_factor_ + errors_.airspeed_noise_mps * gaussian();
    }
    std::mt19937& random() { return random_; }

private:
    struct Seen {
        double time_s;
        V3 velocity, position;
    };

    double gaussian() { return normal_(random_); }
    V3 gaussian3(double sigma) {
        return {sigma * gaussian(), sigma * gaussian(), sigma * gaussian()};
    }
    double noise(double still, double full) const { return still + (full - still) * throttle_; }

    void fly(const Leg& leg) {
        const Truth old = truth_;
        Truth& t = truth_;
        t.time_s += kDt_s;
        const bool flying = leg.speed_mps > 0;
        throttle_ += ((flying ? 0.55 + leg.climb_deg / 20 : 0) - throttle_) * kDt_s / 0.5;
        throttle_ = core::limit(throttle_, 0.0, 1.0);
        approach(t.airspeed, leg.speed_mps, 3.0, 1.0);
        const double gust = flying && t.airspeed > 8 ? errors_.gust_mps : 0;
        for (int i = 0; i < 3; ++i) {
            gusts_[i].sigma = gust;
            gusts_[i].time_s = 50 / std::max(t.airspeed, 8.0);  // Dryden length over speed
            gusts_[i].step(kDt_s, random_);
        }
        // The air shakes the attitude; rates stay continuous through a second-order lag.
        bank_.step(leg.bank_deg * kDegree + 0.035 * gusts_[1].value, 4.0);
        climb_.step(leg.climb_deg * kDegree, 2.0);
        nod_.step(0.03 * gusts_[2].value, 4.0);
        slip_.step(0.03 * gusts_[1].value, 3.0);
        t.roll = bank_.value;
        const double lift =
            t.airspeed > 8 ? 0.05 * 144 / (t.airspeed * t.airspeed) / cos(t.roll) : 0;
        incidence_.step(lift + nod_.value, 4.0);
        t.pitch = climb_.value + incidence_.value;
        if (t.airspeed > 8) course_ += kGravity * tan(t.roll) / t.airspeed * kDt_s;
        t.yaw = heading0(old) + course_ + slip_.value;
        // Gusts carry the airplane along within about a second.
        for (int i = 0; i < 3; ++i) carried_[i].step(gusts_[i].value, 1.5);
        if (flying && t.airspeed > 8) {
            wind_share_ = std::min(1.0, wind_share_ + kDt_s / 8);
        }
        t.wind = {errors_.wind_north_mps * wind_share_ + carried_[0].value,
                  errors_.wind_east_mps * wind_share_ + carried_[1].value, 0.5 * carried_[2].value};
        const double path = start_yaw_ + course_;
        t.velocity =
            V3{t.airspeed * cos(climb_.value) * cos(path),
               t.airspeed * cos(climb_.value) * sin(path), -t.airspeed * sin(climb_.value)} +
            t.wind;
        t.position = old.position + (t.velocity + old.velocity) * (kDt_s / 2);
        const V3 acceleration = (t.velocity - old.velocity) * (1 / kDt_s);
        const double roll = (t.roll + old.roll) / 2, pitch = (t.pitch + old.pitch) / 2,
                     yaw = (t.yaw + old.yaw) / 2;
        t.force = toBody(acceleration - V3{0, 0, kGravity}, roll, pitch, yaw);
        const double roll_rate = (t.roll - old.roll) / kDt_s,
                     pitch_rate = (t.pitch - old.pitch) / kDt_s,
                     yaw_rate = (t.yaw - old.yaw) / kDt_s;
        t.rate = {roll_rate - yaw_rate * sin(pitch),
                  pitch_rate * cos(roll) + yaw_rate * sin(roll) * cos(pitch),
                  -pitch_rate * sin(roll) + yaw_rate * cos(roll) * cos(pitch)};
    }
    double heading0(const Truth& old) {
        if (!started_) start_yaw_ = old.yaw;
        started_ = true;
        return start_yaw_;
    }
    static void approach(double& value, double target, double rate, double time_s) {
        value += core::limit((target - value) / time_s, -rate, rate) * kDt_s;
    }
    struct SecondOrder {  // critically damped
        double value = 0, rate = 0;
        void step(double target, double omega) {
            rate += (omega * omega * (target - value) - 2 * omega * rate) * kDt_s;
            value += rate * kDt_s;
        }
    };

    std::vector<Leg> legs_;
    Errors errors_;
    std::mt19937 random_;
    std::normal_distribution<> normal_;
    Truth truth_;
    std::deque<Seen> seen_;
    size_t leg_ = 0;
    double leg_time_s_ = 0, throttle_ = 0, course_ = 0, start_yaw_ = 0, wind_share_ = 0;
    bool started_ = false;
    V3 gyro_bias_, accel_bias_, compass_offset_;
    double airspeed_factor_ = 1;
    SecondOrder bank_, climb_, nod_, slip_, incidence_, carried_[3];
    Wander gusts_[3] = {{1, 4}, {1, 4}, {1, 4}};
    Wander wander_north_{errors_.gps_wander_m, 60}, wander_east_{errors_.gps_wander_m, 60},
        wander_up_{errors_.gps_wander_up_m, 60}, drift_{errors_.baro_drift_pa, 300};
};

// Ten seconds on the ground, takeoff, a box with a climb, a descent and a change of speed, steep
// turns both ways, a loiter of two turns, slower, home.
inline std::vector<Leg> wholeFlight() {
    return {{12, 0, 0, 0},    {6, 0, 0, 14},   {20, 0, 10, 13}, {5, 35, 4, 13},    {40, 0, 0, 14},
            {5.2, 40, 0, 14}, {40, 0, 6, 13},  {4, 45, 0, 14},  {40, 0, 0, 16},    {5, -45, 0, 15},
            {30, 0, -5, 14},  {60, 28, 0, 13}, {25, 0, 0, 13},  {4.5, -40, 0, 13}, {40, 0, -4, 12},
            {5, 30, 0, 12},   {30, 0, 0, 13},  {9, 45, 0, 15},  {30, 0, 0, 14}};
}

}  // namespace flight

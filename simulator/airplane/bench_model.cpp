// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/bench_model.hpp"

#include <algorithm>

#include "simulator/airplane/airplane.hpp"
#include "simulator/constants.hpp"

namespace simulator {
namespace {

constexpr double kHandRate_rads = 1.5;
constexpr double kPack_v = 12.4;

}  // namespace

BenchModel::BenchModel(const WorldOptions& options)
    : attitude_(quaternion(0, 0, options.heading_deg * kRadians)),
      target_(attitude_),
      bench_altitude_m_(options.altitude_m) {
    truth_.latitude_deg = options.latitude_deg;
    truth_.longitude_deg = options.longitude_deg;
    truth_.altitude_m = options.altitude_m;
    truth_.battery_v = kPack_v;
    truth_.on_ground = true;
    publish({});
}

void BenchModel::turnTo(double roll_rad, double pitch_rad, double yaw_rad) {
    target_ = quaternion(roll_rad, pitch_rad, yaw_rad);
    turns_ = false;
}

void BenchModel::turn(double roll_rads, double pitch_rads, double yaw_rads) {
    turning_rads_ = {roll_rads, pitch_rads, yaw_rads};
    turns_ = true;
}

void BenchModel::lift(double height_m) {
    truth_.height_m = height_m;
    truth_.altitude_m = bench_altitude_m_ + height_m;
    truth_.on_ground = height_m <= 0;
}

void BenchModel::blow(double airspeed_mps) {
    truth_.airspeed_mps = truth_.equivalent_airspeed_mps = airspeed_mps;
}

// Body rates that bring it there in this step, or as fast as hands do.
Vec3 BenchModel::ratesToTarget() const {
    const Quaternion &a = attitude_, &b = target_;
    // the turn from the one to the other, in body axes
    double w = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
    Vec3 v = {a.w * b.x - a.x * b.w - a.y * b.z + a.z * b.y,
              a.w * b.y + a.x * b.z - a.y * b.w - a.z * b.x,
              a.w * b.z - a.x * b.y + a.y * b.x - a.z * b.w};
    if (w < 0) {
        w = -w;
        v = v * -1;
    }
    const double sine = length(v);
    if (sine < 1e-9) return {};
    const double rate = std::min(kHandRate_rads, 2 * std::atan2(sine, w) / Airplane::kStep_s);
    return v * (rate / sine);
}

void BenchModel::step(const ServoPulses&) {
    const Vec3 rates = turns_ ? turning_rads_ : ratesToTarget();
    attitude_ = normalized(attitude_ + turning(attitude_, rates) * Airplane::kStep_s);
    if (!turns_ && length(ratesToTarget()) < 1e-3) attitude_ = target_;
    truth_.time_us += Airplane::kStep_us;
    publish(rates);
}

void BenchModel::publish(const Vec3& rates) {
    const Rotation rotation(attitude_);
    const Vec3 force = rotation.toBody({0, 0, -kGravity_mss});
    truth_.roll_rad = rotation.roll_rad();
    truth_.pitch_rad = rotation.pitch_rad();
    truth_.yaw_rad = rotation.yaw_rad();
    truth_.roll_rate_rads = rates.x;
    truth_.pitch_rate_rads = rates.y;
    truth_.yaw_rate_rads = rates.z;
    truth_.force_x_mss = force.x;
    truth_.force_y_mss = force.y;
    truth_.force_z_mss = force.z;
}

}  // namespace simulator

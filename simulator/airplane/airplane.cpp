// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/airplane.hpp"

#include "simulator/airplane/earth.hpp"
#include "simulator/constants.hpp"

namespace simulator {
namespace {

constexpr int kSpinUpSteps = 800;
constexpr double kPulling = 0.5;
constexpr int kThrowAfterSteps = 400;
constexpr double kOnItsSide = 0.5;  // cosine of the steepest bank on the ground that is no crash

}  // namespace

Airplane::Airplane(const AirplaneParameters& parameters, const WorldOptions& options,
                   double gust_mps)
    : p_(parameters),
      options_(options),
      servos_(p_),
      propulsion_(p_),
      ground_(p_),
      dryden_(options.gusts ? gust_mps : 0, p_.span_m, options.seed),
      thermals_(options.thermal_mps, options.seed),
      standing_m_(ground_.standingHeight_m()) {
    motion_.position_m = {0, 0, -standing_m_};
    motion_.attitude = quaternion(0, 0, options.heading_deg * kRadians);
    density_kgm3_ = atmosphere(options.altitude_m).density_kgm3;
    ground_.advance(motion_, 0);
    settle();
    if (p_.launch.speed_mps > 0) standReady();
    moveAir();
    if (launch_ == Launch::gone) now_ = derivative(motion_, &specific_force_);
    publish();
}

// Lets the springs of the gear come to rest in still air.
void Airplane::settle() {
    constexpr int kSteps = 1200;
    now_ = derivative(motion_);
    for (int i = 0; i < kSteps; ++i) {
        integrate();
        now_ = derivative(motion_, &specific_force_);
    }
    standing_m_ = -motion_.position_m.z;
}

// In the thrower's hand or on the ramp.
void Airplane::standReady() {
    launch_ = Launch::ready;
    motion_ = {};
    motion_.position_m = {0, 0, -standing_m_ - p_.launch.height_m};
    motion_.attitude =
        quaternion(0, p_.launch.pitch_deg * kRadians, options_.heading_deg * kRadians);
    specific_force_ = Rotation(motion_.attitude).toBody({0, 0, -kGravity_mss});
}

void Airplane::launch() {
    if (launch_ == Launch::ready) launch_ = Launch::running;
}

// Along the airplane's own axis, held straight, until it is let go.
void Airplane::runUp(const Controls& demand) {
    pulling_steps_ = demand.throttle > kPulling ? pulling_steps_ + 1 : 0;
    if (pulling_steps_ >= kThrowAfterSteps) launch();
    if (launch_ != Launch::running) return;
    const Vec3 along = Rotation(motion_.attitude).toEarth({1, 0, 0});
    const Vec3 acceleration = along * p_.launch.acceleration_mss;
    motion_.position_m += motion_.velocity_mps * kStep_s + acceleration * (kStep_s * kStep_s / 2);
    motion_.velocity_mps += acceleration * kStep_s;
    specific_force_ = Rotation(motion_.attitude).toBody(acceleration - Vec3{0, 0, kGravity_mss});
    if (length(motion_.velocity_mps) >= p_.launch.speed_mps) launch_ = Launch::gone;
}

void Airplane::place(const Motion& motion, const Controls& controls) {
    launch_ = Launch::gone;
    motion_ = motion;
    moveAir();
    servos_.put(controls);
    controls_ = controls;
    const double ahead = flow(motion_, Rotation(motion_.attitude)).velocity_mps.x;
    for (int i = 0; i < kSpinUpSteps; ++i)
        propulsion_.advance(kStep_s, controls.throttle, ahead, density_kgm3_);
    ground_.advance(motion_, controls.rudder);
    now_ = derivative(motion_, &specific_force_);
    publish();
}

Flow Airplane::flow(const Motion& motion, const Rotation& rotation) const {
    Flow flow;
    flow.velocity_mps = rotation.toBody(motion.velocity_mps - air_mps_);
    flow.rates_rads = motion.rates_rads - air_rates_rads_;
    flow.density_kgm3 = density_kgm3_;
    flow.tail_pressure_pa =
        propulsion_.slipstream_pa(propulsion_.thrust_n(flow.velocity_mps.x, density_kgm3_));
    return flow;
}

Loads Airplane::loads(const Motion& motion, const Rotation& rotation) const {
    const Flow through = flow(motion, rotation);
    Loads sum = aerodynamics(p_, through, controls_);
    const double ahead = through.velocity_mps.x;
    sum.force_n.x += propulsion_.thrust_n(ahead, density_kgm3_);
    // The propeller turns clockwise seen from behind; the airframe turns the other way.
    sum.moment_nm.x -= propulsion_.torque_nm(ahead, density_kgm3_);
    const Loads ground = ground_.loads(motion, controls_.rudder);
    sum.force_n += ground.force_n;
    sum.moment_nm += ground.moment_nm;
    return sum;
}

Airplane::Derivative Airplane::derivative(const Motion& motion, Vec3* specific_force) const {
    const Rotation rotation(motion.attitude);
    const Loads on = loads(motion, rotation);
    const Vec3 specific = on.force_n * (1 / p_.mass_kg);
    if (specific_force) *specific_force = specific;
    const auto& i = p_.inertia_kgm2;
    const Vec3& w = motion.rates_rads;
    const Vec3 spin = {i.xx * w.x - i.xz * w.z, i.yy * w.y, i.zz * w.z - i.xz * w.x};
    const Vec3 m = on.moment_nm - cross(w, spin);
    const double determinant = i.xx * i.zz - i.xz * i.xz;
    Derivative out;
    out.velocity = motion.velocity_mps;
    out.acceleration = rotation.toEarth(specific) + Vec3{0, 0, kGravity_mss};
    out.angular = {(i.zz * m.x + i.xz * m.z) / determinant, m.y / i.yy,
                   (i.xz * m.x + i.xx * m.z) / determinant};
    out.turning = turning(motion.attitude, w);
    return out;
}

void Airplane::integrate() {
    const auto moved = [this](const Derivative& d, double dt) {
        return Motion{motion_.position_m + d.velocity * dt,
                      motion_.velocity_mps + d.acceleration * dt, motion_.attitude + d.turning * dt,
                      motion_.rates_rads + d.angular * dt};
    };
    const Derivative k2 = derivative(moved(now_, kStep_s / 2));
    const Derivative k3 = derivative(moved(k2, kStep_s / 2));
    const Derivative k4 = derivative(moved(k3, kStep_s));
    const Derivative mean = {
        (now_.velocity + (k2.velocity + k3.velocity) * 2 + k4.velocity) * (1 / 6.0),
        (now_.acceleration + (k2.acceleration + k3.acceleration) * 2 + k4.acceleration) * (1 / 6.0),
        (now_.angular + (k2.angular + k3.angular) * 2 + k4.angular) * (1 / 6.0),
        (now_.turning + (k2.turning + k3.turning) * 2 + k4.turning) * (1 / 6.0)};
    motion_ = moved(mean, kStep_s);
    motion_.attitude = normalized(motion_.attitude);
    ground_.advance(motion_, controls_.rudder);
}

void Airplane::moveAir() {
    const double height_m = -motion_.position_m.z;
    const double yaw = Rotation(motion_.attitude).yaw_rad(), c = std::cos(yaw), s = std::sin(yaw);
    const Gust& gust = dryden_.advance(kStep_s, truth_.airspeed_mps, height_m);
    const Vec3& g = gust.velocity_mps;
    air_mps_ = meanWind_mps(wind_mps_, wind_from_deg_, height_m) +
               Vec3{c * g.x - s * g.y, s * g.x + c * g.y,
                    g.z - thermals_.rise_mps(motion_.position_m.x, motion_.position_m.y, height_m)};
    air_rates_rads_ = gust.rates_rads;
    density_kgm3_ = atmosphere(options_.altitude_m + height_m - standing_m_).density_kgm3;
}

void Airplane::step(const Controls& demand) {
    const bool flies = launch_ == Launch::gone;
    if (flies) integrate();
    if (!flies) runUp(demand);
    ++steps_;
    moveAir();
    servos_.advance(kStep_s, demand);
    const double ahead = flow(motion_, Rotation(motion_.attitude)).velocity_mps.x;
    propulsion_.advance(kStep_s, truth_.crashed ? 0 : demand.throttle, ahead, density_kgm3_);
    controls_ = servos_.at();
    controls_.throttle = propulsion_.throttle();
    if (launch_ == Launch::gone) now_ = derivative(motion_, flies ? &specific_force_ : nullptr);
    publish();
}

void Airplane::publish() {
    const Rotation rotation(motion_.attitude);
    const Flow through = flow(motion_, rotation);
    Truth& t = truth_;
    t.time_us = steps_ * kStep_us;
    t.north_m = motion_.position_m.x;
    t.east_m = motion_.position_m.y;
    t.height_m = -motion_.position_m.z - standing_m_;
    t.altitude_m = options_.altitude_m + t.height_m;
    const Place place =
        moved({options_.latitude_deg, options_.longitude_deg}, t.altitude_m, t.north_m, t.east_m);
    t.latitude_deg = place.latitude_deg;
    t.longitude_deg = place.longitude_deg;
    t.velocity_north_mps = motion_.velocity_mps.x;
    t.velocity_east_mps = motion_.velocity_mps.y;
    t.velocity_down_mps = motion_.velocity_mps.z;
    t.roll_rad = rotation.roll_rad();
    t.pitch_rad = rotation.pitch_rad();
    t.yaw_rad = rotation.yaw_rad();
    t.roll_rate_rads = motion_.rates_rads.x;
    t.pitch_rate_rads = motion_.rates_rads.y;
    t.yaw_rate_rads = motion_.rates_rads.z;
    const Vec3 turned = cross(motion_.rates_rads, cross(motion_.rates_rads, p_.imu_place_m)) +
                        cross(now_.angular, p_.imu_place_m);
    const Vec3 sensed = specific_force_ + (launch_ == Launch::gone ? turned : Vec3{});
    t.force_x_mss = sensed.x;
    t.force_y_mss = sensed.y;
    t.force_z_mss = sensed.z;
    t.airspeed_mps = through.speed_mps();
    t.equivalent_airspeed_mps = t.airspeed_mps * std::sqrt(density_kgm3_ / kSeaLevelDensity_kgm3);
    t.alpha_rad = through.alpha_rad();
    t.beta_rad = through.beta_rad();
    t.wind_north_mps = air_mps_.x;
    t.wind_east_mps = air_mps_.y;
    t.wind_down_mps = air_mps_.z;
    t.throttle = controls_.throttle;
    t.aileron = controls_.aileron;
    t.elevator = controls_.elevator;
    t.rudder = controls_.rudder;
    t.motor_current_a = propulsion_.battery_a();
    t.battery_v = propulsion_.battery_v();
    t.battery_used_mah = propulsion_.used_mah();
    t.on_ground = ground_.touching() || launch_ != Launch::gone;
    const bool tipped = t.on_ground && rotation.toEarth({0, 0, 1}).z < kOnItsSide;
    t.crashed = t.crashed || ground_.broken() || tipped;
}

}  // namespace simulator

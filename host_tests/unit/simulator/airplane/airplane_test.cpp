// SPDX-License-Identifier: GPL-3.0-or-later
// The rigid body: laws of mechanics that hold whatever the airplane is.
#include "simulator/airplane/airplane.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "flying.hpp"

using namespace simulator;

namespace {

const AirplaneParameters kTrainer = loadAirplane("foam_trainer");

AirplaneParameters inVacuum() {
    AirplaneParameters p = kTrainer;
    p.area_m2 = 0;
    p.propeller.thrust0 = p.propeller.thrust1 = p.propeller.thrust2 = 0;
    return symmetric(p);
}

Vec3 angularMomentum(const AirplaneParameters& p, const Truth& t) {
    const auto& i = p.inertia_kgm2;
    const Vec3 body = {i.xx * t.roll_rate_rads - i.xz * t.yaw_rate_rads, i.yy * t.pitch_rate_rads,
                       i.zz * t.yaw_rate_rads - i.xz * t.roll_rate_rads};
    return Rotation(quaternion(t.roll_rad, t.pitch_rad, t.yaw_rad)).toEarth(body);
}

double energy_j(const AirplaneParameters& p, const Truth& t) {
    const double speed2 = t.velocity_north_mps * t.velocity_north_mps +
                          t.velocity_east_mps * t.velocity_east_mps +
                          t.velocity_down_mps * t.velocity_down_mps;
    return p.mass_kg * (0.5 * speed2 + kGravity_mss * t.height_m);
}

Controls wild(const Truth& t) {
    const double s = seconds(t);
    Controls out;
    out.aileron = 0.6 * std::sin(3 * s);
    out.elevator = 0.3 * std::sin(5 * s + 1);
    out.rudder = 0.5 * std::sin(2 * s);
    out.throttle = 0.5 + 0.4 * std::sin(s);
    return out;
}

}  // namespace

TEST(RigidBody, falls_freely_with_zero_specific_force_in_vacuum) {
    Airplane airplane(inVacuum(), stillAir(), 0);
    airplane.place(levelFlight(20, 0, 500), {});
    fly(airplane, 2, [](const Truth&) { return Controls{}; });
    const Truth& t = airplane.truth();
    EXPECT_NEAR(t.height_m - (airplane.truth().altitude_m), 0, 1e-9);
    EXPECT_NEAR(t.north_m, 40, 1e-9);
    EXPECT_NEAR(t.velocity_down_mps, 2 * kGravity_mss, 1e-9);
    EXPECT_NEAR(t.force_x_mss, 0, 1e-12);
    EXPECT_NEAR(t.force_z_mss, 0, 1e-12);
}

TEST(RigidBody, keeps_its_angular_momentum_tumbling_in_vacuum) {
    const AirplaneParameters p = inVacuum();
    Airplane airplane(p, stillAir(), 0);
    Motion motion = levelFlight(0, 0.3, 2000);
    motion.rates_rads = {3, 5, 2};
    airplane.place(motion, {});
    const Vec3 before = angularMomentum(p, airplane.truth());
    fly(airplane, 10, [](const Truth&) { return Controls{}; });
    EXPECT_NEAR(length(angularMomentum(p, airplane.truth()) - before) / length(before), 0, 1e-4);
}

// The largest difference over ten seconds of wild flying between the change of velocity less
// gravity and the specific force reported at both ends of the step.
double worstForceError_mss(const WorldOptions& options, double& largest_mss) {
    Airplane airplane(kTrainer, options, 1);
    const Trim trim = trimmed(kTrainer, 13);
    airplane.place(levelFlight(13, trim.alpha_rad, 300), trim.controls);
    const auto specific = [](const Truth& t) {
        return Rotation(quaternion(t.roll_rad, t.pitch_rad, t.yaw_rad))
            .toEarth({t.force_x_mss, t.force_y_mss, t.force_z_mss});
    };
    Truth last = airplane.truth();
    double worst_mss = 0;
    fly(airplane, 10, wild, [&](const Truth& now) {
        const Vec3 mean = (specific(last) + specific(now)) * 0.5;
        const Vec3 change = Vec3{now.velocity_north_mps - last.velocity_north_mps,
                                 now.velocity_east_mps - last.velocity_east_mps,
                                 now.velocity_down_mps - last.velocity_down_mps} *
                            (1 / Airplane::kStep_s);
        worst_mss = std::max(worst_mss, length(change - Vec3{0, 0, kGravity_mss} - mean));
        largest_mss = std::max(largest_mss, length(mean));
        last = now;
    });
    return worst_mss;
}

TEST(RigidBody, has_a_specific_force_that_is_the_change_of_velocity_less_gravity) {
    double largest_mss = 0;
    EXPECT_LT(worstForceError_mss(stillAir(), largest_mss), 0.1);
    EXPECT_GT(largest_mss, 15) << "it really manoeuvred";
    // Gusts come in between two steps, so that half of a gust's jump is allowed.
    WorldOptions options = stillAir();
    options.gusts = true;
    options.wind_mps = 5;
    EXPECT_LT(worstForceError_mss(options, largest_mss), 0.7);
}

TEST(RigidBody, moves_as_its_velocity_says) {
    Airplane airplane(kTrainer, stillAir(), 0);
    const Trim trim = trimmed(kTrainer, 13);
    airplane.place(levelFlight(13, trim.alpha_rad, 300), trim.controls);
    Vec3 way, from{airplane.truth().north_m, airplane.truth().east_m, 0};
    Truth last = airplane.truth();
    fly(airplane, 10, wild, [&](const Truth& t) {
        way += Vec3{t.velocity_north_mps + last.velocity_north_mps,
                    t.velocity_east_mps + last.velocity_east_mps, 0} *
               (Airplane::kStep_s / 2);
        last = t;
    });
    EXPECT_NEAR(length(Vec3{last.north_m, last.east_m, 0} - from - way), 0, 1e-3);
}

TEST(RigidBody, turns_as_its_rates_say) {
    Airplane airplane(kTrainer, stillAir(), 0);
    const Trim trim = trimmed(kTrainer, 13);
    airplane.place(levelFlight(13, trim.alpha_rad, 300), trim.controls);
    Quaternion q = quaternion(0, trim.alpha_rad, 0);
    Truth last = airplane.truth();
    fly(airplane, 5, wild, [&](const Truth& t) {
        const Vec3 mean =
            Vec3{t.roll_rate_rads + last.roll_rate_rads, t.pitch_rate_rads + last.pitch_rate_rads,
                 t.yaw_rate_rads + last.yaw_rate_rads} *
            0.5;
        q = normalized(q + turning(q, mean) * Airplane::kStep_s);
        last = t;
    });
    EXPECT_NEAR(Rotation(q).pitch_rad(), last.pitch_rad, 2e-3);
    EXPECT_NEAR(Rotation(q).yaw_rad(), last.yaw_rad, 2e-3);
}

TEST(RigidBody, only_loses_energy_without_thrust_in_still_air) {
    AirplaneParameters p = kTrainer;
    p.propeller.thrust0 = p.propeller.thrust1 = p.propeller.thrust2 = 0;
    Airplane airplane(p, stillAir(), 0);
    airplane.place(levelFlight(15, 0.03, 300), {});
    double last_j = energy_j(p, airplane.truth());
    const double first_j = last_j;
    fly(
        airplane, 20, [](const Truth&) { return Controls{}; },
        [&](const Truth& t) {
            EXPECT_LT(energy_j(p, t), last_j);
            last_j = energy_j(p, t);
        });
    // By drag alone: about weight / (lift / drag) for every metre flown.
    EXPECT_GT(first_j - last_j, 200);
    EXPECT_LT(first_j - last_j, 500);
}

TEST(Airplane, flies_the_same_bits_for_the_same_seed) {
    WorldOptions options = stillAir();
    options.gusts = true;
    options.wind_mps = 5;
    const auto flown = [&options] {
        Airplane airplane(kTrainer, options, 1);
        airplane.place(levelFlight(13, 0.04, 300), {});
        fly(airplane, 20, wild);
        return airplane.truth();
    };
    const Truth first = flown(), second = flown();
    EXPECT_EQ(std::memcmp(&first, &second, offsetof(Truth, on_ground)), 0);
    options.seed = 2;
    EXPECT_NE(flown().north_m, first.north_m);
}

// f + w x (w x r) + dw/dt x r, with dw/dt from the rates before and after.
TEST(RigidBody, turns_an_inertial_sensor_that_is_not_at_its_centre) {
    AirplaneParameters p = inVacuum();
    Airplane centred(p, stillAir(), 0);
    p.imu_place_m = {0.08, -0.03, 0.05};
    Airplane offset(p, stillAir(), 0);
    Motion spinning = levelFlight(20, 0, 500);
    spinning.rates_rads = {1.5, -2, 3};
    for (Airplane* each : {&centred, &offset}) each->place(spinning, {});
    Vec3 before = spinning.rates_rads;
    for (int i = 0; i < 100; ++i) {
        const Truth now = centred.truth();
        const Vec3 rates = {now.roll_rate_rads, now.pitch_rate_rads, now.yaw_rate_rads};
        centred.step({});
        const Truth& next = centred.truth();
        const Vec3 after = {next.roll_rate_rads, next.pitch_rate_rads, next.yaw_rate_rads};
        if (i > 0) {
            const Vec3 angular = (after - before) * (1 / (2 * Airplane::kStep_s));
            const Vec3 expected =
                cross(rates, cross(rates, p.imu_place_m)) + cross(angular, p.imu_place_m);
            const Truth& seen = offset.truth();
            EXPECT_NEAR(seen.force_x_mss - now.force_x_mss, expected.x, 0.01);
            EXPECT_NEAR(seen.force_y_mss - now.force_y_mss, expected.y, 0.01);
            EXPECT_NEAR(seen.force_z_mss - now.force_z_mss, expected.z, 0.01);
        }
        offset.step({});
        before = rates;
    }
}

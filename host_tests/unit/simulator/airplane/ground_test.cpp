// SPDX-License-Identifier: GPL-3.0-or-later
// The trainer on, off and back on the ground.
#include "simulator/airplane/ground.hpp"

#include <gtest/gtest.h>

#include "flying.hpp"

using namespace simulator;

namespace {

const AirplaneParameters kTrainer = loadAirplane("foam_trainer");

Controls idle(const Truth&) { return {}; }

}  // namespace

TEST(Ground, carries_the_airplane_at_rest) {
    Airplane airplane(kTrainer, stillAir(), 0);
    fly(airplane, 5, idle);
    const Truth& t = airplane.truth();
    EXPECT_TRUE(t.on_ground);
    EXPECT_FALSE(t.crashed);
    EXPECT_NEAR(t.height_m, 0, 1e-3);
    EXPECT_NEAR(t.force_z_mss, -kGravity_mss, 0.01);
    EXPECT_NEAR(t.roll_rad, 0, 1e-3);
    EXPECT_NEAR(t.pitch_rad, 0, 0.02);
    EXPECT_NEAR(t.pitch_rate_rads, 0, 1e-4);
}

TEST(Ground, holds_it_in_place_in_wind_and_gusts) {
    WorldOptions options = stillAir();
    options.wind_mps = 5;
    options.gusts = true;
    for (double from : {0.0, 60.0, 90.0, 180.0}) {
        options.wind_from_deg = from;
        Airplane airplane(kTrainer, options, 1);
        fly(airplane, 60, idle);
        const Truth& t = airplane.truth();
        EXPECT_NEAR(std::hypot(t.north_m, t.east_m), 0, 0.02) << from;
        EXPECT_NEAR(t.yaw_rad, 0, 0.02) << from;
    }
}

TEST(Ground, lets_it_stand_at_the_heading_asked_for) {
    WorldOptions options = stillAir();
    options.heading_deg = 135;
    Airplane airplane(kTrainer, options, 0);
    fly(airplane, 1, idle);
    EXPECT_NEAR(airplane.truth().yaw_rad * 180 / M_PI, 135, 0.1);
}

TEST(Takeoff, needs_less_than_thirty_metres) {
    WorldOptions options = stillAir();
    options.altitude_m = 488;
    Airplane airplane(kTrainer, options, 0);
    double lifted_m = 0;
    fly(
        airplane, 10, [](const Truth& t) { return holdAttitude(t, 0.2, 1); },
        [&](const Truth& t) {
            if (lifted_m == 0 && t.height_m > 0.3) lifted_m = t.north_m;
        });
    EXPECT_GT(lifted_m, 3);
    EXPECT_LT(lifted_m, 30);
    EXPECT_GT(airplane.truth().height_m, 10);
    EXPECT_FALSE(airplane.truth().crashed);
}

TEST(Takeoff, steers_by_the_nose_wheel) {
    Airplane airplane(kTrainer, stillAir(), 0);
    fly(airplane, 3, [](const Truth&) { return Controls{0, 0, 0.5, 0.25}; });
    EXPECT_GT(airplane.truth().yaw_rad, 0.3);
    EXPECT_FALSE(airplane.truth().crashed);
}

TEST(Landing, ends_standing_upright) {
    Airplane airplane(kTrainer, stillAir(), 0);
    airplane.place(levelFlight(11, 0.05, 12), {});
    double sink_mps = 0;
    fly(
        airplane, 30,
        [](const Truth& t) {
            const double pitch = t.height_m > 1.2 ? -0.06 : 0.08;
            return holdAttitude(t, pitch, t.height_m > 1.2 ? 0.2 : 0);
        },
        [&](const Truth& t) {
            if (sink_mps == 0 && t.on_ground) sink_mps = t.velocity_down_mps;
        });
    const Truth& t = airplane.truth();
    EXPECT_GT(sink_mps, 0.05);
    EXPECT_FALSE(t.crashed);
    EXPECT_TRUE(t.on_ground);
    EXPECT_NEAR(t.velocity_north_mps, 0, 0.01);
    EXPECT_NEAR(t.roll_rad, 0, 0.01);
    EXPECT_LT(t.north_m, 200);
}

TEST(Landing, rolls_out_by_friction) {
    Airplane airplane(kTrainer, stillAir(), 0);
    Motion motion = levelFlight(5, 0, 0);
    motion.position_m.z = -Ground(kTrainer).standingHeight_m();
    airplane.place(motion, {});
    fly(airplane, 20, idle);
    EXPECT_NEAR(airplane.truth().velocity_north_mps, 0, 1e-3);
    // Friction and air together stop it shorter than rolling friction alone, v^2 / (2 mu g).
    EXPECT_LT(airplane.truth().north_m, 25 / (2 * 0.06 * kGravity_mss));
    EXPECT_GT(airplane.truth().north_m, 8);
}

TEST(Crash, differs_from_a_landing_and_stops_the_motor) {
    Airplane airplane(kTrainer, stillAir(), 0);
    Motion motion = levelFlight(14, -0.9, 15);
    motion.velocity_mps = {8, 0, 11};
    airplane.place(motion, {});
    fly(airplane, 5, [](const Truth&) { return Controls{0, -0.3, 0, 0.8}; });
    EXPECT_TRUE(airplane.truth().crashed);
    EXPECT_NEAR(airplane.truth().throttle, 0, 0.01);
    EXPECT_TRUE(std::isfinite(airplane.truth().north_m));
}

TEST(Crash, is_also_to_lie_on_the_side) {
    Airplane airplane(kTrainer, stillAir(), 0);
    Motion motion = levelFlight(1, 0, 0.75);
    motion.attitude = quaternion(1.4, 0, 0);
    airplane.place(motion, {});
    fly(airplane, 2, idle);
    EXPECT_TRUE(airplane.truth().crashed);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace simulator;

namespace {

// Two legs to the north of 1,112 m each at 60 m, a circle, a landing.
const Plan kPlan = makePlan(parseWaypoints("QGC WPL 110\n0 1 0 16 0 0 0 0 0 8 0 1\n"
                                           "1 0 3 16 0 0 0 0 0.01 8 60 1\n"
                                           "2 0 3 16 0 0 0 0 0.02 8 60 1\n"
                                           "3 0 3 18 2 0 0 0 0.03 8 60 1\n"
                                           "4 0 3 16 0 0 0 0 0.04 8 60 1\n"
                                           "5 0 3 21 0 0 0 0 0.05 8 0 1\n",
                                           "plan"),
                            LocalFrame(0, 8));

Truth at(double height_m, double airspeed_mps = 12) {
    Truth truth{};
    truth.height_m = height_m;
    truth.equivalent_airspeed_mps = airspeed_mps;
    return truth;
}

}  // namespace

TEST(Metrics, know_nothing_of_a_flight_that_was_none) {
    const Metrics metrics(kPlan, 12);

    EXPECT_FALSE(metrics.crosstrack.rms());
    EXPECT_FALSE(metrics.altitude.rms());
}

TEST(Metrics, count_a_leg_from_five_seconds_after_it_began) {
    Metrics metrics(kPlan, 12);
    metrics.sample(10, at(60), {1100, 0}, 1);
    metrics.sample(20, at(60), {1120, 30}, 2);
    metrics.sample(24.9, at(60), {1180, 20}, 2);
    EXPECT_FALSE(metrics.crosstrack.rms());

    metrics.sample(25, at(60), {1190, 4}, 2);
    metrics.sample(26, at(60), {1200, -3}, 2);

    EXPECT_NEAR(*metrics.crosstrack.rms(), std::sqrt(12.5), 1e-6);
    EXPECT_NEAR(*metrics.crosstrack.max(), 4, 1e-6);
}

TEST(Metrics, give_a_leg_that_leaves_a_circle_longer) {
    Metrics metrics(kPlan, 12);
    metrics.sample(100, at(60), {3300, 60}, 3);
    metrics.sample(200, at(60), {3300, 60}, 4);
    metrics.sample(214, at(60), {3350, 30}, 4);
    EXPECT_FALSE(metrics.crosstrack.rms());

    metrics.sample(215, at(60), {3360, 2}, 4);

    EXPECT_NEAR(*metrics.crosstrack.rms(), 2, 1e-6);
}

TEST(Metrics, leave_the_flare_out) {
    Metrics metrics(kPlan, 12);
    metrics.sample(0, at(60), {4448, 0}, 5);
    metrics.sample(10, at(20), {4600, 1}, 5);
    metrics.sample(30, at(4.9), {5000, 9}, 5);

    EXPECT_NEAR(*metrics.crosstrack.max(), 1, 1e-6);
}

TEST(Metrics, judge_height_and_speed_in_cruise_only) {
    Metrics metrics(kPlan, 12);
    metrics.sample(0, at(60), {1100, 0}, 2);
    metrics.sample(10, at(62, 13), {1200, 0}, 2);
    metrics.sample(20, at(40, 20), {4448, 0}, 5);
    metrics.sample(40, at(30, 20), {4600, 0}, 5);

    EXPECT_NEAR(*metrics.altitude.rms(), 2, 1e-6);
    EXPECT_NEAR(*metrics.airspeed.rms(), 1, 1e-6);
}

TEST(Metrics, do_not_judge_a_speed_nobody_demanded) {
    Metrics metrics(kPlan, std::nullopt);
    metrics.sample(0, at(60), {1100, 0}, 2);
    metrics.sample(10, at(60), {1200, 0}, 2);

    EXPECT_FALSE(metrics.airspeed.rms());
}

TEST(Metrics, count_nothing_on_the_ground) {
    Metrics metrics(kPlan, 12);
    Truth truth = at(0);
    truth.on_ground = true;
    metrics.sample(0, truth, {0, 0}, 1);
    metrics.sample(100, truth, {0, 50}, 1);

    EXPECT_FALSE(metrics.crosstrack.rms());
}

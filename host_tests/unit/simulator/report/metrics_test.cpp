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

// The first leg climbs, the second is level; then a circle of 80 m.
const Plan kSlopes = makePlan(parseWaypoints("QGC WPL 110\n0 1 0 16 0 0 0 0 0 8 0 1\n"
                                             "1 0 3 16 0 0 0 0 0.01 8 60 1\n"
                                             "2 0 3 16 0 0 0 0 0.02 8 80 1\n"
                                             "3 0 3 16 0 0 0 0 0.03 8 80 1\n"
                                             "4 0 3 18 2 0 -80 0 0.04 8 80 1\n",
                                             "slopes"),
                              LocalFrame(0, 8));

Truth at(double height_m, double airspeed_mps = 12) {
    Truth truth{};
    truth.height_m = height_m;
    truth.equivalent_airspeed_mps = airspeed_mps;
    return truth;
}

}  // namespace

TEST(Metrics, are_empty_without_a_flight) {
    const Metrics metrics(kPlan, 12);

    EXPECT_FALSE(metrics.crosstrack.rms());
    EXPECT_FALSE(metrics.altitude.rms());
}

TEST(Metrics, measure_heights_from_where_the_airplane_was_armed) {
    Metrics metrics(kPlan, 12);
    metrics.setHomeHeight(0.3);
    metrics.sample(10, at(60), {1100, 0}, 1);
    metrics.sample(20, at(60), {1120, 0}, 2);
    metrics.sample(25, at(60.5), {1190, 0}, 2);
    metrics.sample(60, at(60), {2230, 0}, 3);
    metrics.sample(75, at(60.1), {3250, 0}, 3);

    EXPECT_NEAR(*metrics.altitude.rms(), 0.2, 1e-6);
    EXPECT_NEAR(*metrics.altitude.max(), 0.2, 1e-6);
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

TEST(Metrics, count_height_and_speed_in_cruise_only) {
    Metrics metrics(kPlan, 12);
    metrics.sample(0, at(60), {1100, 0}, 2);
    metrics.sample(10, at(62, 13), {1200, 0}, 2);
    metrics.sample(20, at(40, 20), {4448, 0}, 5);
    metrics.sample(40, at(30, 20), {4600, 0}, 5);

    EXPECT_NEAR(*metrics.altitude.rms(), 2, 1e-6);
    EXPECT_NEAR(*metrics.airspeed.rms(), 1, 1e-6);
}

TEST(Metrics, find_the_slowest_moment_of_a_flight_but_not_of_its_flare) {
    Metrics metrics(kPlan, 12);
    EXPECT_FALSE(metrics.slowest_mps);
    metrics.sample(0, at(60, 8), {0, 0}, 0);  // by hand
    EXPECT_FALSE(metrics.slowest_mps);
    metrics.sample(1, at(60, 11), {1100, 0}, 2);
    metrics.sample(2, at(60, 9.5), {1110, 0}, 2);  // in the turn, where nothing else counts
    metrics.sample(10, at(60, 12), {1200, 0}, 2);
    metrics.sample(30, at(4.9, 8), {5000, 0}, 5);

    EXPECT_EQ(metrics.slowest_mps, 9.5);
}

TEST(Metrics, do_not_count_speed_errors_without_a_demand) {
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

TEST(Metrics, count_a_settled_leg_five_seconds_later) {
    Metrics metrics(kPlan, 12);
    metrics.sample(20, at(60), {1120, 30}, 2);
    metrics.sample(25, at(60), {1190, 4}, 2);
    metrics.sample(29.9, at(60), {1250, 3}, 2);
    EXPECT_FALSE(metrics.settled.rms());

    metrics.sample(30, at(60), {1260, 1}, 2);

    EXPECT_NEAR(*metrics.settled.max(), 1, 1e-6);
    EXPECT_NEAR(*metrics.crosstrack.max(), 4, 1e-6);
}

TEST(Metrics, count_slopes_apart_from_level_legs) {
    const Plan& plan = kSlopes;
    Metrics metrics(plan, 12);
    const double half_m = (plan.navs[0].place->north_m + plan.navs[1].place->north_m) / 2;
    metrics.sample(0, at(60), {1110, 0}, 2);
    metrics.sample(50, at(73), {half_m, 0}, 2);
    EXPECT_FALSE(metrics.level.rms());
    metrics.sample(100, at(80), {2230, 0}, 3);
    metrics.sample(110, at(79), {2300, 0}, 3);

    EXPECT_NEAR(*metrics.sloped.max(), 3, 1e-6);
    EXPECT_NEAR(*metrics.level.max(), 1, 1e-6);
    EXPECT_NEAR(*metrics.altitude.max(), 3, 1e-6);
}

TEST(Metrics, measure_a_circle_by_its_radius_once_it_is_flown) {
    Metrics metrics(kSlopes, 12);
    const double centre_m = kSlopes.navs[3].place->north_m;
    metrics.sample(0, at(80), {centre_m - 500, 0}, 4);
    metrics.sample(60, at(80), {centre_m - 87, 0}, 4);
    metrics.sample(64.9, at(80), {centre_m, 90}, 4);
    EXPECT_FALSE(metrics.radius.rms());

    metrics.sample(65, at(80), {centre_m, 82}, 4);

    EXPECT_NEAR(*metrics.radius.rms(), 2, 1e-6);
}

TEST(Metrics, ask_the_autopilot_for_the_radius_of_a_circle_that_names_none) {
    Metrics metrics(kPlan, 12);
    const double centre_m = kPlan.navs[2].place->north_m;
    const auto circle = [&](double from_s) {
        metrics.sample(from_s, at(60), {centre_m + 61, 0}, 3);
        metrics.sample(from_s + 10, at(60), {centre_m + 61, 0}, 3);
    };
    circle(0);
    EXPECT_FALSE(metrics.radius.rms());

    metrics.setLoiterRadius(-60);
    circle(20);

    EXPECT_NEAR(*metrics.radius.rms(), 1, 1e-6);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/barometer_drift.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "flight.hpp"

namespace {

using estimation::BarometerDrift;

constexpr float kFix_s = 0.2f;

// A barometer's zero that rises as given.
struct Zero {
    BarometerDrift drift;
    double height_m = 0;

    explicit Zero(double at_m) { drift.useGps(static_cast<float>(at_m), 0, 10); }
    void fix(double reported_m, double receiver_mps, float after_s = kFix_s) {
        height_m +=
            drift.useGps(static_cast<float>(reported_m), static_cast<float>(receiver_mps), after_s);
    }
    template <class Reported>
    void fly(double for_s, Reported reported_m, double receiver_mps) {
        for (double t = kFix_s; t < for_s; t += kFix_s) fix(reported_m(t), receiver_mps);
    }
};
double level(double) { return 100; }
double risen(double t) { return 100 + t / 30; }

TEST(BarometerDrift, two_fifths_of_the_height_change_the_velocity_does_not_explain_are_drift) {
    Zero zero(100);
    zero.fly(30, risen, 0);

    EXPECT_NEAR(zero.height_m, 0.4, 0.03);
}

TEST(BarometerDrift, a_climb_is_not_taken_for_drift) {
    Zero zero(0);
    zero.fly(
        60, [](double t) { return 2.5 * t; }, 2.5);

    EXPECT_NEAR(zero.height_m, 0, 0.01);
}

TEST(BarometerDrift, a_climb_shows_how_many_metres_a_metre_of_pressure_is) {
    for (const double share : {0.93, 1.05}) {  // the air 20 degrees warmer, 14 degrees colder
        Zero zero(0);
        std::mt19937 random(1);
        std::normal_distribution<> normal;
        for (double t = kFix_s; t < 60; t += kFix_s)
            zero.fix(share * 2.5 * t + 0.05 * normal(random), 2.5 + 0.05 * normal(random));

        EXPECT_NEAR(zero.drift.scale(), 1 / share, 0.01);
        EXPECT_NEAR(zero.height_m, 0, 0.5) << "what the scale explains is not drift";
    }
}

// What noise adds to one rise the next takes back.
TEST(BarometerDrift, however_often_fixes_come_a_climb_of_sixty_metres_shows_the_scale) {
    for (const double interval_s : {0.1, 0.2, 1.0})
        for (const double climb_mps : {1.0, 5.0}) {
            Zero zero(0);
            std::mt19937 random(2);
            std::normal_distribution<> normal;
            for (double t = interval_s; t * climb_mps < 60; t += interval_s)
                zero.fix(0.95 * climb_mps * t + 0.05 * normal(random),
                         climb_mps + 0.05 * normal(random), static_cast<float>(interval_s));

            EXPECT_NEAR(zero.drift.scale(), 1 / 0.95, 0.012) << interval_s << " s, " << climb_mps;
        }
}

TEST(BarometerDrift, a_receivers_noise_on_slow_slopes_is_no_scale) {
    Zero zero(0);
    std::mt19937 random(1);
    std::normal_distribution<> normal;
    for (int slope = 0; slope < 20; ++slope) {
        const double climb_mps = slope % 2 ? -1 : 1, from_m = slope % 2 ? 50 : 0;
        for (double t = 0; t < 50; t += kFix_s)
            zero.fix(from_m + climb_mps * t, climb_mps + 0.1 * normal(random));
    }
    EXPECT_NEAR(zero.drift.scale(), 1, 0.002);
}

TEST(BarometerDrift, the_scale_goes_on_after_a_restart_where_it_was) {
    for (const float scale : {0.9f, 0.99f, 1.0f, 1.004f, 1.07f}) {
        BarometerDrift drift;
        drift.resumeScale(scale);
        EXPECT_NEAR(drift.scale(), scale, 1e-6);
    }
    BarometerDrift drift;
    drift.resumeScale(0);  // no record of ours
    EXPECT_NEAR(drift.scale(), 0.87, 1e-6);
}

TEST(BarometerDrift, is_tracked_after_a_climb_as_before_it) {
    Zero zero(0);
    zero.fly(
        40, [](double t) { return 2.5 * t; }, 2.5);
    const double before_m = zero.height_m;
    zero.fly(30, risen, 0);
    EXPECT_NEAR(zero.height_m - before_m, 0.4, 0.05);
    EXPECT_EQ(zero.drift.scale(), 1);
}

TEST(BarometerDrift, a_wrong_velocity_in_level_flight_shows_no_scale) {
    Zero zero(100);
    zero.fly(300, level, -0.5);

    EXPECT_EQ(zero.drift.scale(), 1);
}

TEST(BarometerDrift, a_velocity_error_is_forgotten_within_minutes) {
    Zero zero(100);
    zero.fly(3600, level, -0.005);
    EXPECT_NEAR(zero.height_m, 0.8, 0.05);

    zero.fly(1200, level, 0);
    EXPECT_NEAR(zero.height_m, 0, 0.06);
}

TEST(BarometerDrift, an_interval_without_fixes_is_ignored) {
    Zero zero(100);
    zero.fly(30, risen, 0);
    const double before_m = zero.height_m;
    zero.fix(150, 0, 10);

    EXPECT_EQ(zero.height_m, before_m);
}

TEST(BarometerDrift, a_jump_of_metres_is_not_taken_for_drift) {
    Zero zero(100);
    zero.fly(
        10, [](double t) { return t < 5 ? 100 : 140; }, 0);

    EXPECT_NEAR(zero.height_m, 0, 1e-6);
}

TEST(BarometerDrift, a_wrong_velocity_moves_the_estimate_by_two_metres_at_most_and_it_recovers) {
    Zero zero(100);
    zero.fly(300, level, -0.1);
    EXPECT_NEAR(zero.height_m, 2, 0.1);

    zero.fly(1200, level, 0);
    EXPECT_NEAR(zero.height_m, 0, 0.15);
}

TEST(BarometerDrift, a_velocity_that_is_far_off_is_not_used) {
    Zero zero(0);
    zero.fly(
        40, [](double t) { return 2.5 * t; }, 2.5);
    zero.fly(300, level, -0.5);

    EXPECT_NEAR(zero.height_m, 0, 0.5);
    EXPECT_EQ(zero.drift.scale(), 1);
}

TEST(BarometerDrift, a_known_zero_does_not_drift) {
    Zero zero(100);
    zero.fly(30, risen, 0);
    zero.drift.zero();
    zero.height_m = 0;
    zero.fly(
        300, [](double) { return risen(30 - kFix_s); }, 0);

    EXPECT_NEAR(zero.height_m, 0, 0.01);
}

// Of the barometer's own error over ten minutes, with velocities that err by so much.
double leftOfError(double velocity_mps, float interval_s) {
    double own = 0, left = 0;
    for (unsigned seed = 1; seed <= 30; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<> normal;
        flight::Wander wander{0.35, 300};
        wander.start(random);
        const double start_m = wander.value;
        Zero zero(0);
        for (int fix = 0; fix * interval_s < 600; ++fix) {
            const double off_m = wander.step(interval_s, random) - start_m;
            zero.fix(off_m, velocity_mps * normal(random), interval_s);
            own += off_m * off_m;
            left += std::pow(off_m - zero.height_m, 2);
        }
    }
    return std::sqrt(left / own);
}

// Take-offs with a fix a second: the climb begins between two of them, and their sum is wrong by up
// to half of its first second. How wrong the scale is that it is taken for, RMS.
TEST(BarometerDrift, takes_little_of_a_climb_that_begins_between_two_fixes_for_scale) {
    double squares = 0;
    constexpr int kPhases = 20;
    for (int phase = 0; phase < kPhases; ++phase) {
        const double begins_s = 5 + (phase + 0.5) / kPhases, ends_s = begins_s + 20;
        const auto height_m = [&](double t) {
            return 4 * (std::max(t - begins_s, 0.0) - std::max(t - ends_s, 0.0));
        };
        Zero zero(0);
        // the barometer is read half an interval after the fix
        for (int t = 1; t < 40; ++t)
            zero.fix(height_m(t + 0.5), t > begins_s && t < ends_s ? 4 : 0, 1);
        squares += std::pow(zero.drift.scale() - 1, 2) / kPhases;
    }
    EXPECT_LT(std::sqrt(squares), 0.003);
}

// With the errors of the flights' sensors.
TEST(BarometerDrift, leaves_a_sixth_less_error_than_the_barometer_alone) {
    EXPECT_LT(leftOfError(0.05, 0.2f), 0.85);
    EXPECT_LT(leftOfError(0.05, 0.1f), 0.85);
    EXPECT_LT(leftOfError(0.05, 1), 0.95);
}

// One fix a second does not show what gusts did in between, as if its velocity erred by that.
TEST(BarometerDrift, hardly_adds_to_the_error_in_gusts_with_a_fix_a_second) {
    EXPECT_LT(leftOfError(0.12, 1), 1.1);
}

}  // namespace

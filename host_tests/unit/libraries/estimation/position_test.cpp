// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/position.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "flight.hpp"

namespace {

using estimation::Position;
using estimation::PositionSettings;

constexpr geo::Position kStart = {473977000, 85456000};

geo::Position place(const flight::V3& ned, const geo::Position& start = kStart) {
    return geo::moved(start, {static_cast<float>(ned.x), static_cast<float>(ned.y)});
}

struct Figures {
    double position_m, velocity_mps, worst_m;
};

// True accelerations with a bias; the sum since the fix's time comes as from the attitude's.
Figures fly(const geo::Position& start, const flight::Errors& errors, uint32_t seed) {
    flight::Flight flight(flight::wholeFlight(), errors, seed);
    Position position;
    std::deque<flight::V3> velocities;
    double place_square = 0, velocity_square = 0, worst = 0;
    int n = 0;
    for (int sample = 1; flight.step(); ++sample) {
        const flight::Truth& t = flight.truth();
        velocities.push_back(t.velocity);
        if (velocities.size() > 50) velocities.pop_front();
        if (sample % 2 == 0) {
            const flight::V3 a =
                (t.velocity - velocities[velocities.size() > 2 ? velocities.size() - 3 : 0]) * 100;
            position.propagate(flight::single(a + flight::V3{0.05, -0.05, 0}), 0.01f);
        }
        if (sample % 40 == 7) {
            const flight::Flight::Fix fix = flight.gps();
            const flight::V3 gained = t.velocity - velocities.front();
            position.useGps(place(fix.position, start), flight::single(fix.velocity),
                            flight::single(gained), PositionSettings());
        }
        if (sample < 1000) continue;
        const geo::Offset off = geo::offset(place(t.position, start), position.position());
        const double error = std::hypot(off.north_m, off.east_m);
        place_square += error * error;
        worst = std::max(worst, error);
        const core::Vector3& v = position.velocity_mps();
        velocity_square += std::pow(v.x - t.velocity.x, 2) + std::pow(v.y - t.velocity.y, 2);
        ++n;
    }
    return {std::sqrt(place_square / n), std::sqrt(velocity_square / n), worst};
}

flight::Errors withoutNoise() {
    flight::Errors errors;
    errors.gps_wander_m = errors.gps_noise_mps = 0;
    return errors;
}

TEST(Position, makes_up_for_the_age_of_the_fixes_through_steep_turns) {
    for (uint32_t seed = 1; seed <= 3; ++seed) {
        const Figures figures = fly(kStart, withoutNoise(), seed);
        EXPECT_LT(figures.position_m, 0.25);
        EXPECT_LT(figures.worst_m, 1.5);
    }
}

TEST(Position, is_nearer_than_the_fixes_through_steep_turns) {
    double square = 0;
    for (uint32_t seed = 1; seed <= 10; ++seed) {
        const Figures figures = fly(kStart, flight::Errors(), seed);
        square += figures.position_m * figures.position_m / 10;
        EXPECT_LT(figures.velocity_mps, 0.15);
    }
    EXPECT_LT(std::sqrt(square), 0.7);  // 0.6 an axis: the fixes wander by 0.85
}

TEST(Position, works_across_the_antimeridian) {
    const Figures figures = fly({-170000000, 1799999000}, withoutNoise(), 1);

    EXPECT_LT(figures.position_m, 0.25);
}

struct Fixes {
    double period_s = 0.2;
    double wander_m = 0, velocity_noise_mps = 0, velocity_bias_mps = 0;
};

// RMS of the place's error across the way of ten minutes on circles of 60 m, after the first.
double offAcross_m(const Fixes& fixes, uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<> normal;
    flight::Wander north{fixes.wander_m, 60}, east{fixes.wander_m, 60};
    north.start(random);
    east.start(random);
    constexpr double kSpeed_mps = 13, kRadius_m = 60, kAge_s = PositionSettings().gps_age_s;
    const auto angle = [&](double t_s) { return t_s * kSpeed_mps / kRadius_m; };
    const auto velocity = [&](double t_s) {
        return flight::V3{-kSpeed_mps * sin(angle(t_s)), kSpeed_mps * cos(angle(t_s)), 0};
    };
    const auto at = [&](double t_s) {
        return flight::V3{kRadius_m * cos(angle(t_s)), kRadius_m * sin(angle(t_s)), 0};
    };
    Position position;
    double square = 0, next_s = 0;
    int n = 0;
    for (double t_s = 0; t_s < 600; t_s += 0.04) {
        position.propagate(flight::single((velocity(t_s) - velocity(t_s - 0.04)) * 25), 0.04f);
        if (t_s >= next_s) {
            next_s += fixes.period_s;
            const double then_s = t_s - kAge_s;
            const flight::V3 off = {north.step(fixes.period_s, random),
                                    east.step(fixes.period_s, random), 0};
            const auto noise = [&] { return fixes.velocity_noise_mps * normal(random); };
            const flight::V3 reported =
                velocity(then_s) + flight::V3{noise() + fixes.velocity_bias_mps, noise(), 0};
            position.useGps(place(at(then_s) + off), flight::single(reported),
                            flight::single(velocity(t_s) - velocity(then_s)), PositionSettings());
        }
        if (t_s < 60) continue;
        const geo::Offset here = geo::offset(kStart, position.position());
        square += std::pow(std::hypot(here.north_m, here.east_m) - kRadius_m, 2);
        ++n;
    }
    return std::sqrt(square / n);
}

TEST(Position, averages_the_receivers_wander_away) {
    Fixes fixes;
    fixes.wander_m = 0.6;
    fixes.velocity_noise_mps = 0.05;
    double square = 0;
    for (uint32_t seed = 1; seed <= 20; ++seed) square += std::pow(offAcross_m(fixes, seed), 2);

    EXPECT_LT(std::sqrt(square / 20), 0.4);  // of the 0.6 that the fixes are off
}

TEST(Position, averages_fixes_that_come_once_a_second_as_well) {
    Fixes fixes;
    fixes.period_s = 1;
    EXPECT_LT(offAcross_m(fixes, 1), 0.5);
}

TEST(Position, keeps_to_the_fixes_when_their_velocity_is_wrong) {
    Fixes fixes;
    fixes.velocity_bias_mps = 0.1;
    EXPECT_LT(offAcross_m(fixes, 1), 2.5);
}

TEST(Position, is_not_known_before_a_fix_nor_long_after_the_last) {
    Position position;
    EXPECT_FALSE(position.known());

    position.useGps(kStart, {10, 0, 0}, {0, 0, 0}, PositionSettings());
    EXPECT_TRUE(position.known());
    for (int i = 0; i < 1990; ++i) position.propagate({0, 0, 0}, 0.01f);
    EXPECT_TRUE(position.known());
    EXPECT_TRUE(position.reckoned());
    for (int i = 0; i < 20; ++i) position.propagate({0, 0, 0}, 0.01f);
    EXPECT_FALSE(position.known());
}

TEST(Position, bounds_an_error_of_the_accelerations_when_fixes_stop) {
    Position position;
    position.useGps(kStart, {10, -5, 0}, {0, 0, 0}, PositionSettings());
    for (int i = 0; i < 2000; ++i) {
        position.propagate({0.2f, 0, 0}, 0.01f);
        if (i % 10 == 9) position.reckon(10, -5, 0.05f);
    }
    EXPECT_NEAR(position.velocity_mps().x, 10.4, 0.05) << "two seconds' worth of it";
    EXPECT_NEAR(position.velocity_mps().y, -5, 0.01);
}

// A nose that swings to and fro with the ailerons, as a course, would have the bank swing.
TEST(Position, follows_the_nose_slowly_when_fixes_stop) {
    Position position;
    position.useGps(kStart, {15, 0, 0}, {0, 0, 0}, PositionSettings());
    for (int i = 0; i < 1500; ++i) {
        position.propagate({0, 0, 0}, 0.01f);
        const float swing_mps = 3 * sinf(core::radians(360) * static_cast<float>(i) / 150);
        if (i >= 100 && i % 10 == 9) position.reckon(15, swing_mps, 0.05f);  // as the firmware does
        ASSERT_LT(fabsf(position.velocity_mps().y), 0.5f) << i;
    }
}

struct Jumping {
    Position position;
    void fix(const geo::Position& at) {
        position.useGps(at, {0, 0, 0}, {0, 0, 0}, PositionSettings());
        for (int i = 0; i < 20; ++i) position.propagate({0, 0, 0}, 0.01f);
    }
    float from_m(const geo::Position& place) const {
        return geo::distance_m(position.position(), place);
    }
};

TEST(Position, a_jump_is_refused_until_it_has_lasted) {
    Jumping gps;
    const geo::Position far = geo::moved(kStart, {500, 0});
    for (int i = 0; i < 5; ++i) gps.fix(kStart);
    for (int i = 0; i < 85; ++i) {
        gps.fix(far);
        ASSERT_LT(gps.from_m(kStart), 0.1) << i;
        ASSERT_TRUE(gps.position.refuses());
    }
    gps.fix(kStart);
    EXPECT_FALSE(gps.position.refuses());
    for (int i = 0; i < 102; ++i) gps.fix(far);
    EXPECT_LT(gps.from_m(far), 0.5);
    EXPECT_FALSE(gps.position.refuses());
}

// However long: nonsense from a receiver never agrees with itself.
TEST(Position, refuses_fixes_that_do_not_lie_where_the_one_before_leads) {
    Jumping gps;
    for (int i = 0; i < 5; ++i) gps.fix(kStart);
    for (int i = 0; i < 300; ++i) {
        gps.fix(geo::moved(kStart, {i % 2 ? 500.0f : -500.0f, 40.0f * static_cast<float>(i)}));
        ASSERT_TRUE(gps.position.refuses()) << i;
    }
    EXPECT_FALSE(gps.position.known());
    gps.fix(kStart);
    gps.fix(kStart);
    EXPECT_FALSE(gps.position.refuses());
    EXPECT_LT(gps.from_m(kStart), 0.5);
}

TEST(Position, finds_a_fast_airplane_again_by_two_fixes_after_a_minute) {
    Position position;
    const auto fix = [&](float north_m) {
        position.useGps(geo::moved(kStart, {north_m, 0}), {40, 0, 0}, {0, 0, 0}, {0.2f});
    };
    fix(0);
    for (int i = 0; i < 6000; ++i) position.propagate({0, 0, 0}, 0.01f);
    position.reckon(15, 0, 1);
    fix(2000);
    EXPECT_TRUE(position.refuses());
    for (int i = 0; i < 20; ++i) position.propagate({0, 0, 0}, 0.01f);
    fix(2008);
    EXPECT_FALSE(position.refuses());
    EXPECT_NEAR(geo::offset(kStart, position.position()).north_m, 2016, 0.5);
    EXPECT_NEAR(position.velocity_mps().x, 40, 0.1);
}

// The limit is 33 m after a fifth of a second; a quarter of what is off is taken over.
TEST(Position, knows_how_far_the_last_fix_lay_off_its_limit) {
    Jumping gps;
    EXPECT_EQ(gps.position.fixTestRatio(), 0);
    for (int i = 0; i < 5; ++i) gps.fix(kStart);
    EXPECT_NEAR(gps.position.fixTestRatio(), 0, 0.01);
    gps.fix(geo::moved(kStart, {16.5f, 0}));
    EXPECT_NEAR(gps.position.fixTestRatio(), 0.5, 0.01);
    EXPECT_FALSE(gps.position.refuses());
    gps.fix(geo::moved(kStart, {0, 60}));
    EXPECT_GT(gps.position.fixTestRatio(), 1.5);
    EXPECT_TRUE(gps.position.refuses());
    for (int i = 0; i < 300; ++i) gps.position.propagate({0, 0, 0}, 0.01f);
    EXPECT_GT(gps.position.fixTestRatio(), 1.5) << "of the fix, not of now";
    gps.fix(geo::moved(kStart, {0, 60}));  // 78 m after 3.2 s
    EXPECT_NEAR(gps.position.fixTestRatio(), 0.75, 0.1);
}

TEST(Position, a_jump_that_could_have_been_flown_since_the_last_fix_is_accepted) {
    Jumping gps;
    for (int i = 0; i < 5; ++i) gps.fix(kStart);
    for (int i = 0; i < 600; ++i) gps.position.propagate({0, 0, 0}, 0.01f);
    const geo::Position drifted = geo::moved(kStart, {100, 0});
    gps.fix(drifted);
    EXPECT_LT(gps.from_m(drifted), 0.5);
}

// 10 m/s, and 5 more for each second without a fix.
TEST(Position, refuses_a_fix_whose_velocity_nobody_can_have_reached) {
    Position position;
    const auto fix = [&](float north_mps, float after_s) {
        for (int i = 0; i < std::lround(after_s * 100); ++i) position.propagate({0, 0, 0}, 0.01f);
        position.useGps(position.position(), {north_mps, 0, 0}, {0, 0, 0}, PositionSettings());
    };
    position.useGps(kStart, {15, 0, 0}, {0, 0, 0}, PositionSettings());
    fix(15, 0.2f);
    fix(27, 0.2f);  // 11 m/s after a fifth of a second
    EXPECT_TRUE(position.refuses());
    EXPECT_NEAR(position.velocity_mps().x, 15, 0.1);
    fix(3, 0.2f);  // 12 after two
    EXPECT_TRUE(position.refuses());
    fix(27, 0.2f);  // 13 after three
    EXPECT_FALSE(position.refuses());
    EXPECT_NEAR(position.velocity_mps().x, 15 + 0.4f * 12, 0.1);
    fix(position.velocity_mps().x - 19, 2.0f);
    EXPECT_FALSE(position.refuses());
}

TEST(Position, reckons_with_the_velocity_it_is_given_once_fixes_are_missing) {
    Position position;
    position.useGps(kStart, {10, 0, 0}, {0, 0, 0}, PositionSettings());
    for (int i = 0; i < 150; ++i) position.propagate({0, 0, 0}, 0.01f);
    position.reckon(0, 10, 1);
    for (int i = 0; i < 1000; ++i) position.propagate({0, 0, 0}, 0.01f);

    const geo::Offset off = geo::offset(kStart, position.position());
    EXPECT_NEAR(off.north_m, 17.4, 0.5);
    EXPECT_NEAR(off.east_m, 100, 0.5);
}

TEST(Position, the_smallest_steps_add_up) {
    Position position;
    position.useGps(kStart, {0.1f, 0, 0}, {0, 0, 0}, PositionSettings());
    for (int n = 0; n < 5000; ++n) {
        for (int i = 0; i < 20; ++i) position.propagate({0, 0, 0}, 0.01f);
        const geo::Position here = geo::moved(kStart, {0.02f * n, 0});
        position.useGps(here, {0.1f, 0, 0}, {0, 0, 0}, PositionSettings());
    }

    EXPECT_NEAR(geo::offset(kStart, position.position()).north_m, 100.0, 0.1);
}

}  // namespace

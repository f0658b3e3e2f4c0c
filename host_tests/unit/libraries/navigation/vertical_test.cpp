// SPDX-License-Identifier: GPL-3.0-or-later
// Slopes, landings and take-offs.
#include <gtest/gtest.h>

#include <cmath>

#include "control/speed_height.hpp"
#include "flight_model.hpp"
#include "navigation/landing.hpp"
#include "navigation/slope.hpp"
#include "navigation/takeoff.hpp"

namespace {

using navigation::heightOnSlope;

TEST(Slope, runs_straight_from_one_height_to_the_other_and_is_level_beyond) {
    const struct {
        float along, height, climb;
    } cases[] = {{-10, 50, 0}, {0, 50, 0}, {100, 60, 1.2f}, {300, 80, 1.2f}, {500, 100, 0}};
    for (const auto& c : cases) {
        const auto demand = heightOnSlope(50, 100, 500, c.along, 12);
        EXPECT_FLOAT_EQ(demand.height_m, c.height) << c.along;
        EXPECT_FLOAT_EQ(demand.climb_mps, c.climb) << c.along;
    }
}

TEST(Slope, of_no_length_is_the_end_height) {
    EXPECT_FLOAT_EQ(heightOnSlope(50, 100, 0, 0.5f, 12).height_m, 100);
}

constexpr navigation::LandingSettings kLanding{1.5f, 1.5f, 0.4f, 0.4f};

TEST(Landing, the_slope_aims_short_of_the_point_by_what_the_flare_adds) {
    navigation::Landing landing;
    landing.start();
    // The flare begins at 1.63 m with 1.08 m/s and ends with 0.4: 1.46 times the 16.5 m of slope,
    // to 4.4 m, or 0.4 s, behind the point.
    const auto demand = landing.run(kLanding, {30, 300, 100, 11, 20, 1});

    EXPECT_NEAR(demand.height_m, 30 * (1 - 100 / 296.8), 0.01);
    EXPECT_NEAR(demand.climb_mps, -11 * 30 / 296.8, 0.01);
    EXPECT_FALSE(landing.flaring());
}

TEST(Landing, flares_at_the_height_or_the_time_whichever_comes_first) {
    navigation::Landing low, early;
    low.start();
    early.start();
    low.run(kLanding, {10, 500, 400, 10, 1.7f, 0.2f});
    EXPECT_FALSE(low.flaring());
    low.run(kLanding, {10, 500, 410, 10, 1.55f, 0.2f});
    EXPECT_TRUE(low.flaring());
    early.run(kLanding, {60, 300, 270, 12, 3.5f, 2.4f});
    EXPECT_TRUE(early.flaring()) << "1.5 s at 2.4 m/s";
}

TEST(Landing, flares_past_the_point_however_high_it_is) {
    navigation::Landing landing;
    landing.start();
    landing.run(kLanding, {30, 300, 301, 11, 9, 1});

    EXPECT_TRUE(landing.flaring());
}

navigation::Landing flaring() {
    navigation::Landing landing;
    landing.start();
    landing.run(kLanding, {30, 300, 270, 11, 1.6f, 1.0f});
    EXPECT_TRUE(landing.flaring());
    return landing;
}

TEST(Landing, the_lower_it_is_the_less_it_sinks_though_the_point_is_near) {
    auto landing = flaring();
    float before_mps = 1.4f;
    for (float height_m : {1.5f, 1.0f, 0.6f, 0.3f}) {
        const float sink_mps = -landing.run(kLanding, {30, 300, 303, 10, height_m, 1}).climb_mps;
        EXPECT_LT(sink_mps, before_mps) << height_m;
        EXPECT_GT(sink_mps, 0.45f) << height_m;
        before_mps = sink_mps;
    }
    EXPECT_LT(before_mps, 0.6f);
    EXPECT_FLOAT_EQ(landing.run(kLanding, {30, 300, 280, 10, 0.01f, 1}).climb_mps, -0.4f);
}

TEST(Landing, does_not_dive_at_the_point_however_high_it_is) {
    auto landing = flaring();
    EXPECT_NEAR(landing.run(kLanding, {30, 300, 303, 10, 9, 1}).climb_mps, -1.1f, 0.03f);
}

TEST(Landing, where_the_ground_should_have_been_it_comes_down_a_little_faster) {
    auto landing = flaring();
    const auto sink_mps = [&](float height_m) {
        return -landing.run(kLanding, {30, 300, 290, 10, height_m, 0.4f}).climb_mps;
    };
    EXPECT_FLOAT_EQ(sink_mps(0), 0.4f);
    EXPECT_FLOAT_EQ(sink_mps(-0.5f), 0.6f);
    EXPECT_FLOAT_EQ(sink_mps(-20), 0.68f) << "no more than that";
}

TEST(Landing, above_the_slope_it_does_not_dive_back_to_it) {
    navigation::Landing landing;
    landing.start();
    const float on_slope_m = landing.run(kLanding, {30, 300, 250, 11, 4.5f, 1}).height_m;
    ASSERT_NEAR(on_slope_m, 4.7f, 0.1f);
    EXPECT_FLOAT_EQ(landing.run(kLanding, {30, 300, 250, 11, 8, 1}).height_m, 6.8f);
    EXPECT_FLOAT_EQ(landing.run(kLanding, {30, 300, 250, 11, 3, 1}).height_m, on_slope_m);
}

TEST(Landing, touches_down_softly_near_the_point) {
    for (double headwind : {0.0, 4.0}) {
        flight_model::Airplane plane({-headwind, 0, 0, 1});
        plane.height = 30;
        plane.velocity_n = 12 - headwind;
        control::SpeedHeightSettings settings{3.5f, 1.2f, 2.5f, 2,    0.7f, 0.3f,
                                              7,    2,    10,   0.5f, 0.5f, 0.4f};
        const control::SpeedHeightLimits limits{-0.3f, 0.3f, 0, 0.75f, 0.4f, 1, 9, 22};
        control::SpeedHeight core;
        navigation::Landing landing;
        landing.start();
        const auto measured = [&] {
            return control::SpeedHeightMeasured{static_cast<float>(plane.height),
                                                static_cast<float>(plane.climb),
                                                static_cast<float>(plane.airspeed),
                                                static_cast<float>(plane.forward_mss),
                                                1,
                                                true};
        };
        core.start(measured(), 0.03f, 0.3f);
        for (int i = 0; i < 2000 && plane.height > 0; ++i) {
            const auto height = landing.run(
                kLanding,
                {30, 350, static_cast<float>(plane.north), static_cast<float>(plane.velocity_n),
                 static_cast<float>(plane.height), static_cast<float>(-plane.climb)});
            auto bounds = limits;
            if (landing.flaring()) bounds.pitch_min_rad = bounds.throttle_max = 0;
            const auto out =
                core.run(settings, bounds, {height.height_m, height.climb_mps, 10.5f}, measured(),
                         landing.flaring() ? control::Phase::flare : control::Phase::cruise, 0.05f);
            plane.pitch_demand = out.pitch_rad;
            plane.throttle = out.throttle;
            for (int k = 0; k < 10; ++k) plane.step(0.005);
        }

        EXPECT_NEAR(plane.north, 350, 5) << headwind;
        EXPECT_LT(-plane.climb, 0.9) << headwind;
        EXPECT_GT(plane.airspeed, 7.5) << headwind;
    }
}

constexpr navigation::LaunchState kStill{0, 0, 0, 0.1f, 0.05f};

TEST(Launch, without_a_push_asked_for_only_the_delay_passes) {
    navigation::Launch launch;
    launch.start();
    const navigation::LaunchSettings settings{0, 0, 2};
    int runs = 1;
    while (!launch.run(settings, kStill)) ASSERT_LT(++runs, 100);

    EXPECT_NEAR(runs, 5, 1) << "0.2 s";
}

TEST(Launch, waits_for_push_and_speed) {
    navigation::Launch launch;
    launch.start();
    const navigation::LaunchSettings settings{4, 15, 2};
    for (int i = 0; i < 50; ++i) EXPECT_FALSE(launch.run(settings, kStill));
    EXPECT_FALSE(launch.run(settings, {20, 3, 0, 0.1f, 0.05f}));
    bool running = false;
    for (int i = 0; i < 6; ++i) running = launch.run(settings, {2, 8, 0, 0.1f, 0.05f});

    EXPECT_TRUE(running);
}

TEST(Launch, a_push_without_speed_is_forgotten) {
    navigation::Launch launch;
    launch.start();
    const navigation::LaunchSettings settings{4, 15, 2};
    launch.run(settings, {20, 1, 0, 0.1f, 0.05f});
    for (int i = 0; i < 20; ++i) launch.run(settings, kStill);

    EXPECT_FALSE(launch.run(settings, {0, 9, 0, 0.1f, 0.05f})) << "carried fast, not thrown";
}

TEST(Launch, says_once_of_a_push_why_it_was_none) {
    using navigation::Launch;
    Launch launch;
    launch.start();
    const navigation::LaunchSettings settings{4, 15, 2};
    const navigation::LaunchState tilted{20, 9, 0.6f, 0.1f, 0.05f}, pushed{20, 1, 0, 0.1f, 0.05f};
    EXPECT_EQ(launch.run(settings, tilted), Launch::tilted);
    EXPECT_EQ(launch.run(settings, tilted), Launch::waits);
    EXPECT_EQ(launch.run(settings, {0, 0, 0.6f, 0.1f, 0.05f}), Launch::waits);
    EXPECT_EQ(launch.run(settings, tilted), Launch::tilted) << "the next one";
    int slow = 0;
    EXPECT_EQ(launch.run(settings, pushed), Launch::waits);
    for (int i = 0; i < 20; ++i) slow += launch.run(settings, kStill) == Launch::slow;
    EXPECT_EQ(slow, 1);
}

TEST(Launch, never_starts_the_motor_lying_on_its_side_or_nose) {
    navigation::Launch launch;
    launch.start();
    const navigation::LaunchSettings settings{0, 0, 0};
    for (const auto& state : {navigation::LaunchState{0, 0, 0.6f, 0, 0.05f},
                              navigation::LaunchState{0, 0, -0.6f, 0, 0.05f},
                              navigation::LaunchState{0, 0, 0, 0.9f, 0.05f},
                              navigation::LaunchState{0, 0, 0, -0.6f, 0.05f}})
        for (int i = 0; i < 40; ++i) EXPECT_FALSE(launch.run(settings, state));
}

TEST(TakeoffCourse, is_the_one_the_run_began_with) {
    navigation::TakeoffCourse course;
    course.start(0.3f);
    for (int i = 0; i < 39; ++i) course.run({8, 0}, 8, 0.3f, 0.05f);
    EXPECT_FALSE(course.locked());
    // meanwhile the airplane has swung 0.2 rad to the right, and flies that way
    const float now = 0.5f;
    for (int i = 0; i < 3; ++i) course.run({8 * std::cos(now), 8 * std::sin(now)}, 8, 0.5f, 0.05f);

    ASSERT_TRUE(course.locked());
    EXPECT_NEAR(std::atan2(course.course().east_m, course.course().north_m), 0.3, 1e-3);
}

TEST(TakeoffCourse, a_slow_moment_begins_the_two_seconds_anew) {
    navigation::TakeoffCourse course;
    course.start(0);
    for (int i = 0; i < 35; ++i) course.run({8, 0}, 8, 0, 0.05f);
    course.run({4, 0}, 4, 0, 0.05f);
    for (int i = 0; i < 35; ++i) course.run({8, 0}, 8, 0, 0.05f);

    EXPECT_FALSE(course.locked());
}

TEST(TakeoffPitch, comes_up_with_the_speed) {
    const float degree = 3.14159265f / 180;
    const navigation::TakeoffPitch settings{15 * degree, 0, 9, 12};
    EXPECT_NEAR(takeoffPitch_rad(settings, 0, true) / degree, 5, 1e-3);
    EXPECT_NEAR(takeoffPitch_rad(settings, 8.1f, true) / degree, 10, 1e-2);
    EXPECT_NEAR(takeoffPitch_rad(settings, 9, true) / degree, 15, 1e-3);
    // without the sensor in proportion to the ground speed
    EXPECT_NEAR(takeoffPitch_rad(settings, 8, false) / degree, 10, 1e-3);
    EXPECT_NEAR(takeoffPitch_rad(settings, 1, false) / degree, 5, 1e-3);
    EXPECT_NEAR(takeoffPitch_rad(settings, 20, false) / degree, 15, 1e-3);
}

TEST(TakeoffPitch, stays_low_below_the_rotation_speed) {
    const navigation::TakeoffPitch settings{0.26f, 7, 6, 12};
    EXPECT_NEAR(takeoffPitch_rad(settings, 6.9f, true), 0.0873f, 1e-3);
    EXPECT_NEAR(takeoffPitch_rad(settings, 7.1f, true), 0.26f, 1e-3);
}

}  // namespace

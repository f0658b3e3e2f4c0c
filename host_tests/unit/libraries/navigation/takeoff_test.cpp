// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/takeoff.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

constexpr navigation::LaunchState kStill{0, 0, 0, 0.1f, 0.05f};

TEST(Launch, without_an_acceleration_threshold_only_the_delay_counts) {
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

TEST(Launch, reports_once_why_a_push_was_not_a_launch) {
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

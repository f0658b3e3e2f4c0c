// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/gyro_bias_init.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

const core::Vector3 kRest = {0, 0, -9.81f};

TEST(GyroBiasInit, a_second_of_rest_gives_the_gyros_zero) {
    estimation::GyroBiasInit still;
    int frames = 0;
    while (!still.update({0.01f, -0.02f, 0.005f}, kRest, 0.01f) && frames < 1000) ++frames;

    EXPECT_NEAR(frames, 105, 8);
    EXPECT_NEAR(still.zero_rads().x, 0.01, 1e-5);
    EXPECT_NEAR(still.zero_rads().y, -0.02, 1e-5);
    EXPECT_NEAR(still.zero_rads().z, 0.005, 1e-5);
}

TEST(GyroBiasInit, movement_restarts_the_mean) {
    estimation::GyroBiasInit still;
    for (int i = 0; i < 3000; ++i) {
        const float rate = 0.1f * std::sin(i * 0.05f);
        still.update({rate, 0, 0}, kRest, 0.01f);
    }
    EXPECT_FALSE(still.done());
    for (int i = 0; i < 140; ++i) still.update({0.01f, 0, 0}, kRest, 0.01f);
    EXPECT_TRUE(still.done());
}

// Rocked about its roll axis by up to `max_rads`, from rest, once in two seconds.
float rocked_rads(int frame, float max_rads) {
    return max_rads * std::sin(static_cast<float>(frame) * 0.01f * static_cast<float>(M_PI));
}

TEST(GyroBiasInit, an_airplane_rocked_by_gusts_gets_a_longer_mean) {
    estimation::GyroBiasInit still;
    int frames = 0;
    while (!still.update({0.01f + rocked_rads(frames, 0.015f), 0, 0}, kRest, 0.01f)) ++frames;
    EXPECT_GT(still.zero_rads().x, 0.015);  // of half a swing
    for (; frames < 1500; ++frames)
        still.update({0.01f + rocked_rads(frames, 0.04f), 0, 0}, kRest, 0.01f);

    EXPECT_NEAR(still.zero_rads().x, 0.01, 0.001);
}

// Its wheels let it tip to and fro four times a second, by up to 4 degrees a second.
TEST(GyroBiasInit, an_airplane_always_rocked_by_gusts_gets_its_zero_within_ten_seconds) {
    for (float phase = 0; phase < 6.28f; phase += 0.3f) {
        estimation::GyroBiasInit still;
        int frames = 0;
        for (; !still.done() && frames < 1000; ++frames) {
            const float time_s = static_cast<float>(frames) * 0.01f;
            const float rocks =
                0.05f * std::sin(25 * time_s + phase) + 0.02f * std::sin(16 * time_s + 3 * phase);
            still.update({0.01f + rocks, -0.02f - rocks, 0.005f}, kRest, 0.01f);
        }
        ASSERT_TRUE(still.done()) << phase;
        EXPECT_GT(frames, 400);
        EXPECT_NEAR(still.zero_rads().x, 0.01, 0.002) << phase;
        EXPECT_NEAR(still.zero_rads().y, -0.02, 0.002) << phase;
    }
}

TEST(GyroBiasInit, slow_turning_by_hand_is_not_taken_for_rocking) {
    estimation::GyroBiasInit still;
    for (int i = 0; i < 3000; ++i) {  // once in 4.4 seconds
        const float rate = 0.05f * std::sin(static_cast<float>(i) * 0.01f * 1.428f);
        still.update({rate, 0, 0}, kRest, 0.01f);
        ASSERT_FALSE(still.done()) << i << ' ' << still.zero_rads().x;
    }
}

TEST(GyroBiasInit, a_better_zero_is_not_given_up_for_a_shorter_one) {
    estimation::GyroBiasInit still;
    for (int i = 0; i < 1500; ++i) still.update({0.01f, 0, 0}, kRest, 0.01f);
    for (int i = 0; i < 50; ++i) still.update({0.3f, 0, 0}, kRest, 0.01f);
    int reported = 0;
    for (int i = 0; i < 500; ++i) reported += still.update({0.02f, 0, 0}, kRest, 0.01f);

    EXPECT_EQ(reported, 0);
    EXPECT_NEAR(still.zero_rads().x, 0.01, 1e-5);
}

TEST(GyroBiasInit, an_airplane_picked_up_slowly_keeps_the_zero_measured_before) {
    for (int rest = 115; rest < 800; rest += 7) {
        estimation::GyroBiasInit still;
        float zero_rads = 0;
        const auto update = [&](float rate_rads, const core::Vector3& force_mss) {
            if (still.update({rate_rads, 0, 0}, force_mss, 0.01f)) zero_rads = still.zero_rads().x;
        };
        for (int i = 0; i < rest; ++i) update(0.01f, kRest);
        ASSERT_TRUE(still.done()) << rest;
        for (int i = 0; i < 300; ++i) {
            const float tilt = 0.0873f * 0.01f * static_cast<float>(i);  // 5 degrees a second
            update(0.01f + 0.0873f, {0, -9.81f * std::sin(tilt), -9.81f * std::cos(tilt)});
        }
        EXPECT_NEAR(zero_rads, 0.01, 1e-5) << rest;
    }
}

TEST(GyroBiasInit, reports_a_better_zero_for_half_a_minute) {
    estimation::GyroBiasInit still;
    int reported = 0;
    for (int i = 0; i < 6000; ++i) reported += still.update({0.01f, 0, 0}, kRest, 0.01f);

    EXPECT_TRUE(still.settled());
    EXPECT_GT(reported, 20);
    EXPECT_LE(reported, 30);
}

TEST(GyroBiasInit, keeps_the_force_of_its_first_second) {
    estimation::GyroBiasInit still;
    for (int i = 0; i < 150; ++i) still.update({0, 0, 0}, kRest, 0.01f);
    for (int i = 0; i < 300; ++i) still.update({0, 0, 0}, {0.3f, 0, -9.8f}, 0.01f);

    EXPECT_NEAR(still.force_mss().x, 0, 1e-5);
}

TEST(GyroBiasInit, carrying_it_about_without_turning_is_not_rest) {
    estimation::GyroBiasInit still;
    for (int i = 0; i < 3000; ++i)
        still.update({0, 0, 0}, {2 * std::sin(i * 0.05f), 0, -9.81f}, 0.01f);

    EXPECT_FALSE(still.done());
}

TEST(GyroBiasInit, a_broken_gyros_zero_is_not_taken) {
    estimation::GyroBiasInit still;
    for (int i = 0; i < 1000; ++i) still.update({0.6f, 0, 0}, kRest, 0.01f);

    EXPECT_FALSE(still.done());
}

}  // namespace

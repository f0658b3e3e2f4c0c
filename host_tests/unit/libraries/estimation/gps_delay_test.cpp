// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/gps_delay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/maths.hpp"

using estimation::FixComparison;
using estimation::GpsDelay;

namespace {

constexpr float kStep_s = 0.2f;  // fixes at 5 Hz

struct World {
    float late_s = 0;        // fixes are older than known for
    float yaw_rad = 0;       // error of the heading
    float noise_mss = 0.0f;  // of the difference of two fixes
};

// Turns to and fro with 20 degrees a second and 5 s each, at 15 m/s; the accelerometers are
// compared with a time that is wrong by what has not been learnt.
class Flight {
public:
    explicit Flight(World world) : world_(world) {}

    void fly(GpsDelay& delay, float time_s) {
        for (float until_s = now_s_ + time_s; now_s_ < until_s; now_s_ += kStep_s) compare(delay);
    }

private:
    static core::Vector3 acceleration(float time_s) {
        const float rate = 0.35f * std::tanh(3 * std::sin(0.63f * time_s));
        const float course = 0.35f * 1.6f * (1 - std::cos(0.63f * time_s));
        return {-15 * rate * std::sin(course), 15 * rate * std::cos(course), 0};
    }
    static core::Vector3 turned(core::Vector3 a, float rad) {
        return {a.x * std::cos(rad) - a.y * std::sin(rad),
                a.x * std::sin(rad) + a.y * std::cos(rad), 0};
    }

    void compare(GpsDelay& delay) {
        // the fix shows what was late_s ago, and is compared with what was used_s ago
        const float used_s = delay.correction_s();
        const core::Vector3 mean = turned(acceleration(now_s_ - used_s), world_.yaw_rad);
        core::Vector3 seen = acceleration(now_s_ - world_.late_s);
        seen.x += noise_(random_) * world_.noise_mss;
        seen.y += noise_(random_) * world_.noise_mss;
        comparison_.add(seen - mean, mean, 1 / kStep_s);
        if (comparison_.whole()) delay.learn(comparison_, used_s);
    }

    FixComparison comparison_;
    World world_;
    float now_s_ = 0;
    std::mt19937 random_{1};
    std::normal_distribution<float> noise_;
};

float learnt_s(World world, float time_s = 120) {
    GpsDelay delay;
    Flight(world).fly(delay, time_s);
    return delay.correction_s();
}

TEST(GpsDelay, is_learnt_in_turns) {
    for (float late_s : {-0.15f, -0.08f, 0.08f, 0.15f, 0.22f})
        EXPECT_NEAR(learnt_s({late_s}), late_s, 0.03f) << late_s;
}

TEST(GpsDelay, is_learnt_beside_a_wrong_heading) {
    for (float yaw_rad : {-0.2f, 0.2f})
        EXPECT_NEAR(learnt_s({0.15f, yaw_rad}), 0.15f, 0.04f) << yaw_rad;
}

TEST(GpsDelay, is_not_taken_from_a_wrong_heading) {
    for (float yaw_rad : {-0.3f, 0.3f}) EXPECT_NEAR(learnt_s({0, yaw_rad}), 0, 1e-6f) << yaw_rad;
}

TEST(GpsDelay, is_learnt_through_noise) {
    EXPECT_NEAR(learnt_s({0.15f, 0, 1.0f}, 240), 0.15f, 0.03f);
    EXPECT_NEAR(learnt_s({0, 0, 1.0f}, 240), 0, 1e-6f);
}

TEST(GpsDelay, hardly_moves_in_straight_flight) {
    GpsDelay delay;
    FixComparison comparison;
    std::mt19937 random{2};
    std::normal_distribution<float> noise{0, 0.5f};
    for (int i = 0; i < 6000; ++i) {
        const auto any = [&] { return core::Vector3{noise(random), noise(random), 0}; };
        comparison.add(any(), any(), 1);
        if (comparison.whole()) delay.learn(comparison, delay.correction_s());
        ASSERT_NEAR(delay.correction_s(), 0, 0.02f) << i;
    }
}

TEST(GpsDelay, stays_within_its_limits) {
    EXPECT_LE(learnt_s({0.6f}), GpsDelay::kMaxOlder_s);
    EXPECT_GE(learnt_s({-0.6f}), -GpsDelay::kMaxYounger_s);
}

TEST(GpsDelay, a_jump_of_the_receiver_is_no_turn) {
    GpsDelay delay;
    FixComparison jumps;
    for (int i = 0; i < 4; ++i) jumps.add({50, 0, 0}, {0, 1, 0}, 5);
    delay.learn(jumps, 0);
    jumps.add({0, 0, 0}, {0, 100, 0}, 5);
    delay.learn(jumps, 0);
    Flight({0.15f}).fly(delay, 120);
    EXPECT_FLOAT_EQ(delay.correction_s(), learnt_s({0.15f}));
}

TEST(FixComparison, is_whole_with_three_intervals) {
    FixComparison comparison;
    comparison.add({0, 0, 0}, {1, 0, 0}, 5);
    comparison.add({0.1f, 0.2f, 0}, {2, 7, 0}, 5);
    EXPECT_FALSE(comparison.whole());
    comparison.add({0, 0, 0}, {2, 4, 0}, 5);
    ASSERT_TRUE(comparison.whole());
    EXPECT_FLOAT_EQ(comparison.missing_mss().north, 0.1f);
    EXPECT_FLOAT_EQ(comparison.missing_mss().east, 0.2f);
    EXPECT_FLOAT_EQ(comparison.mean_mss().east, 7);
    EXPECT_FLOAT_EQ(comparison.change_msss().north, 2.5f);
    EXPECT_FLOAT_EQ(comparison.change_msss().east, 10);
}

// Another receiver, or one that slows down with more satellites.
TEST(GpsDelay, a_change_is_followed_within_minutes) {
    GpsDelay delay;
    Flight({0.15f}).fly(delay, 300);
    Flight({0.05f}).fly(delay, 300);
    EXPECT_NEAR(delay.correction_s(), 0.05f, 0.03f);
}

}  // namespace

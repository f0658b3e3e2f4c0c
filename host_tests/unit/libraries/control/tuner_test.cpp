// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/tuner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "control/attitude.hpp"

namespace {

using control::AxisTuner;
using Finding = AxisTuner::Finding;

constexpr float kDegree = 3.14159265f / 180;
constexpr float kNear = 0.15f;  // what comes late looks like strength

// An axis whose surface gives `strength` rad/s for all of it at the scaling speed.
struct Axis {
    float strength, lag_s = 0.08f, servo_s = 0.04f, speed_mps = 15, gust_rads = 0;
    float angle = 0, rate = 0, surface = 0, offset = 0;
    float on_the_way[3] = {};  // frames until the servo has heard of it
    std::mt19937 noise{7};

    void step(float demanded) {
        constexpr float dt = 0.01f;
        for (float& each : on_the_way) std::swap(each, demanded);  // out comes what went in first
        surface += (demanded - surface) * dt / servo_s;
        const float goal = (surface + offset) * strength * speed_mps / 15;
        rate += (goal - rate) * dt / lag_s +
                gust_rads * std::normal_distribution<float>()(noise) * std::sqrt(dt);
        angle += rate * dt;
    }
};

struct Tuning {
    control::RollSettings settings{{0.4f, 0.75f, 0.04f, 0.03f, 3000}, 0};
    control::AxisState state;
    AxisTuner tuner;
    control::Swing swing;
    int measured = 0, shaken = 0;

    void scale(float by) {
        settings.axis.p *= by;
        settings.axis.i *= by;
        settings.axis.d *= by;
    }
    float feedForward() const { return control::rollGains(settings).feed_forward.toFloat(); }
    template <class AnyAxis>
    void hold(AnyAxis& axis, float angle, float seconds) {
        const auto air = control::airFlow(15, axis.speed_mps, axis.speed_mps < 9);
        for (int i = 0; i < seconds * 100; ++i) {
            const auto gains = control::rollGains(settings);
            const core::Angle error(angle - axis.angle);
            const core::BodyRate rate(axis.rate);
            axis.step(control::rollDeflection(gains, state, air, error, rate, 2).toFloat());
            switch (tuner.watch(gains, state, air, control::demandedRate_rads(gains, error), rate,
                                swing)) {
                case Finding::measured:
                    ++measured;
                    scale(tuner.factor());
                    break;
                case Finding::shakes:
                    ++shaken;
                    scale(AxisTuner::kLeast);
                    break;
                default:
                    break;
            }
        }
    }
    void roll(Axis& axis, int times) {
        for (int i = 0; i < times; ++i) {
            hold(axis, 45 * kDegree, 3);
            hold(axis, -45 * kDegree, 3);
        }
    }
};

class Strengths : public testing::TestWithParam<float> {};

TEST_P(Strengths, are_found_from_full_turns) {
    Axis axis{GetParam()};
    Tuning tuning;
    tuning.roll(axis, 12);
    EXPECT_GE(tuning.measured, 15);
    EXPECT_NEAR(tuning.feedForward() * axis.strength, 1, kNear);
    EXPECT_EQ(tuning.shaken, 0);
}
INSTANTIATE_TEST_SUITE_P(OfAxes, Strengths, testing::Values(1.2f, 2.0f, 3.0f, 5.0f, 8.0f));

TEST(Tuner, finds_the_same_at_another_airspeed) {
    for (const float speed_mps : {11.0f, 22.0f}) {
        Axis axis{4};
        axis.speed_mps = speed_mps;
        Tuning tuning;
        tuning.roll(axis, 12);
        EXPECT_NEAR(tuning.feedForward() * axis.strength, 1, kNear) << speed_mps;
    }
}

TEST(Tuner, is_not_misled_by_gusts_nor_by_a_surface_out_of_trim) {
    Axis axis{4};
    axis.gust_rads = 0.5f;
    axis.offset = 0.15f;
    Tuning tuning;
    tuning.roll(axis, 20);
    EXPECT_NEAR(tuning.feedForward() * axis.strength, 1, 0.15);
}

// Gusts roll a light airplane as fast as gains that are too high would.
TEST(Tuner, is_not_misled_by_gusts_that_swing_a_small_quick_airplane) {
    for (const float gust_rads : {0.6f, 1.0f, 2.0f}) {
        Axis axis{8};
        axis.gust_rads = gust_rads;
        Tuning tuning;
        tuning.roll(axis, 40);
        EXPECT_GT(tuning.measured, 10) << gust_rads;
        EXPECT_EQ(tuning.shaken, 0) << gust_rads;
        EXPECT_NEAR(tuning.feedForward() * axis.strength, 1, 0.25) << gust_rads;
    }
}

TEST(Tuner, learns_nothing_without_rotation) {
    Axis axis{4};
    axis.gust_rads = 0.3f;
    Tuning tuning;
    tuning.hold(axis, 0, 60);
    EXPECT_EQ(tuning.measured + tuning.shaken, 0);
}

TEST(Tuner, learns_nothing_from_a_turn_that_does_not_end) {
    Axis axis{0.05f};
    Tuning tuning;
    tuning.hold(axis, 45 * kDegree, 20);
    EXPECT_EQ(tuning.measured, 0);
}

TEST(Tuner, learns_nothing_below_flying_speed) {
    Axis axis{4};
    axis.speed_mps = 8;
    Tuning tuning;
    tuning.roll(axis, 3);
    EXPECT_EQ(tuning.measured, 0);
}

TEST(Tuner, lowers_gains_that_make_the_airplane_shake) {
    Axis axis{8};
    Tuning tuning;
    tuning.scale(8);
    tuning.hold(axis, 5 * kDegree, 8);
    EXPECT_GT(tuning.shaken, 0);
    const int shaken = tuning.shaken;
    tuning.hold(axis, 5 * kDegree, 8);
    tuning.roll(axis, 4);
    tuning.hold(axis, 5 * kDegree, 8);
    EXPECT_LE(tuning.shaken, shaken + 2) << "until it is calm";
    EXPECT_LT(std::abs(axis.rate), 0.1f);
}

// The nose of a small fast airplane with a strong elevator goes back by itself to where the air
// comes from, twice a second. Gains that keep it swinging are too high, whatever a mean over the
// swings says: surface that holds the nose up against the air is none for a rate.
struct Nose : Axis {
    float alpha = 0;

    Nose() : Axis{29, 0.19f, 0.08f} {}
    void step(float demanded) {
        constexpr float kStiffness_hz2 = 174, kLift_hz = 8;
        Axis::step(demanded);
        alpha += (rate - kLift_hz * alpha) * 0.01f;
        rate -= kStiffness_hz2 * alpha * 0.01f;
    }
};

TEST(Tuner, raises_no_gains_with_which_a_turn_ends_in_swings) {
    Nose nose;
    Tuning tuning;
    tuning.scale(3);
    const float before = tuning.settings.axis.p;
    for (int i = 0; i < 8; ++i) {
        tuning.hold(nose, (i % 2 == 0 ? 20 : -20) * kDegree, 3);
        EXPECT_LT(tuning.settings.axis.p, before) << i;
    }
    EXPECT_GT(tuning.shaken, 0);
    EXPECT_LT(std::abs(nose.rate), 0.1f);
}

TEST(Tuner, changes_the_gains_by_no_more_than_a_quarter_at_once) {
    Axis axis{0.9f};
    Tuning tuning;
    tuning.hold(axis, 0, 1);
    const float before = tuning.settings.axis.p;
    while (tuning.measured == 0 && axis.angle < 3) tuning.roll(axis, 1);
    EXPECT_LE(tuning.settings.axis.p / before, std::pow(1.25f, float(tuning.measured)) + 1e-3f);
}

}  // namespace

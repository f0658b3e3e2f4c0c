// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/attitude.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using control::AirFlow;
using control::AxisState;
using control::Bank;

constexpr float kDegree = 3.14159265f / 180;
constexpr Bank kLevel{0, 1, 1};

AirFlow at(float airspeed_mps, bool too_slow = false) {
    return {control::speedScale(15, 1 / airspeed_mps), airspeed_mps, 1 / airspeed_mps, too_slow,
            0.01f};
}

control::RollSettings roll() { return {{0.5f, 0.4f, 0.04f, 0.02f, 3000}, 0}; }
control::PitchSettings pitch() { return {{0.5f, 0.4f, 0.04f, 0.02f, 3000}, 0, 0, 1.0f}; }

TEST(SpeedScale, is_the_scaling_speed_over_the_airspeed_within_half_and_twice) {
    EXPECT_FLOAT_EQ(control::speedScale(15, 1 / 15.0f), 1.0f);
    EXPECT_FLOAT_EQ(control::speedScale(15, 1 / 10.0f), 1.5f);
    EXPECT_FLOAT_EQ(control::speedScale(15, 1 / 60.0f), 0.5f);
    EXPECT_FLOAT_EQ(control::speedScale(15, 1 / 3.0f), 2.0f);
}

TEST(Roll, p_degrees_of_surface_answer_a_degree_of_angle_at_the_scaling_speed) {
    AxisState state;
    auto settings = roll();
    settings.axis.i = 0;

    // feed-forward (P*T - D) of the rate E/T, and D of it: P*E in all, of 45 degrees
    const float deflection = rollDeflection(settings, state, at(15), 10 * kDegree, 0);
    EXPECT_NEAR(deflection, 0.4f * 10 / 45, 1e-4);
}

TEST(Roll, rate_is_damped) {
    AxisState state;
    auto settings = roll();
    settings.axis.i = 0;

    EXPECT_NEAR(rollDeflection(settings, state, at(15), 0, 90 * kDegree), -0.02f * 90 / 45, 1e-4);
    EXPECT_NEAR(rollDeflection(settings, state, at(10), 0, 90 * kDegree),
                -0.02f * 90 / 45 * 1.5f * 1.5f, 1e-4);
}

TEST(Roll, the_demanded_rate_is_limited_when_a_limit_is_set) {
    AxisState free, limited;
    auto settings = roll();
    const float without = rollDeflection(settings, free, at(15), 60 * kDegree, 0);
    settings.rate_max_dps = 60;
    const float with = rollDeflection(settings, limited, at(15), 60 * kDegree, 0);

    EXPECT_NEAR(with / without, 0.5f, 1e-3);
    EXPECT_NEAR(rollDeflection(settings, limited, at(15), -60 * kDegree, 0), -with, 1e-3);
}

TEST(Roll, the_integrator_takes_a_lasting_error_away_and_stays_within_its_limit) {
    AxisState state;
    auto settings = roll();
    settings.axis.i = 0.2f;
    settings.axis.integrator_max_cd = 900;
    for (int i = 0; i < 100; ++i) rollDeflection(settings, state, at(15), 5 * kDegree, 0);
    EXPECT_NEAR(state.integrator, 0.2f * 5 / 45, 2e-3);
    for (int i = 0; i < 5000; ++i) rollDeflection(settings, state, at(15), 5 * kDegree, 0);
    EXPECT_FLOAT_EQ(state.integrator, 0.2f);
}

TEST(Roll, the_integrator_does_not_wind_up_behind_a_full_surface) {
    AxisState state;
    auto settings = roll();
    settings.axis.integrator_max_cd = 4500;
    for (int i = 0; i < 1000; ++i) {
        const float deflection = rollDeflection(settings, state, at(15), 170 * kDegree, 0);
        ASSERT_LE(deflection, 1.0f);
    }
    EXPECT_LT(state.integrator, 0.05f);
    rollDeflection(settings, state, at(15), -30 * kDegree, 0);
    const float before = state.integrator;
    rollDeflection(settings, state, at(15), -30 * kDegree, 0);
    EXPECT_LT(state.integrator, before) << "and it comes back at once";
}

TEST(Roll, the_integrator_rests_below_flying_speed) {
    AxisState state;
    for (int i = 0; i < 500; ++i) rollDeflection(roll(), state, at(4, true), 20 * kDegree, 0);
    EXPECT_FLOAT_EQ(state.integrator, 0);
}

TEST(Pitch, up_and_down_rates_have_limits_of_their_own) {
    auto settings = pitch();
    settings.axis.i = 0;
    settings.rate_max_up_dps = 10;
    settings.rate_max_down_dps = 5;
    AxisState up, down;
    const float raise = pitchDeflection(settings, up, at(15), kLevel, 1, 0);
    const float lower = pitchDeflection(settings, down, at(15), kLevel, -1, 0);

    EXPECT_NEAR(raise / lower, -2, 1e-3);
}

TEST(Pitch, a_turn_adds_the_rate_that_holds_the_nose_on_the_horizon) {
    auto settings = pitch();
    settings.axis.i = 0;
    const float bank = 45 * kDegree;
    const Bank banked{std::sin(bank), std::cos(bank), 1};
    const float turn_rads = 9.80665f / 15 * std::tan(bank) * std::sin(bank);
    AxisState one, two, three;

    // at exactly that rate there is nothing to correct: feed-forward is all
    const float feed_forward = 0.4f * 0.5f - 0.02f;
    EXPECT_NEAR(pitchDeflection(settings, one, at(15), banked, 0, turn_rads),
                feed_forward * turn_rads * 4 / 3.14159265f, 1e-4);
    const Bank other_way{-std::sin(bank), std::cos(bank), 1};
    EXPECT_GT(pitchDeflection(settings, two, at(15), other_way, 0, 0), 0);
    const Bank inverted{0.1f, -0.9f, 1};
    EXPECT_FLOAT_EQ(pitchDeflection(settings, three, at(15), inverted, 0, 0), 0);
}

TEST(Yaw, a_coordinated_turn_needs_no_rudder_and_a_swing_is_damped) {
    const control::YawSettings settings{0, 0, 0.3f, 1, 1500};
    const float bank = 30 * kDegree;
    const Bank banked{std::sin(bank), std::cos(bank), 1};
    const float turn_rads = 9.80665f / 12 * std::sin(bank);
    control::YawState state;

    EXPECT_NEAR(yawDeflection(settings, state, at(12), banked, turn_rads, 0), 0, 1e-6);
    EXPECT_LT(yawDeflection(settings, state, at(12), banked, turn_rads + 0.3f, 0), -0.05f);
}

TEST(Yaw, what_lasts_is_not_damped) {
    const control::YawSettings settings{0, 0, 0.5f, 1, 1500};
    control::YawState state;
    const float first = yawDeflection(settings, state, at(12), kLevel, 0.2f, 0);
    float last = first;
    for (int i = 0; i < 3000; ++i) last = yawDeflection(settings, state, at(12), kLevel, 0.2f, 0);

    EXPECT_LT(first, -0.05f);
    EXPECT_GT(last, first * 0.01f);
}

TEST(Yaw, the_nose_is_turned_into_the_slip) {
    const control::YawSettings settings{1, 0, 0, 1, 1500};
    control::YawState state;

    EXPECT_LT(yawDeflection(settings, state, at(12), kLevel, 0, 3.0f), 0);
}

}  // namespace

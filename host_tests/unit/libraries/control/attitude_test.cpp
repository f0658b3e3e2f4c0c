// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/attitude.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using control::AirFlow;
using control::AxisState;

constexpr float kDegree = 3.14159265f / 180;
constexpr control::TurnRates kStraight{core::BodyRate(0), core::BodyRate(0)};
constexpr uint8_t kPeriods = 2;
constexpr float kSteps = 2e-4f;  // what the fixed point of gains and rates loses

float integrator(const AxisState& state) { return state.integrator.toFloat(); }

AirFlow at(float airspeed_mps) { return control::airFlow(15, airspeed_mps, airspeed_mps < 9); }

float deflect(const control::RollSettings& settings, AxisState& state, const AirFlow& air,
              float error_rad, float rate_rads) {
    return rollDeflection(rollGains(settings), state, air, core::Angle(error_rad),
                          core::BodyRate(rate_rads), kPeriods)
        .toFloat();
}
float deflect(const control::PitchSettings& settings, AxisState& state, const AirFlow& air,
              const control::TurnRates& turn, float error_rad, float rate_rads) {
    return pitchDeflection(pitchGains(settings), state, air, turn, core::Angle(error_rad),
                           core::BodyRate(rate_rads), kPeriods)
        .toFloat();
}

control::RollSettings roll() { return {{0.5f, 0.4f, 0.04f, 0.02f, 3000}, 0}; }
control::PitchSettings pitch() { return {{0.5f, 0.4f, 0.04f, 0.02f, 3000}, 0, 0, 1.0f}; }

TEST(AirFlow, scales_by_the_scaling_speed_over_the_airspeed_within_half_and_twice) {
    EXPECT_FLOAT_EQ(at(15).speed_scale.toFloat(), 1.0f);
    EXPECT_FLOAT_EQ(at(10).speed_scale.toFloat(), 1.5f);
    EXPECT_FLOAT_EQ(at(60).speed_scale.toFloat(), 0.5f);
    EXPECT_NEAR(at(3).speed_scale.toFloat(), 2.0f, 1e-4);
    EXPECT_FLOAT_EQ(at(0).inverse_airspeed_spm, 1 / 3.0f);
    EXPECT_TRUE(at(8.9f).integrators_rest);
    EXPECT_FALSE(at(9).integrators_rest);
}

TEST(Roll, p_degrees_of_surface_answer_a_degree_of_angle_at_the_scaling_speed) {
    AxisState state;
    auto settings = roll();
    settings.axis.i = 0;

    // feed-forward (P*T - D) of the rate E/T, and D of it: P*E in all, of 45 degrees
    const float deflection = deflect(settings, state, at(15), 10 * kDegree, 0);
    EXPECT_NEAR(deflection, 0.4f * 10 / 45, kSteps);
}

TEST(Roll, rate_is_damped) {
    AxisState state;
    auto settings = roll();
    settings.axis.i = 0;

    EXPECT_NEAR(deflect(settings, state, at(15), 0, 90 * kDegree), -0.02f * 90 / 45, kSteps);
    EXPECT_NEAR(deflect(settings, state, at(10), 0, 90 * kDegree), -0.02f * 90 / 45 * 1.5f * 1.5f,
                2 * kSteps);
}

TEST(Roll, the_demanded_rate_is_limited_when_a_limit_is_set) {
    AxisState free, limited;
    auto settings = roll();
    const float without = deflect(settings, free, at(15), 60 * kDegree, 0);
    settings.rate_max_dps = 60;
    const float with = deflect(settings, limited, at(15), 60 * kDegree, 0);

    EXPECT_NEAR(with / without, 0.5f, 1e-3);
    EXPECT_NEAR(deflect(settings, limited, at(15), -60 * kDegree, 0), -with, 1e-3);
}

// All the way from bank to bank the ailerons would stand at their stop.
TEST(Roll, is_not_asked_for_a_rate_beyond_what_most_of_the_surface_gives) {
    auto settings = roll();
    settings.axis = {0.4f, 3, 0, 0.12f, 3000};  // of wings that turn by 50 degrees a second
    const auto most = [&](float airspeed_mps) {
        AxisState state;
        auto gains = rollGains(settings);
        gains.most_up_rads = gains.most_down_rads =
            control::fastestRate_rads(gains, at(airspeed_mps), settings.rate_max_dps);
        const auto held_rads = demandedRate_rads(gains, core::Angle(90 * kDegree));
        EXPECT_EQ(demandedRate_rads(gains, core::Angle(-90 * kDegree)).raw, -held_rads.raw);
        return rollDeflection(gains, state, at(airspeed_mps), core::Angle(90 * kDegree), held_rads,
                              kPeriods)
            .toFloat();
    };
    for (const float airspeed_mps : {10.0f, 15.0f, 25.0f})
        EXPECT_NEAR(most(airspeed_mps), 0.95f, 0.01f) << airspeed_mps;
}

TEST(Roll, keeps_the_limit_that_is_set_where_the_surface_gives_more) {
    const auto gains = rollGains(roll());
    EXPECT_NEAR(control::fastestRate_rads(gains, at(15), 60).toFloat(), 60 * kDegree, 0.01f);
    EXPECT_GT(control::fastestRate_rads(gains, at(15), 0).toFloat(), 90 * kDegree);
    EXPECT_GT(control::fastestRate_rads(gains, AirFlow(), 60).toFloat(), 0) << "before it is known";
}

TEST(Roll, the_integrator_takes_a_lasting_error_away_and_stays_within_its_limit) {
    AxisState state;
    auto settings = roll();
    settings.axis.i = 0.2f;
    settings.axis.integrator_max_cd = 900;
    for (int i = 0; i < 100; ++i) deflect(settings, state, at(15), 5 * kDegree, 0);
    EXPECT_NEAR(integrator(state), 0.2f * 5 / 45, 2e-3);
    for (int i = 0; i < 5000; ++i) deflect(settings, state, at(15), 5 * kDegree, 0);
    EXPECT_NEAR(integrator(state), 0.2f, kSteps);
}

TEST(Roll, the_integrator_does_not_wind_up_behind_a_full_surface) {
    AxisState state;
    auto settings = roll();
    settings.axis.integrator_max_cd = 4500;
    for (int i = 0; i < 1000; ++i) {
        const float deflection = deflect(settings, state, at(15), 170 * kDegree, 0);
        ASSERT_LE(deflection, 1.0f);
    }
    EXPECT_LT(integrator(state), 0.05f);
    deflect(settings, state, at(15), -30 * kDegree, 0);
    const float before = integrator(state);
    deflect(settings, state, at(15), -30 * kDegree, 0);
    EXPECT_LT(integrator(state), before) << "and it comes back at once";
}

TEST(Roll, the_integrator_rests_below_flying_speed) {
    AxisState state;
    for (int i = 0; i < 500; ++i) deflect(roll(), state, at(4), 20 * kDegree, 0);
    EXPECT_FLOAT_EQ(integrator(state), 0);
}

TEST(Pitch, up_and_down_rates_have_limits_of_their_own) {
    auto settings = pitch();
    settings.axis.i = 0;
    settings.rate_max_up_dps = 10;
    settings.rate_max_down_dps = 5;
    AxisState up, down;
    const float raise = deflect(settings, up, at(15), kStraight, 1, 0);
    const float lower = deflect(settings, down, at(15), kStraight, -1, 0);

    EXPECT_NEAR(raise / lower, -2, 1e-2);
}

TEST(Pitch, a_turn_adds_the_rate_that_holds_the_nose_on_the_horizon) {
    auto settings = pitch();
    settings.axis.i = 0;
    const float bank = 45 * kDegree;
    const auto turn = turnRates(at(15), std::sin(bank), std::cos(bank), 1);
    EXPECT_NEAR(turn.pitch_rads.toFloat(), 9.80665f / 15 * std::tan(bank) * std::sin(bank), 1e-3);
    AxisState state;

    // at exactly that rate there is nothing to correct: feed-forward is all
    const float feed_forward = 0.4f * 0.5f - 0.02f;
    EXPECT_NEAR(deflect(settings, state, at(15), turn, 0, turn.pitch_rads.toFloat()),
                feed_forward * turn.pitch_rads.toFloat() * 4 / 3.14159265f, 1e-4);
    EXPECT_FLOAT_EQ(turnRates(at(15), -std::sin(bank), std::cos(bank), 1).pitch_rads.toFloat(),
                    turn.pitch_rads.toFloat());
    EXPECT_FLOAT_EQ(turnRates(at(15), 0.1f, -0.9f, 1).pitch_rads.toFloat(), 0) << "inverted";
}

float yawFor(const control::YawSettings& settings, control::YawState& state,
             const control::TurnRates& turn, float rate_rads, float lateral_mss = 0,
             float airspeed_mps = 12) {
    return yawDeflection(control::yawGains(settings), state, at(airspeed_mps), turn,
                         core::BodyRate(rate_rads), core::Acceleration(lateral_mss), kPeriods)
        .toFloat();
}

TEST(Yaw, a_coordinated_turn_needs_no_rudder_and_a_swing_is_damped) {
    const control::YawSettings settings{0, 0, 0.3f, 1, 1500};
    const float bank = 30 * kDegree;
    const auto turn = turnRates(at(12), std::sin(bank), std::cos(bank), 1);
    const float turn_rads = 9.80665f / 12 * std::sin(bank);
    control::YawState state;

    EXPECT_NEAR(yawFor(settings, state, turn, turn_rads), 0, 1e-3);
    EXPECT_NEAR(yawFor(settings, state, turn, turn_rads + 0.3f), -0.3f * 0.3f * 1.25f * 1.25f,
                2e-3);
}

TEST(Yaw, a_steady_rate_is_not_damped) {
    const control::YawSettings settings{0, 0, 0.5f, 1, 1500};
    control::YawState state;
    const float first = yawFor(settings, state, kStraight, 0.2f);
    float last = first;
    for (int i = 0; i < 3000; ++i) last = yawFor(settings, state, kStraight, 0.2f);

    EXPECT_LT(first, -0.05f);
    EXPECT_NEAR(last, 0, 1e-3);
}

TEST(Yaw, damping_stays_within_what_the_rudder_can_at_any_rate) {
    const control::YawSettings settings{0, 0, 2, 1, 1500};
    for (const float rate_rads : {-31.9f, -30.0f, -8.1f, 8.1f, 30.0f, 31.9f})
        for (const float airspeed_mps : {0.0f, 7.5f, 12.0f}) {
            control::YawState state;
            EXPECT_EQ(yawFor(settings, state, kStraight, rate_rads, 0, airspeed_mps),
                      rate_rads > 0 ? -1 : 1);
        }
}

TEST(Yaw, the_nose_is_turned_into_the_slip) {
    const control::YawSettings settings{1, 0, 0, 1, 1500};
    control::YawState state;

    EXPECT_LT(yawFor(settings, state, kStraight, 0, 3.0f), 0);
}

TEST(Yaw, a_lasting_slip_is_gathered_as_far_as_its_limit) {
    const control::YawSettings settings{0, 1, 0, 1, 1500};
    control::YawState state;
    EXPECT_NEAR(yawFor(settings, state, kStraight, 0, 3.0f), 0, 1e-3);
    float last = 0;
    for (int i = 0; i < 3000; ++i) last = yawFor(settings, state, kStraight, 0, 3.0f);
    EXPECT_NEAR(last, -1500.0f / 4500, 1e-3);
}

}  // namespace

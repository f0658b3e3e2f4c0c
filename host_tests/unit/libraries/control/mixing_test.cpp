// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/mixing.hpp"

#include <gtest/gtest.h>

#include "control/slew.hpp"

namespace {

using control::Pair;
using control::Side;
using control::surfacePulse_us;
using control::throttlePulse_us;
using core::Ratio;

struct ServoRange {
    int16_t min_us, trim_us, max_us;
    int8_t reverse;
};
constexpr ServoRange kServo{1100, 1450, 1900, 1};
constexpr ServoRange kReversed{1100, 1450, 1900, -1};

TEST(Servo, each_side_of_the_trim_has_its_own_scale) {
    const struct {
        float deflection;
        uint16_t pulse_us;
    } cases[] = {{-1, 1100}, {-0.5f, 1275}, {0, 1450}, {0.5f, 1675}, {1, 1900}};
    for (const auto& c : cases)
        EXPECT_EQ(surfacePulse_us(kServo, Ratio(c.deflection)), c.pulse_us) << c.deflection;
}

TEST(Servo, a_reversed_one_moves_the_other_way_within_the_same_ends) {
    EXPECT_EQ(surfacePulse_us(kReversed, Ratio(1)), 1100);
    EXPECT_EQ(surfacePulse_us(kReversed, Ratio(0)), 1450);
    EXPECT_EQ(surfacePulse_us(kReversed, Ratio(-1)), 1900);
}

TEST(Servo, no_demand_exceeds_its_ends) {
    EXPECT_EQ(surfacePulse_us(kServo, Ratio(7)), 1900);
    EXPECT_EQ(surfacePulse_us(kServo, Ratio(-7)), 1100);
    const ServoRange trimmed_beyond{1100, 2000, 1900, 1};
    EXPECT_EQ(surfacePulse_us(trimmed_beyond, Ratio(0)), 1900);
}

TEST(Throttle, lies_between_the_ends_without_a_trim) {
    EXPECT_EQ(throttlePulse_us(kServo, Ratio(0)), 1100);
    EXPECT_EQ(throttlePulse_us(kServo, Ratio(0.5f)), 1500);
    EXPECT_EQ(throttlePulse_us(kServo, Ratio(1.5f)), 1900);
    EXPECT_EQ(throttlePulse_us(kReversed, Ratio(0)), 1900);
    EXPECT_EQ(throttlePulse_us(kReversed, Ratio(1)), 1100);
}

constexpr float kStep = 1.5f / Ratio::kSteps;  // the inputs are rounded, too

TEST(Pair, moves_both_for_the_common_control_and_apart_for_the_other) {
    const struct {
        Pair kind;
        float common, apart, left, right;
    } cases[] = {
        {Pair::up_up, 0.4f, 0, 0.2f, 0.2f},      {Pair::up_up, 0, 0.4f, 0.2f, -0.2f},
        {Pair::up_down, 0.4f, 0, 0.2f, -0.2f},   {Pair::down_up, 0.4f, 0, -0.2f, 0.2f},
        {Pair::down_down, 0.4f, 0.4f, -0.4f, 0}, {Pair::none, 1, 1, 0, 0},
    };
    for (const auto& c : cases) {
        const auto of = [&](Side side) {
            return mixPair(c.kind, side, Ratio(c.common), Ratio(c.apart), Ratio(0.5f)).toFloat();
        };
        EXPECT_NEAR(of(Side::left), c.left, kStep);
        EXPECT_NEAR(of(Side::right), c.right, kStep);
    }
}

TEST(Pair, pitch_comes_first_when_there_is_not_enough_surface_for_both) {
    const auto of = [](Side side) {
        return mixPair(Pair::up_up, side, Ratio(0.8f), Ratio(1), Ratio(1)).toFloat();
    };
    EXPECT_NEAR((of(Side::left) + of(Side::right)) / 2, 0.8f, kStep);
    EXPECT_NEAR(of(Side::left), 1, kStep);
}

TEST(Pair, controls_past_their_ends_with_the_largest_gain_stay_at_the_ends) {
    for (const float common : {-1.9f, 1.9f})
        for (const Side side : {Side::left, Side::right})
            EXPECT_EQ(
                mixPair(Pair::up_up, side, Ratio(common), Ratio(-common), Ratio(1.2f)).toFloat(),
                common < 0 ? -1 : 1);
}

TEST(Slew, goes_no_faster_than_it_may_and_does_not_pass) {
    EXPECT_FLOAT_EQ(control::slewed(0, 1, 0.1f), 0.1f);
    EXPECT_FLOAT_EQ(control::slewed(0, -1, 0.1f), -0.1f);
    EXPECT_FLOAT_EQ(control::slewed(0, 0.05f, 0.1f), 0.05f);
}

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/builtin_model.hpp"

#include <gtest/gtest.h>

using namespace simulator;

namespace {

ServoPulses pulses(std::array<double, 8> standing_us) { return {standing_us, standing_us}; }

constexpr double kMiddle = 1500, kRest = 0;

}  // namespace

TEST(ControlsOf, an_airplane_with_a_servo_a_control_are_outputs_1_to_4) {
    const Controls now = BuiltinModel::controlsOf(
        pulses({1900, 1300, 1500, 1600, 1900, 1900, kRest, kRest}), AirplaneParameters{});
    EXPECT_DOUBLE_EQ(now.aileron, 1);
    EXPECT_DOUBLE_EQ(now.elevator, -0.5);
    EXPECT_DOUBLE_EQ(now.throttle, 0.5);
    EXPECT_DOUBLE_EQ(now.rudder, 0.25);
    EXPECT_DOUBLE_EQ(now.flap, 0);
}

TEST(ControlsOf, elevons_are_half_their_difference_and_half_their_sum) {
    AirplaneParameters wing;
    wing.elevons = true;
    const Controls now = BuiltinModel::controlsOf(
        pulses({1900, 1500, 1100, 1900, kMiddle, kMiddle, kRest, kRest}), wing);
    EXPECT_DOUBLE_EQ(now.aileron, 0.5);
    EXPECT_DOUBLE_EQ(now.elevator, 0.5);
    EXPECT_DOUBLE_EQ(now.rudder, 0) << "it has none";
}

TEST(ControlsOf, a_v_tail_pitches_with_both_servos_and_yaws_with_one_against_the_other) {
    AirplaneParameters airplane;
    airplane.v_tail = true;
    const auto tail = [&](double second_us, double fourth_us) {
        return BuiltinModel::controlsOf(
            pulses({kMiddle, second_us, 1100, fourth_us, kMiddle, kMiddle, kRest, kRest}),
            airplane);
    };
    EXPECT_DOUBLE_EQ(tail(1700, 1700).elevator, 0.5);
    EXPECT_DOUBLE_EQ(tail(1700, 1700).rudder, 0);
    EXPECT_DOUBLE_EQ(tail(1300, 1700).elevator, 0);
    EXPECT_DOUBLE_EQ(tail(1300, 1700).rudder, 0.5);
}

TEST(ControlsOf, flaperons_roll_apart_and_go_down_together) {
    AirplaneParameters airplane;
    airplane.flaperons = true;
    const auto wing = [&](double left_us, double right_us) {
        return BuiltinModel::controlsOf(
            pulses({1900, kMiddle, 1100, kMiddle, left_us, right_us, kRest, kRest}), airplane);
    };
    EXPECT_DOUBLE_EQ(wing(1700, 1300).aileron, 0.5) << "output 1 moves nothing";
    EXPECT_DOUBLE_EQ(wing(1700, 1300).flap, 0);
    EXPECT_DOUBLE_EQ(wing(1900, 1500).aileron, 0.5);
    EXPECT_DOUBLE_EQ(wing(1900, 1500).flap, 0.5);
    EXPECT_DOUBLE_EQ(wing(1300, 1300).flap, 0) << "both up are no flap";
}

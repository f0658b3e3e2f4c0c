// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/autotune.hpp"

#include <cmath>

#include "control/attitude.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;

class Autotune : public bench::Bench {
protected:
    control::Swing swing;

    void enter(int8_t level) {
        parameters.autotune_level = level;
        fly(Mode::autotune);
        mutable_vehicle.attitude.cos_roll = core::Ratio(1.0f);
        for (int i = 0; i < 10; ++i) firmware::control::tuneStep();
    }
    // From rest to rest through `rate`, with a surface that is so many times what is expected.
    void turn(firmware::control::TunedAxis which, float times) {
        const auto gains = which == firmware::control::kTunedRoll
                               ? control::rollGains(parameters.roll)
                               : control::pitchGains(parameters.pitch);
        const auto air = control::airFlow(15, 15, false);
        for (int i = 0; i <= 60; ++i) {
            const float rate_rads = 1.2f * std::sin(3.14159265f * static_cast<float>(i) / 60);
            control::AxisState state;
            state.last_output.raw =
                static_cast<int32_t>(times * gains.feed_forward.toFloat() * rate_rads * (1 << 20));
            const core::Angle error(i < 60 ? 0.6f : 0.0f);
            firmware::control::tune(which, gains, state, air, error, core::BodyRate(rate_rads),
                                    swing);
        }
        for (int i = 0; i < 10; ++i) firmware::control::tuneStep();
    }
};

TEST_F(Autotune, leaves_gains_alone_whose_time_constant_is_the_levels) {
    parameters.roll.axis.time_constant_s = parameters.pitch.axis.time_constant_s = 0.4f;
    parameters.roll.axis.p = 2;
    const firmware::state::Parameters before = parameters;
    enter(6);
    EXPECT_EQ(parameters.roll.axis.p, before.roll.axis.p);
    EXPECT_EQ(parameters.roll.axis.time_constant_s, before.roll.axis.time_constant_s);
    EXPECT_EQ(parameters.pitch.axis.p, before.pitch.axis.p);
}

TEST_F(Autotune, scales_the_gains_of_the_axis_that_turned) {
    enter(0);
    const firmware::state::Parameters before = parameters;
    turn(firmware::control::kTunedRoll, 1.2f);
    EXPECT_NEAR(parameters.roll.axis.p, before.roll.axis.p * 1.2f, 0.02f);
    EXPECT_NEAR(parameters.roll.axis.i, before.roll.axis.i * 1.2f, 0.002f);
    EXPECT_NEAR(parameters.roll.axis.d, before.roll.axis.d * 1.2f, 0.002f);
    EXPECT_EQ(parameters.pitch.axis.p, before.pitch.axis.p);
    turn(firmware::control::kTunedPitch, 0.5f);
    EXPECT_NEAR(parameters.pitch.axis.p, before.pitch.axis.p * 0.8f, 0.01f) << "a fifth at most";
}

TEST_F(Autotune, does_not_tune_the_elevator_in_a_turn) {
    enter(0);
    const firmware::state::Parameters before = parameters;
    mutable_vehicle.attitude.cos_roll = core::Ratio(0.8f);
    turn(firmware::control::kTunedPitch, 1.2f);
    EXPECT_EQ(parameters.pitch.axis.p, before.pitch.axis.p);
}

TEST_F(Autotune, sets_the_time_constants_and_moves_the_surface_as_far_for_a_rate_as_before) {
    const firmware::state::Parameters before = parameters;
    enter(9);
    EXPECT_FLOAT_EQ(parameters.roll.axis.time_constant_s, 0.25f);
    EXPECT_FLOAT_EQ(parameters.pitch.axis.time_constant_s, 0.25f);
    EXPECT_NEAR(control::rollGains(parameters.roll).feed_forward.toFloat(),
                control::rollGains(before.roll).feed_forward.toFloat(), 1e-3f);
    EXPECT_NEAR(control::pitchGains(parameters.pitch).feed_forward.toFloat(),
                control::pitchGains(before.pitch).feed_forward.toFloat(), 1e-3f);
}

TEST_F(Autotune, stops_at_the_ends_of_the_parameters) {
    enter(0);
    for (int i = 0; i < 30; ++i) turn(firmware::control::kTunedRoll, 1.25f);
    EXPECT_LE(parameters.roll.axis.p, 4);
    EXPECT_LE(parameters.roll.axis.d, 0.2f);
    for (int i = 0; i < 30; ++i) turn(firmware::control::kTunedRoll, 1.25f);
    EXPECT_LE(parameters.roll.axis.p, 4);
}

TEST_F(Autotune, stops_where_a_small_quick_airplane_has_its_gains) {
    enter(0);
    for (int i = 0; i < 40; ++i) turn(firmware::control::kTunedRoll, 0.1f);
    EXPECT_NEAR(parameters.roll.axis.p, 0.2f, 0.002f);
    for (int i = 0; i < 30; ++i) turn(firmware::control::kTunedRoll, 1.25f);
    EXPECT_GT(parameters.roll.axis.p, 1) << "and comes back from there";
}

TEST_F(Autotune, changes_nothing_in_another_mode) {
    enter(0);
    const firmware::state::Parameters before = parameters;
    fly(Mode::fbwa);
    for (int i = 0; i < 10; ++i) firmware::control::tuneStep();
    EXPECT_EQ(parameters.roll.axis.p, before.roll.axis.p);
}

}  // namespace

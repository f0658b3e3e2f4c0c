// SPDX-License-Identifier: GPL-3.0-or-later
// An airplane whose ailerons are stronger than the gains are made for.
#include "firmware/control/oscillation.hpp"

#include <deque>

#include "firmware/control/attitude_control.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::control::surfaces;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

class Oscillation : public bench::Bench {
protected:
    static constexpr float kStrong_rads = 20, kUsual_rads = 3;  // for all of the aileron

    void SetUp() override {
        Bench::SetUp();
        mutable_vehicle.imu.periods = 2;
        mutable_vehicle.estimate.equivalent_airspeed_mps = parameters.scaling_speed_mps;
        mutable_vehicle.airspeed.healthy = true;
        mutable_vehicle.attitude.cos_roll = mutable_vehicle.attitude.cos_pitch = core::Ratio(1.0f);
        fly(Mode::fbwa);
    }
    // A tenth of a second from the loop to the air, and as long again for the roll to follow.
    void hold(float strength_rads, float seconds, float roll_rad = 0.3f) {
        float rate_rads = 0, widest_rad = 0;
        std::deque<float> on_the_way(10, 0.0f);
        for (int frame = 0; frame < seconds * 100; ++frame) {
            rate_rads += (on_the_way.front() * strength_rads - rate_rads) * 0.1f;
            roll_rad = core::limit(roll_rad + rate_rads * 0.01f, -1.2f, 1.2f);
            mutable_vehicle.attitude.roll_rad = core::Angle(roll_rad);
            mutable_vehicle.attitude.rate_rads = core::BodyRates::from(rate_rads, 0, 0);
            if (frame % 5 == 0) prepareControl();
            firmware::control::runAttitudeControl();
            on_the_way.pop_front();
            on_the_way.push_back(surfaces.aileron.toFloat());
            if (frame >= (seconds - 1) * 100)
                widest_rad = std::max(widest_rad, std::fabs(roll_rad));
        }
        swings_by_rad = widest_rad;
    }
    // What a bank of 0.1 rad at rest takes of the aileron.
    float gain() {
        mutable_vehicle.attitude.roll_rad = core::Angle(0.1f);
        mutable_vehicle.attitude.rate_rads = core::BodyRates::from(0, 0, 0);
        prepareControl();
        ++mutable_vehicle.mode_entries;  // no integrator
        firmware::control::runAttitudeControl();
        return -surfaces.aileron.toFloat();
    }

    float swings_by_rad = 0;  // in the last second
};

TEST_F(Oscillation, ends_with_weaker_gains) {
    const float before = gain();
    hold(kStrong_rads, 8);
    EXPECT_LT(swings_by_rad, 0.1f);
    EXPECT_LT(gain(), 0.61f * before);
    EXPECT_GT(gain(), 0.2f * before);
}

TEST_F(Oscillation, is_not_what_an_airplane_does_whose_gains_fit) {
    const float before = gain();
    for (int i = 0; i < 5; ++i) hold(kUsual_rads, 2, i % 2 == 0 ? 0.7f : -0.7f);
    EXPECT_EQ(gain(), before);
}

TEST_F(Oscillation, leaves_a_fifth_at_least) {
    const float before = gain();
    hold(1000, 30);
    EXPECT_NEAR(gain(), 0.216f * before, 0.01f * before);
}

TEST_F(Oscillation, by_the_pilots_own_stick_changes_nothing) {
    const float before = gain();
    mutable_vehicle.radio.roll_cd = 2000;
    hold(kStrong_rads, 8);
    mutable_vehicle.radio.roll_cd = 0;
    EXPECT_EQ(gain(), before);
}

TEST_F(Oscillation, by_hands_that_shake_it_before_it_flies_changes_nothing) {
    const float before = gain();
    mutable_vehicle.estimate.equivalent_airspeed_mps = 3;
    hold(kStrong_rads, 8);
    mutable_vehicle.estimate.equivalent_airspeed_mps = parameters.scaling_speed_mps;
    EXPECT_EQ(gain(), before);
}

TEST_F(Oscillation, is_remembered_until_it_is_disarmed_whatever_is_set_meanwhile) {
    const float before = gain();
    hold(kStrong_rads, 8);
    const float weaker = gain();
    ++firmware::state::parameter_changes.count;
    EXPECT_EQ(gain(), weaker);
    mutable_vehicle.armed = false;
    gain();
    EXPECT_EQ(gain(), before);
}

TEST_F(Oscillation, gives_autotune_what_is_left_to_begin_with) {
    parameters.autotune_level = 0;
    const float before_p = parameters.roll.axis.p, before = gain();
    hold(kStrong_rads, 8);
    const float weaker = gain() / before;
    fly(Mode::autotune);
    for (int i = 0; i < 10; ++i) {
        prepareControl();
        firmware::control::tuneStep();
    }
    EXPECT_NEAR(parameters.roll.axis.p, before_p * weaker, 0.02f);
    EXPECT_NEAR(gain(), before * weaker, 0.03f * before) << "and not weaker still";
}

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/termination.hpp"

#include "firmware/actuators/outputs.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware/safety/arming.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::actuators::outputPulse_us;
using firmware::safety::ArmReason;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

// In the air in FBWA, with the sticks where they hold it level and the motor running.
struct Termination : bench::Bench {
    void SetUp() override {
        Bench::SetUp();
        firmware::actuators::startOutputs();
        parameters.termination_action = 42;
        firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
        settle(with(3, 1600));
        mutable_vehicle.armed = mutable_vehicle.estimate.flying = true;
        run();
    }
    void run() {
        firmware::modes::runMode();
        prepareControl();
        firmware::control::runAttitudeControl();
        firmware::actuators::runOutputs();
    }
    static void expectTerminated() {
        EXPECT_EQ(outputPulse_us(1), 1900);
        EXPECT_EQ(outputPulse_us(2), 1900);
        EXPECT_EQ(outputPulse_us(3), 1100);
        EXPECT_EQ(outputPulse_us(4), 1900);
        EXPECT_FALSE(vehicle.armed);
    }
};

TEST_F(Termination, stops_the_motor_and_puts_the_surfaces_to_their_ends) {
    ASSERT_GT(outputPulse_us(3), 1300);
    EXPECT_TRUE(firmware::safety::terminateFlight());
    run();
    expectTerminated();
}

TEST_F(Termination, turns_the_surfaces_the_way_that_raises_the_nose_and_rolls_to_the_right) {
    parameters.channel[0].reverse = parameters.channel[1].reverse = -1;
    EXPECT_TRUE(firmware::safety::terminateFlight());
    run();
    EXPECT_EQ(outputPulse_us(1), 1100);
    EXPECT_EQ(outputPulse_us(2), 1100);
    EXPECT_EQ(outputPulse_us(4), 1900);
}

TEST_F(Termination, is_taken_back_by_nobody) {
    EXPECT_TRUE(firmware::safety::terminateFlight());
    for (const Mode mode : {Mode::manual, Mode::fbwa, Mode::rtl}) {
        EXPECT_FALSE(firmware::modes::requestMode(mode, firmware::modes::ModeReason::pilot));
        EXPECT_FALSE(firmware::modes::requestMode(mode, firmware::modes::ModeReason::failsafe));
        settle(with(1, 1100));
        for (int i = 0; i < 100; ++i) run();
        expectTerminated();
    }
    EXPECT_FALSE(firmware::safety::arm(ArmReason::ground, true)) << "not by force either";
    EXPECT_FALSE(firmware::actuators::outputOverride(3, 1900));
    run();
    expectTerminated();
}

TEST_F(Termination, is_refused_unless_the_owner_has_set_it) {
    for (const int8_t action : {0, 1, 41}) {
        parameters.termination_action = action;
        EXPECT_FALSE(firmware::safety::terminateFlight()) << int{action};
        run();
        EXPECT_TRUE(vehicle.armed);
        EXPECT_FALSE(vehicle.terminated);
        EXPECT_GT(outputPulse_us(3), 1300);
    }
}

}  // namespace

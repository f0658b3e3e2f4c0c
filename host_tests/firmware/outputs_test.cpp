// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/outputs.hpp"

#include "firmware/attitude_control.hpp"
#include "firmware/bench.hpp"

namespace {

using firmware::Mode;
using firmware::outputPulse_us;
using firmware::parameters;
using firmware::vehicle;

class Outputs : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        firmware::startOutputs();
        vehicle.mode_changed = false;
    }
    void run() {
        firmware::runMode();
        firmware::runAttitudeControl();
        firmware::runOutputs();
        vehicle.mode_changed = false;
    }
};

TEST_F(Outputs, give_the_throttle_its_lowest_pulse_while_disarmed) {
    for (Mode mode : {Mode::manual, Mode::stabilize, Mode::fbwa}) {
        firmware::setMode(mode, firmware::ModeReason::ground);
        settle(with(3, 1900));
        run();
        ASSERT_EQ(vehicle.throttle_demand, 1);
        EXPECT_EQ(outputPulse_us(3), 1100) << static_cast<int>(mode);
    }
    vehicle.armed = true;
    run();
    EXPECT_EQ(outputPulse_us(3), 1900);
    vehicle.armed = false;
    run();
    EXPECT_EQ(outputPulse_us(3), 1100) << "at once";
}

TEST_F(Outputs, keep_a_reversed_throttle_closed_at_its_longest_pulse) {
    parameters.channel[2].reverse = -1;
    vehicle.throttle_demand = 1;
    run();
    EXPECT_EQ(outputPulse_us(3), 1900);
}

TEST_F(Outputs, pass_the_sticks_through_in_manual) {
    settle({1700, 1350, 1100, 1900, 1500, 1500, 1500, 1815});
    run();
    const float sticks[] = {170 / 370.0f, -120 / 370.0f, 1};  // beyond the dead zone of 30 us
    EXPECT_NEAR(outputPulse_us(1), 1500 + 400 * sticks[0], 1);
    EXPECT_NEAR(outputPulse_us(2), 1500 + 400 * sticks[1], 1);
    EXPECT_NEAR(outputPulse_us(4), 1500 + 400 * sticks[2], 1);
}

// The stick is reversed by the same parameter, so that it moves the surface the same way.
TEST_F(Outputs, move_a_reversed_surface_with_its_stick_and_against_the_demand) {
    parameters.channel[0].reverse = -1;
    settle(with(1, 1700));
    run();
    EXPECT_GT(outputPulse_us(1), 1650) << "the servo goes where the stick goes";
    EXPECT_LT(firmware::surfaces.aileron, -0.4f);
}

TEST_F(Outputs, rest_at_the_trim_and_reach_both_ends_from_there) {
    parameters.channel[1].min_us = 1000;
    parameters.channel[1].trim_us = 1600;
    parameters.channel[1].max_us = 1900;
    settle(with(2, 1600));
    run();
    EXPECT_EQ(outputPulse_us(2), 1600);
    settle(with(2, 1000));
    run();
    EXPECT_EQ(outputPulse_us(2), 1000);
    settle(with(2, 1900));
    run();
    EXPECT_EQ(outputPulse_us(2), 1900);
}

TEST_F(Outputs, follow_the_receiver_where_nobody_holds_them) {
    settle(with(6, 1234));
    run();
    EXPECT_EQ(outputPulse_us(6), 1234);
}

TEST_F(Outputs, belong_to_who_holds_them_until_the_mode_changes) {
    ASSERT_TRUE(firmware::outputOverride(6, 1850));
    settle(with(6, 1200));
    run();
    EXPECT_EQ(outputPulse_us(6), 1850) << "though the receiver says otherwise";

    firmware::setMode(Mode::fbwa, firmware::ModeReason::ground);
    run();
    EXPECT_EQ(outputPulse_us(6), 1200);
}

TEST_F(Outputs, can_be_released_one_by_one) {
    ASSERT_TRUE(firmware::outputOverride(6, 1850));
    ASSERT_TRUE(firmware::outputOverride(7, 0));
    firmware::outputRelease(6);
    run();
    EXPECT_EQ(outputPulse_us(6), 1500);
    EXPECT_EQ(outputPulse_us(7), 0) << "silent on request";
}

TEST_F(Outputs, hold_no_pulse_a_servo_cannot_take) {
    ASSERT_TRUE(firmware::outputOverride(5, 3000));
    ASSERT_TRUE(firmware::outputOverride(8, 1));
    run();
    EXPECT_EQ(outputPulse_us(5), 2200);
    EXPECT_EQ(outputPulse_us(8), 800);
}

TEST_F(Outputs, give_away_surfaces_too_but_nothing_that_is_not_there) {
    run();
    for (uint8_t output : {1, 2, 4}) {
        EXPECT_TRUE(firmware::outputOverride(output, 1850)) << int{output};
        run();
        EXPECT_EQ(outputPulse_us(output), 1850);
        firmware::outputRelease(output);
        run();
        EXPECT_EQ(outputPulse_us(output), 1500);
    }
    for (uint8_t output : {0, 9, 255}) {
        EXPECT_FALSE(firmware::outputOverride(output, 1850)) << int{output};
        firmware::outputRelease(output);
        EXPECT_EQ(outputPulse_us(output), 0);
    }
}

TEST_F(Outputs, the_throttle_is_given_away_only_while_disarmed) {
    ASSERT_TRUE(firmware::outputOverride(3, 1300));
    run();
    EXPECT_EQ(outputPulse_us(3), 1300);
    firmware::vehicle.armed = true;
    run();
    EXPECT_NE(outputPulse_us(3), 1300) << "arming takes it back";
    EXPECT_FALSE(firmware::outputOverride(3, 1300));
    firmware::vehicle.armed = false;
    run();
    EXPECT_EQ(outputPulse_us(3), 1100) << "and it stays back";
}

TEST_F(Outputs, are_written_only_when_they_change) {
    run();
    const uint32_t writes = fakes::servos().writes;
    run();
    EXPECT_EQ(fakes::servos().writes, writes);
    settle(with(1, 1700));
    run();
    EXPECT_EQ(fakes::servos().writes, writes + 1);
}

}  // namespace

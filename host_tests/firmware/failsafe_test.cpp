// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/failsafe.hpp"

#include "firmware/bench.hpp"

namespace {

using firmware::Mode;
using firmware::parameters;
using firmware::vehicle;

constexpr uint32_t kShort_ms = 1500;
constexpr uint32_t kLong_ms = 7000;

struct Failsafe : bench::Bench {};

TEST_F(Failsafe, circles_at_once_and_returns_home_after_the_long_time) {
    fly(Mode::fbwa);
    loseRadio(kShort_ms);
    EXPECT_EQ(vehicle.mode, Mode::circle);
    EXPECT_TRUE(vehicle.failsafe_short);
    loseRadio(kLong_ms);
    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_TRUE(vehicle.failsafe_long);
}

TEST_F(Failsafe, gives_back_the_mode_when_the_radio_is_back_in_time) {
    fly(Mode::fbwa);
    loseRadio(kShort_ms);
    ASSERT_EQ(vehicle.mode, Mode::circle);

    settle(with(8, 1425));
    firmware::runFailsafe();

    EXPECT_EQ(vehicle.mode, Mode::fbwa);
    EXPECT_FALSE(vehicle.failsafe_short);
}

TEST_F(Failsafe, leaves_a_mode_that_was_chosen_meanwhile) {
    fly(Mode::fbwa);
    loseRadio(kShort_ms);
    firmware::setMode(Mode::loiter, firmware::ModeReason::ground);

    settle(bench::kCentred);
    vehicle.mode_changed = false;
    firmware::runFailsafe();

    EXPECT_NE(vehicle.mode, Mode::circle);
    EXPECT_NE(vehicle.mode, Mode::fbwa);
}

TEST_F(Failsafe, keeps_returning_home_after_the_long_time_though_the_radio_is_back) {
    fly(Mode::fbwa);
    loseRadio(kShort_ms + kLong_ms);
    ASSERT_EQ(vehicle.mode, Mode::rtl);

    for (int i = 0; i < 5; ++i) {
        fakes::receiveRc(bench::kCentred);
        firmware::runRadio();
        fakes::advance_ms(10);
    }
    firmware::runFailsafe();

    EXPECT_EQ(vehicle.mode, Mode::rtl);
    EXPECT_FALSE(vehicle.failsafe_long);
}

TEST_F(Failsafe, lets_loiter_go_on_unless_told_otherwise) {
    fly(Mode::loiter);
    loseRadio(kShort_ms + kLong_ms);
    EXPECT_EQ(vehicle.mode, Mode::loiter);
}

TEST_F(Failsafe, takes_loiter_home_when_told_to) {
    parameters.short_action = 1;
    parameters.long_action = 1;
    fly(Mode::loiter);
    loseRadio(kShort_ms);
    EXPECT_EQ(vehicle.mode, Mode::circle);
    loseRadio(kLong_ms);
    EXPECT_EQ(vehicle.mode, Mode::rtl);
}

TEST_F(Failsafe, glides_in_fbwa_when_told_to) {
    parameters.short_action = parameters.long_action = 2;
    fly(Mode::stabilize);
    loseRadio(kShort_ms);
    ASSERT_EQ(vehicle.mode, Mode::fbwa);
    firmware::runMode();
    EXPECT_EQ(vehicle.throttle_demand, 0);
    EXPECT_EQ(vehicle.roll_demand_rad, 0);
}

TEST_F(Failsafe, circles_when_there_is_no_home_to_return_to) {
    fly(Mode::fbwa);
    vehicle.home.set = false;
    loseRadio(kShort_ms + kLong_ms);
    EXPECT_EQ(vehicle.mode, Mode::circle);
}

TEST_F(Failsafe, does_nothing_on_the_ground_while_disarmed) {
    loseRadio(kShort_ms + kLong_ms);
    EXPECT_EQ(vehicle.mode, Mode::manual);
    EXPECT_FALSE(vehicle.failsafe_short);
}

}  // namespace

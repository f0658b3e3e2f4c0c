// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/rc_override.hpp"

#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using namespace firmware::sensors;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

struct RcOverride : bench::Bench {
    static void hold(uint16_t roll_us) {
        setRcOverride({roll_us, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX,
                       UINT16_MAX, UINT16_MAX});
    }
    uint16_t pulse_us = 0;
};

TEST_F(RcOverride, lasts_for_three_seconds) {
    hold(1700);
    fakes::advance_ms(3000);
    EXPECT_TRUE(rcOverride(0, pulse_us));
    EXPECT_EQ(pulse_us, 1700);
    fakes::advance_ms(1);
    EXPECT_FALSE(rcOverride(0, pulse_us));
    EXPECT_FALSE(rcOverridden());
}

TEST_F(RcOverride, holds_the_channels_that_were_given_and_leaves_those_of_65535) {
    hold(1700);
    EXPECT_FALSE(rcOverride(1, pulse_us));
    hold(UINT16_MAX);
    EXPECT_TRUE(rcOverride(0, pulse_us)) << "as before";
    hold(0);
    EXPECT_FALSE(rcOverride(0, pulse_us)) << "given back";
}

TEST_F(RcOverride, is_over_when_it_is_released) {
    hold(1700);
    ASSERT_TRUE(rcOverridden());
    rcOverrideRelease();
    EXPECT_FALSE(rcOverridden());
    EXPECT_FALSE(rcOverride(0, pulse_us));
}

struct StickOverride : bench::Bench {
    void SetUp() override {
        Bench::SetUp();
        mutable_vehicle.mode = Mode::manual;  // without dead zone
    }
};

TEST_F(StickOverride, turns_no_channel_round_whose_REV_is_0) {
    parameters.channel[0].reverse = parameters.channel[2].reverse = 0;
    setStickOverride({500, 0, 1000, 0});
    settle(bench::kCentred);
    EXPECT_EQ(vehicle.radio.roll_cd, 2250);
    EXPECT_EQ(vehicle.radio.throttle_pct, 100);
}

TEST_F(StickOverride, leaves_a_switch_held_that_the_ground_station_holds) {
    setRcOverride(
        {UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, 1900, UINT16_MAX});
    setStickOverride({500, 0, 1000, 0});
    uint16_t held_us = 0;
    EXPECT_TRUE(rcOverride(6, held_us));
    EXPECT_EQ(held_us, 1900);
}

TEST_F(StickOverride, deflects_as_a_receivers_stick_does) {
    setStickOverride({500, -250, 1000, -1000});
    settle(bench::kCentred);
    EXPECT_EQ(vehicle.radio.roll_cd, 2250);
    EXPECT_EQ(vehicle.radio.pitch_cd, -1125);
    EXPECT_EQ(vehicle.radio.throttle_pct, 100);
    EXPECT_EQ(vehicle.radio.yaw_cd, -4500);
}

TEST_F(StickOverride, means_the_same_on_a_reversed_channel) {
    for (auto& channel : parameters.channel) channel.reverse = -1;
    setStickOverride({500, -250, 0, -1000});
    settle(bench::kCentred);
    EXPECT_EQ(vehicle.radio.roll_cd, 2250);
    EXPECT_EQ(vehicle.radio.pitch_cd, -1125);
    EXPECT_EQ(vehicle.radio.throttle_pct, 0);
    EXPECT_EQ(vehicle.radio.yaw_cd, -4500);
    setStickOverride({0, 0, 1000, 0});
    settle(bench::kCentred);
    EXPECT_EQ(vehicle.radio.throttle_pct, 100);
}

TEST_F(StickOverride, reaches_each_end_of_a_trimmed_channel) {
    parameters.channel[0].trim_us = 1400;
    setStickOverride({1000, 0, 0, 0});
    settle(bench::kCentred);
    EXPECT_EQ(vehicle.radio.pulse_us[0], 1900);
    setStickOverride({-1000, 0, 0, 0});
    settle(bench::kCentred);
    EXPECT_EQ(vehicle.radio.pulse_us[0], 1100);
    setStickOverride({0, 0, 0, 0});
    settle(bench::kCentred);
    EXPECT_EQ(vehicle.radio.pulse_us[0], 1400);
}

TEST_F(StickOverride, ends_where_the_channel_does) {
    setStickOverride({INT16_MIN, 2000, -1000, 1001});
    settle(bench::kCentred);
    EXPECT_EQ(vehicle.radio.roll_cd, -4500);
    EXPECT_EQ(vehicle.radio.pitch_cd, 4500);
    EXPECT_EQ(vehicle.radio.throttle_pct, 0);
    EXPECT_EQ(vehicle.radio.yaw_cd, 4500);
    EXPECT_EQ(vehicle.radio.pulse_us[0], 1100);
    EXPECT_EQ(vehicle.radio.pulse_us[2], 1100);
}

TEST_F(StickOverride, gives_back_a_stick_and_leaves_the_other_channels) {
    setStickOverride({1000, 1000, 1000, 1000});
    setStickOverride({kNoStick, 1000, kNoStick, 1000});
    settle(bench::kCentred);
    EXPECT_EQ(vehicle.radio.roll_cd, 0);
    EXPECT_EQ(vehicle.radio.pitch_cd, 4500);
    EXPECT_EQ(vehicle.radio.throttle_pct, 0);
    EXPECT_EQ(vehicle.radio.yaw_cd, 4500);
    EXPECT_EQ(vehicle.radio.pulse_us[7], 1815);
}

TEST_F(StickOverride, follows_the_channel_map) {
    parameters.map_roll = 4;
    parameters.map_yaw = 1;
    setStickOverride({1000, 0, 0, -1000});
    settle(bench::kCentred);
    EXPECT_EQ(vehicle.radio.pulse_us[3], 1900);
    EXPECT_EQ(vehicle.radio.pulse_us[0], 1100);
    EXPECT_EQ(vehicle.radio.roll_cd, 4500);
    EXPECT_EQ(vehicle.radio.yaw_cd, -4500);
}

}  // namespace

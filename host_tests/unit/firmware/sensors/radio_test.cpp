// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/radio.hpp"

#include "firmware/sensors/rc_override.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

struct Radio : bench::Bench {};

TEST_F(Radio, centres_the_sticks_within_the_dead_zone) {
    mutable_vehicle.mode = Mode::fbwa;
    settle(with(1, 1529));
    EXPECT_EQ(vehicle.radio.roll_cd, 0);
}

TEST_F(Radio, has_no_dead_zone_where_the_stick_is_the_surface) {
    mutable_vehicle.mode = Mode::manual;
    settle(with(1, 1540));
    EXPECT_EQ(vehicle.radio.roll_cd, 4500 * 40 / 400);
    settle(with(1, 1502));
    EXPECT_EQ(vehicle.radio.roll_cd, 23);
}

TEST_F(Radio, scales_each_side_of_the_trim_to_its_own_end) {
    mutable_vehicle.mode = Mode::fbwa;
    parameters.channel[0].trim_us = 1400;
    settle(with(1, 1100));
    EXPECT_EQ(vehicle.radio.roll_cd, -4500);
    settle(with(1, 1900));
    EXPECT_EQ(vehicle.radio.roll_cd, 4500);
    settle(with(1, 1400 + 30 + (1900 - 1430) / 2));
    EXPECT_EQ(vehicle.radio.roll_cd, 2250);
}

TEST_F(Radio, rolls_by_the_yaw_stick_where_there_are_no_ailerons) {
    mutable_vehicle.mode = Mode::fbwa;
    parameters.rudder_only = 1;
    settle(with(4, 1900));
    EXPECT_EQ(vehicle.radio.roll_cd, 4500);
    EXPECT_EQ(vehicle.radio.yaw_cd, 4500);
    settle(with(1, 1900));
    EXPECT_EQ(vehicle.radio.roll_cd, 0);
    parameters.rudder_only = 0;
    settle(with(1, 1900));
    EXPECT_EQ(vehicle.radio.roll_cd, 4500);
}

TEST_F(Radio, turns_a_reversed_channel_round) {
    parameters.channel[1].reverse = -1;
    settle(with(2, 1900));
    EXPECT_EQ(vehicle.radio.pitch_cd, -4500);
}

TEST_F(Radio, reads_the_throttle_from_its_lower_end) {
    settle(with(3, 1130));
    EXPECT_EQ(vehicle.radio.throttle_pct, 0);
    settle(with(3, 1900));
    EXPECT_EQ(vehicle.radio.throttle_pct, 100);
}

TEST_F(Radio, survives_channels_calibrated_to_nothing) {
    parameters.channel[0].min_us = parameters.channel[0].max_us = parameters.channel[0].trim_us;
    settle(with(1, 1900));
    EXPECT_EQ(vehicle.radio.roll_cd, 0);
}

TEST_F(Radio, closes_a_throttle_that_is_calibrated_to_nothing) {
    parameters.channel[2].max_us =
        parameters.channel[2].min_us + parameters.channel[2].dead_zone_us;
    settle(with(3, 1900));
    EXPECT_EQ(vehicle.radio.throttle_pct, 0);
}

TEST_F(Radio, turns_no_channel_round_whose_REV_is_0) {
    parameters.channel[0].reverse = parameters.channel[2].reverse = 0;
    settle({1900, 1500, 1900, 1500, 1500, 1500, 1500, 1815});
    EXPECT_EQ(vehicle.radio.roll_cd, 4500);
    EXPECT_EQ(vehicle.radio.throttle_pct, 100);
}

TEST_F(Radio, follows_a_swapped_channel_map) {
    parameters.map_roll = 4;
    settle(with(4, 1900));
    EXPECT_EQ(vehicle.radio.roll_cd, 4500);
}

TEST_F(Radio, is_lost_a_second_after_the_last_frame_and_not_before) {
    loseRadio(900);
    EXPECT_FALSE(vehicle.radio.lost);
    loseRadio(200);
    EXPECT_TRUE(vehicle.radio.lost);
    EXPECT_EQ(vehicle.radio.roll_cd, 0);
}

TEST_F(Radio, is_lost_when_the_second_is_full) {
    settle(bench::kCentred);  // 10 ms after a frame
    fakes::advance_ms(980);
    firmware::sensors::runRadio();
    EXPECT_FALSE(vehicle.radio.lost);
    fakes::advance_ms(10);
    firmware::sensors::runRadio();
    EXPECT_TRUE(vehicle.radio.lost);
}

// Of one stick alone the others would stay where they were.
TEST_F(Radio, is_replaced_by_a_ground_station_that_holds_roll_pitch_and_throttle) {
    constexpr uint16_t kNotHeld = UINT16_MAX;
    for (const bool moved : {false, true}) {
        for (int missing = 0; missing < 4; ++missing) {
            SCOPED_TRACE(testing::Message() << moved << ' ' << missing);
            SetUp();
            int8_t* const map = &parameters.map_roll;  // roll, pitch, throttle, yaw
            if (moved) map[0] = 8, map[1] = 6, map[2] = 7, map[3] = 5;
            uint16_t held[8] = {kNotHeld, kNotHeld, kNotHeld, kNotHeld,
                                kNotHeld, kNotHeld, kNotHeld, kNotHeld};
            for (int stick = 0; stick < 4; ++stick)
                if (stick != missing) held[map[stick] - 1] = 1600;
            loseRadio(1100);
            ASSERT_TRUE(vehicle.radio.lost);
            firmware::sensors::setRcOverride(held);
            for (int i = 0; i < 3; ++i) firmware::sensors::runRadio();
            EXPECT_EQ(vehicle.radio.lost, missing < 3);
            firmware::sensors::rcOverrideRelease();
        }
    }
}

TEST_F(Radio, keeps_the_switches_that_a_ground_station_with_the_sticks_does_not_hold) {
    parameters.throttle_failsafe = 0;
    settle(with(7, 1900));
    firmware::sensors::setRcOverride(
        {1600, 1600, 1600, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX});
    loseRadio(500);
    EXPECT_FALSE(vehicle.radio.lost);
    EXPECT_TRUE(firmware::sensors::switchIsUp(7));
    EXPECT_EQ(firmware::sensors::modeSwitchPosition(), 6);
}

TEST_F(Radio, has_three_positions_of_a_switch_while_it_is_received) {
    using firmware::sensors::SwitchPosition;
    const auto position = [] { return firmware::sensors::switchPosition(7); };
    const std::pair<uint16_t, SwitchPosition> kEnds[] = {{1200, SwitchPosition::low},
                                                         {1201, SwitchPosition::middle},
                                                         {1799, SwitchPosition::middle},
                                                         {1800, SwitchPosition::high}};
    for (const auto& [pulse_us, expected] : kEnds) {
        settle(with(7, pulse_us));
        EXPECT_EQ(position(), expected) << pulse_us;
    }
    loseRadio(1100);
    EXPECT_EQ(position(), SwitchPosition::unknown);
}

TEST_F(Radio, has_its_sticks_between_two_frames_while_a_ground_station_holds_a_switch) {
    settle(with(1, 1900));
    firmware::sensors::setRcOverride(
        {UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, 1300});
    const auto sticks = vehicle.radio;
    firmware::sensors::runRadio();
    EXPECT_EQ(vehicle.radio.roll_cd, 4500);
    EXPECT_EQ(vehicle.radio.pitch_cd, sticks.pitch_cd);
    EXPECT_EQ(vehicle.radio.yaw_cd, sticks.yaw_cd);
    EXPECT_EQ(vehicle.radio.throttle_pct, sticks.throttle_pct);
    EXPECT_EQ(vehicle.radio.pulse_us[7], 1300);
}

TEST_F(Radio, gives_way_to_a_ground_station_that_holds_a_switch) {
    settle(with(7, 1900));
    ASSERT_TRUE(firmware::sensors::switchIsUp(7));
    firmware::sensors::setRcOverride(
        {UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, 1100, UINT16_MAX});
    settle(with(7, 1900));
    EXPECT_FALSE(firmware::sensors::switchIsUp(7));
    EXPECT_EQ(firmware::sensors::modeSwitchPosition(), 6) << "that one is the receiver's";
}

TEST_F(Radio, is_not_lost_while_the_throttle_is_at_the_failsafe_pulse) {
    settle(with(3, static_cast<uint16_t>(parameters.throttle_failsafe_us)));
    EXPECT_FALSE(vehicle.radio.lost);
}

// From frame to frame: a knob that is turned is followed, a switch that jumps waits for a second
// one.
TEST_F(Radio, takes_a_switch_as_lasting_that_moves_by_no_more_than_50_us) {
    const auto frame = [](uint16_t pulse_us) {
        fakes::receiveRc(with(8, pulse_us));
        firmware::sensors::runRadio();
        fakes::advance_ms(10);
        firmware::sensors::runRadio();
        fakes::advance_ms(10);
        return firmware::sensors::modeSwitchPosition();
    };
    settle(with(8, 1210));
    ASSERT_EQ(firmware::sensors::modeSwitchPosition(), 1);
    EXPECT_EQ(frame(1260), 2);
    EXPECT_EQ(frame(1210), 1);
    EXPECT_EQ(frame(1261), 1) << "a jump";
    EXPECT_EQ(frame(1261), 2) << "that lasts";
    EXPECT_EQ(frame(1210), 2) << "back";
}

TEST_F(Radio, is_lost_when_the_throttle_falls_below_the_failsafe_pulse) {
    settle(with(3, 920));
    EXPECT_TRUE(vehicle.radio.lost);
    settle(bench::kCentred);
    EXPECT_FALSE(vehicle.radio.lost);
}

TEST_F(Radio, is_back_with_the_third_good_frame) {
    settle(with(3, 920));
    ASSERT_TRUE(vehicle.radio.lost);
    for (int good = 1; good <= 3; ++good) {
        fakes::receiveRc(bench::kCentred);
        firmware::sensors::runRadio();
        EXPECT_EQ(vehicle.radio.lost, good < 3) << good;
    }
}

TEST_F(Radio, takes_no_pulse_for_longer_than_a_servo_can) {
    settle(with(1, 2190));
    EXPECT_EQ(vehicle.radio.pulse_us[0], 2100);
    settle(with(1, 810));
    EXPECT_EQ(vehicle.radio.pulse_us[0], 900);
}

TEST_F(Radio, ignores_a_few_low_throttle_pulses) {
    for (int i = 0; i < 9; ++i) {
        fakes::receiveRc(with(3, 920));
        firmware::sensors::runRadio();
    }
    EXPECT_FALSE(vehicle.radio.lost);
}

// What the board's encoder puts out without a receiver (ArduPPM, ppm_encoder.h: failsafe_ppm).
const std::vector<uint16_t> kEncoderFailsafe = {1500, 1500, 900, 1500, 1555, 1500, 1500, 1500};

TEST_F(Radio, obeys_neither_sticks_nor_switches_of_frames_that_may_be_the_encoders_own) {
    parameters.mode_channel = 5;
    std::vector<uint16_t> flown = {1700, 1500, 1400, 1500, 1815, 1500, 1900, 1500};
    settle(flown);
    ASSERT_EQ(vehicle.mode, Mode::manual);
    const auto sticks = vehicle.radio;
    for (int i = 0; i < 18; ++i) {
        if (i % 2 == 0) fakes::receiveRc(kEncoderFailsafe);
        firmware::sensors::runRadio();
        if (i % 5 == 4) firmware::modes::runModeSwitch();
        EXPECT_TRUE(firmware::sensors::switchIsUp(7)) << i;
        EXPECT_EQ(vehicle.radio.roll_cd, sticks.roll_cd) << i;
        EXPECT_EQ(vehicle.radio.throttle_pct, sticks.throttle_pct) << i;
        fakes::advance_ms(10);
    }
    EXPECT_FALSE(vehicle.radio.lost);
    EXPECT_EQ(vehicle.mode, Mode::manual);
    EXPECT_EQ(vehicle.radio.pulse_us[2], 900) << "what is received is reported";
    flown[0] = 1600;
    settle(flown);
    EXPECT_NE(vehicle.radio.roll_cd, sticks.roll_cd);
}

// A start without a receiver, which then has another number of channels: for a second none of its
// frames counts as whole.
TEST_F(Radio, obeys_no_switch_of_the_encoders_own_frames_once_the_receiver_is_there) {
    fakes::reset();
    while (firmware::state::parametersLoad() != core::Status::ok) fakes::advance_ms(10);
    parameters.switch_mode[3] = static_cast<int8_t>(Mode::fbwa);  // where the encoder's 1500 us is
    const auto frames = [](const std::vector<uint16_t>& sticks, bool whole) {
        for (int i = 0; i < 100; ++i) {
            if (i % 2 == 0) whole ? fakes::receiveRc(sticks) : fakes::receiveBrokenRc(sticks);
            firmware::sensors::runRadio();
            if (i % 10 == 9) firmware::modes::runModeSwitch();
            fakes::advance_ms(10);
        }
    };
    frames(kEncoderFailsafe, true);
    ASSERT_TRUE(vehicle.radio.lost);
    frames({1500, 1500, 1400, 1500, 1500, 1500, 1500, 1815}, false);
    EXPECT_FALSE(vehicle.radio.lost);
    EXPECT_NE(vehicle.mode, Mode::fbwa);
}

// One edge twice: every channel behind it has its neighbour's pulse.
TEST_F(Radio, follows_sticks_but_no_switches_of_frames_with_an_edge_too_many) {
    settle({1500, 1500, 1400, 1500, 1500, 1500, 1100, 1815});
    ASSERT_EQ(vehicle.mode, Mode::manual);
    for (int i = 0; i < 100; ++i) {
        if (i % 2 == 0) fakes::receiveBrokenRc({1700, 1500, 1400, 1500, 1500, 750, 1815, 1100});
        firmware::sensors::runRadio();
        if (i % 10 == 9) firmware::modes::runModeSwitch();
        EXPECT_FALSE(firmware::sensors::switchIsUp(7)) << i;
        fakes::advance_ms(10);
    }
    EXPECT_EQ(vehicle.mode, Mode::manual);
    EXPECT_EQ(vehicle.radio.roll_cd, 2250);
}

// Two edges of one frame, one too many and one too few: as many pulses as ever.
TEST_F(Radio, follows_no_switch_that_a_single_frame_shows) {
    settle({1500, 1500, 1400, 1500, 1500, 1500, 1100, 1815});
    ASSERT_EQ(vehicle.mode, Mode::manual);
    for (int i = 0; i < 100; ++i) {
        if (i % 4 == 0) fakes::receiveRc({1500, 1500, 1400, 1500, 1500, 1500, 1100, 1815});
        if (i % 4 == 2) fakes::receiveRc({1500, 1500, 1400, 1500, 1500, 1500, 1815, 1100});
        firmware::sensors::runRadio();
        if (i % 10 == 9) firmware::modes::runModeSwitch();
        EXPECT_FALSE(firmware::sensors::switchIsUp(7)) << i;
        fakes::advance_ms(10);
    }
    EXPECT_EQ(vehicle.mode, Mode::manual);
}

TEST_F(Radio, ignores_the_failsafe_pulse_when_disabled) {
    parameters.throttle_failsafe = 0;
    settle(with(3, 920));
    EXPECT_FALSE(vehicle.radio.lost);
}

struct Band {
    uint16_t pulse_us;
    int position;
};
class ModeSwitch : public bench::Bench, public testing::WithParamInterface<Band> {};

TEST_P(ModeSwitch, has_six_bands) {
    settle(with(8, GetParam().pulse_us));
    EXPECT_EQ(firmware::sensors::modeSwitchPosition(), GetParam().position);
}
INSTANTIATE_TEST_SUITE_P(Pulses, ModeSwitch,
                         testing::Values(Band{901, 1}, Band{1165, 1}, Band{1230, 1}, Band{1231, 2},
                                         Band{1360, 2}, Band{1361, 3}, Band{1490, 3}, Band{1491, 4},
                                         Band{1620, 4}, Band{1621, 5}, Band{1749, 5}, Band{1750, 6},
                                         Band{2100, 6}, Band{900, 0}));

TEST_F(Radio, sets_the_mode_when_the_switch_moves_and_leaves_a_mode_of_the_ground_alone) {
    settle(with(8, 1425));
    ASSERT_EQ(vehicle.mode, Mode::fbwa);
    firmware::modes::requestMode(Mode::stabilize, firmware::modes::ModeReason::ground);
    settle(with(8, 1425));
    EXPECT_EQ(vehicle.mode, Mode::stabilize);
    settle(with(8, 1815));
    EXPECT_EQ(vehicle.mode, Mode::manual);
}

TEST_F(Radio, uses_the_mode_switch_again_while_the_reset_switch_is_up) {
    parameters.reset_switch_channel = 7;
    settle(with(8, 1425));
    firmware::modes::requestMode(Mode::stabilize, firmware::modes::ModeReason::ground);
    settle(with(8, 1425));
    ASSERT_EQ(vehicle.mode, Mode::stabilize);
    auto pulses = with(8, 1425);
    pulses[6] = 1800;
    settle(pulses);
    EXPECT_EQ(vehicle.mode, Mode::fbwa);
}

TEST_F(Radio, detects_a_switch_that_is_up_but_not_a_missing_one_or_without_a_receiver) {
    settle(with(7, 1800));
    EXPECT_TRUE(firmware::sensors::switchIsUp(7));
    EXPECT_FALSE(firmware::sensors::switchIsUp(0));
    settle(with(7, 1750));
    EXPECT_FALSE(firmware::sensors::switchIsUp(7));
    settle(with(7, 1800));
    loseRadio(1200);
    EXPECT_FALSE(firmware::sensors::switchIsUp(7));
}

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/actuators/outputs.hpp"

#include "firmware/actuators/flaps.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "wrong_board.hpp"

namespace {

using firmware::actuators::outputPulse_us;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;
using firmware::state::vehicle;

class Outputs : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        firmware::actuators::startOutputs();
    }
    void run() {
        firmware::modes::runMode();
        prepareControl();
        firmware::control::runAttitudeControl();
        firmware::actuators::runFlaps();
        firmware::actuators::runOutputs();
    }
};

TEST_F(Outputs, are_refreshed_fifty_times_a_second) { EXPECT_EQ(fakes::servos().rate_hz, 50); }

TEST_F(Outputs, give_the_throttle_its_lowest_pulse_while_disarmed) {
    for (Mode mode : {Mode::manual, Mode::stabilize, Mode::fbwa}) {
        firmware::modes::requestMode(mode, firmware::modes::ModeReason::ground);
        settle(with(3, 1900));
        run();
        ASSERT_EQ(vehicle.throttle_demand.toFloat(), 1);
        EXPECT_EQ(outputPulse_us(3), 1100) << static_cast<int>(mode);
    }
    mutable_vehicle.armed = true;
    run();
    EXPECT_EQ(outputPulse_us(3), 1900);
    mutable_vehicle.armed = false;
    run();
    EXPECT_EQ(outputPulse_us(3), 1100) << "at once";
}

TEST_F(Outputs, pass_the_sticks_through_in_manual) {
    settle({1700, 1350, 1100, 1900, 1500, 1500, 1500, 1815});
    run();
    EXPECT_NEAR(outputPulse_us(1), 1700, 1);
    EXPECT_NEAR(outputPulse_us(2), 1350, 1);
    EXPECT_NEAR(outputPulse_us(4), 1900, 1);
}

TEST_F(Outputs, make_flaperons_of_the_ailerons_and_of_a_lever) {
    parameters.output_function[1] = firmware::actuators::kLeftFlaperonFunction;
    parameters.output_function[2] = firmware::actuators::kRightFlaperonFunction;
    parameters.flap_channel = 6;
    parameters.flap_slew_pct = 0;
    parameters.mixing_gain = 1;
    settle({1600, 1500, 1100, 1500, 1500, 1100, 1900, 1815});
    run();
    EXPECT_NEAR(outputPulse_us(6), 1600, 1);
    EXPECT_NEAR(outputPulse_us(7), 1400, 1);
    settle({1500, 1500, 1100, 1500, 1500, 1500, 1100, 1815});
    run();
    EXPECT_NEAR(outputPulse_us(6), 1700, 1) << "half the flap";
    EXPECT_NEAR(outputPulse_us(7), 1700, 1);
    settle({1700, 1500, 1100, 1500, 1500, 1900, 1100, 1815});
    run();
    EXPECT_NEAR(outputPulse_us(6), 1900, 1) << "both at their most: roll comes first";
    EXPECT_NEAR(outputPulse_us(7), 1500, 1);
}

TEST_F(Outputs, follow_the_receiver_where_the_function_is_none_of_those_there_are) {
    const float taken[] = {0, 2, 3, 10, 24, 25}, refused[] = {1, 4, 9, 11, 23, -1, 26};
    for (float number : taken)
        EXPECT_TRUE(firmware::state::parameterSlotTakes(217, number)) << number;
    for (float number : refused)
        EXPECT_FALSE(firmware::state::parameterSlotTakes(217, number)) << number;
    parameters.output_function[1] = 4;
    settle(with(6, 1720));
    run();
    EXPECT_EQ(outputPulse_us(6), 1720);
}

// The stick is reversed by the same parameter, so that it moves the surface the same way.
TEST_F(Outputs, move_a_reversed_surface_with_its_stick_and_against_the_demand) {
    parameters.channel[0].reverse = -1;
    settle(with(1, 1700));
    run();
    EXPECT_GT(outputPulse_us(1), 1650) << "the servo goes where the stick goes";
    EXPECT_LT(firmware::control::surfaces.aileron.toFloat(), -0.4f);
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

TEST_F(Outputs, rest_at_the_trims_of_their_own_channels) {
    parameters.channel[0].trim_us = 1420;
    parameters.channel[1].trim_us = 1440;
    parameters.channel[3].trim_us = 1460;
    settle({1420, 1440, 1100, 1460, 1500, 1500, 1500, 1815});
    run();
    EXPECT_EQ(outputPulse_us(1), 1420);
    EXPECT_EQ(outputPulse_us(2), 1440);
    EXPECT_EQ(outputPulse_us(4), 1460);
}

TEST_F(Outputs, follow_the_receiver_when_not_held) {
    settle(with(6, 1234));
    run();
    EXPECT_EQ(outputPulse_us(6), 1234);
}

TEST_F(Outputs, are_held_until_the_mode_changes) {
    ASSERT_TRUE(firmware::actuators::outputOverride(6, 1850));
    settle(with(6, 1200));
    run();
    EXPECT_EQ(outputPulse_us(6), 1850) << "though the receiver says otherwise";

    firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
    run();
    EXPECT_EQ(outputPulse_us(6), 1200);
}

TEST_F(Outputs, can_be_released_one_by_one) {
    ASSERT_TRUE(firmware::actuators::outputOverride(6, 1850));
    ASSERT_TRUE(firmware::actuators::outputOverride(7, 0));
    firmware::actuators::outputRelease(6);
    run();
    EXPECT_EQ(outputPulse_us(6), 1500);
    EXPECT_EQ(outputPulse_us(7), 0) << "silent on request";
}

TEST_F(Outputs, refuse_to_hold_a_pulse_out_of_range) {
    ASSERT_TRUE(firmware::actuators::outputOverride(5, 3000));
    ASSERT_TRUE(firmware::actuators::outputOverride(8, 1));
    run();
    EXPECT_EQ(outputPulse_us(5), 2200);
    EXPECT_EQ(outputPulse_us(8), 800);
}

TEST_F(Outputs, can_be_held_on_surfaces_too_but_not_on_missing_channels) {
    run();
    for (uint8_t output : {1, 2, 4}) {
        EXPECT_TRUE(firmware::actuators::outputOverride(output, 1850)) << int{output};
        run();
        EXPECT_EQ(outputPulse_us(output), 1850);
        firmware::actuators::outputRelease(output);
        run();
        EXPECT_EQ(outputPulse_us(output), 1500);
    }
    for (uint8_t output : {0, 9, 255}) {
        EXPECT_FALSE(firmware::actuators::outputOverride(output, 1850)) << int{output};
        firmware::actuators::outputRelease(output);
        EXPECT_EQ(outputPulse_us(output), 0);
    }
}

TEST_F(Outputs, the_throttle_can_never_be_held) {
    for (const bool armed : {false, true}) {
        firmware::state::mutable_vehicle.armed = armed;
        EXPECT_FALSE(firmware::actuators::outputOverride(3, 1300));
        run();
        EXPECT_EQ(outputPulse_us(3), 1100);
    }
}

// A radio calibration writes these one by one, with hands at the propeller.
TEST_F(Outputs, a_disarmed_motor_keeps_its_idle_pulse_whatever_its_channel_is_set_to) {
    firmware::state::parameters.channel[2].min_us = 1000;
    firmware::actuators::startOutputs();
    const firmware::state::Channel kSettings[] = {{1300, 1500, 1900, 1, 30},
                                                  {1700, 1800, 1900, 1, 30},
                                                  {1000, 1200, 1900, -1, 30},
                                                  {1100, 1500, 1900, 1, 30}};
    for (const auto& setting : kSettings) {
        firmware::state::parameters.channel[2] = setting;
        run();
        EXPECT_EQ(outputPulse_us(3), 1000) << setting.min_us;
    }
    mutable_vehicle.armed = true;
    run();
    mutable_vehicle.armed = false;
    run();
    EXPECT_EQ(outputPulse_us(3), 1100) << "idle when it was armed";
}

TEST_F(Outputs, the_idle_pulse_is_that_of_arming_though_the_channel_changes_while_armed) {
    mutable_vehicle.armed = true;
    run();
    parameters.channel[2].min_us = 1300;  // by a mission's command
    run();
    mutable_vehicle.armed = false;
    run();
    EXPECT_EQ(outputPulse_us(3), 1100);
}

TEST_F(Outputs, a_flaperon_is_turned_by_its_own_channel) {
    parameters.output_function[0] = firmware::actuators::kLeftFlaperonFunction;
    parameters.mixing_gain = 1;
    for (const int8_t reverse : {1, -1}) {
        parameters.channel[4].reverse = reverse;
        settle({1600, 1500, 1100, 1500, 1500, 1100, 1900, 1815});
        run();
        EXPECT_NEAR(outputPulse_us(5), 1500 + 100 * reverse, 1);
    }
}

TEST_F(Outputs, a_motor_whose_idle_is_high_by_its_settings_starts_with_a_low_pulse) {
    for (const int16_t min_us : {1101, 1300, 1700}) {
        firmware::state::parameters.channel[2].min_us = min_us;
        firmware::actuators::startOutputs();
        EXPECT_EQ(outputPulse_us(3), 1100) << min_us;
    }
}

TEST_F(Outputs, a_throttle_whose_REV_is_0_has_its_idle_pulse_from_the_start) {
    firmware::state::parameters.channel[2].reverse = 0;
    firmware::actuators::startOutputs();
    EXPECT_EQ(outputPulse_us(3), 1100);
}

// Which end of it is idle only the pilot knows; full throttle would be the other one.
TEST_F(Outputs, a_reversed_throttle_gets_no_pulse_until_it_is_armed) {
    firmware::state::parameters.channel[2] = {1100, 1200, 1900, -1, 30};
    firmware::actuators::startOutputs();
    EXPECT_EQ(outputPulse_us(3), 0);
    mutable_vehicle.armed = true;
    settle(with(3, 1900));
    firmware::modes::requestMode(Mode::manual, firmware::modes::ModeReason::ground);
    run();
    EXPECT_EQ(outputPulse_us(3), 1900);
    mutable_vehicle.armed = false;
    run();
    EXPECT_EQ(outputPulse_us(3), 1900) << "it was idle when armed";
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

// Its pins may be anything there.
TEST_F(Outputs, of_another_board_are_neither_started_nor_written_nor_held) {
    fakes::servos() = {};
    bench::findBoard(true);
    firmware::actuators::startOutputs();
    settle(with(1, 1700));
    run();
    EXPECT_FALSE(firmware::actuators::outputOverride(6, 1850));
    EXPECT_EQ(fakes::servos().rate_hz, 0);
    EXPECT_EQ(fakes::servos().writes, 0u);
    bench::findBoard(false);
    firmware::actuators::startOutputs();
    EXPECT_EQ(fakes::servos().rate_hz, 50);
    EXPECT_GT(fakes::servos().writes, 0u);
}

// Stick and deflection of a pair, in shares of the servo's way.
class Pairs : public Outputs {
protected:
    void SetUp() override {
        Outputs::SetUp();
        mutable_vehicle.armed = true;
    }
    struct Moved {
        int first, second;
    };
    Moved moved(const std::vector<uint16_t>& sticks, uint8_t first, uint8_t second) {
        settle(sticks);
        run();
        return {outputPulse_us(first) - 1500, outputPulse_us(second) - 1500};
    }
};

TEST_F(Pairs, elevons_go_together_for_pitch_and_apart_for_roll) {
    const struct {
        int8_t kind;
        int first, second;  // the way each servo turns
    } kinds[] = {{1, 1, 1}, {2, -1, 1}, {3, 1, -1}, {4, -1, -1}};
    for (const auto& each : kinds) {
        parameters.elevon_output = each.kind;
        const Moved pulled = moved(with(2, 1900), 1, 2);
        EXPECT_NEAR(pulled.first, each.first * 200, 1) << int{each.kind};
        EXPECT_NEAR(pulled.second, each.second * 200, 1);
        const Moved right = moved(with(1, 1900), 1, 2);
        EXPECT_NEAR(right.first, each.first * 200, 1);
        EXPECT_NEAR(right.second, -each.second * 200, 1);
        EXPECT_EQ(moved(with(4, 1900), 1, 2).first, 0) << "the rudder is its own";
        EXPECT_GT(outputPulse_us(4), 1890);
    }
}

TEST_F(Pairs, both_sides_of_a_v_tail_take_elevator_and_rudder) {
    parameters.vtail_output = 1;
    const Moved pulled = moved(with(2, 1900), 2, 4);
    EXPECT_NEAR(pulled.first, 200, 1);
    EXPECT_NEAR(pulled.second, 200, 1);
    const Moved right = moved(with(4, 1900), 2, 4);
    EXPECT_NEAR(right.first, -200, 1);
    EXPECT_NEAR(right.second, 200, 1);
    EXPECT_GT(moved(with(1, 1900), 1, 2).first, 390) << "the aileron is its own";
}

TEST_F(Pairs, full_sticks_together_are_all_a_surface_has) {
    parameters.elevon_output = 1;
    const Moved both = moved({1900, 1900, 1100, 1500, 1500, 1500, 1500, 1815}, 1, 2);
    EXPECT_NEAR(both.first, 400, 1);
    EXPECT_NEAR(both.second, 0, 1);
    parameters.mixing_gain = 1.2f;
    EXPECT_NEAR(moved(with(2, 1700), 1, 2).first, 1.2f * 200, 2);
}

TEST_F(Pairs, a_v_tail_takes_the_trim_and_the_turn_of_the_rudders_channel) {
    parameters.vtail_output = 1;
    parameters.channel[0].reverse = -1;  // the aileron's is none of its own
    parameters.channel[3].trim_us = 1460;
    const Moved right = moved({1500, 1500, 1100, 1900, 1500, 1500, 1500, 1815}, 2, 4);
    EXPECT_NEAR(right.first, -200, 1);
    EXPECT_NEAR(right.second, -40 + 220, 1);
}

TEST_F(Pairs, a_channel_whose_REV_is_0_is_not_turned) {
    parameters.elevon_output = 1;
    const Moved plain = moved(with(1, 1800), 1, 2);
    parameters.channel[0].reverse = 0;
    const Moved same = moved(with(1, 1800), 1, 2);
    EXPECT_EQ(same.first, plain.first);
    EXPECT_EQ(same.second, plain.second);
}

// As on a plain airplane: in MANUAL the servos follow the sticks, and what stabilises is reversed.
TEST_F(Pairs, a_reversed_channel_reverses_the_control_on_both_surfaces) {
    parameters.elevon_output = 1;
    const Moved plain = moved(with(1, 1800), 1, 2);
    parameters.channel[0].reverse = -1;
    const Moved reversed = moved(with(1, 1800), 1, 2);
    EXPECT_EQ(reversed.first, plain.first);
    EXPECT_EQ(reversed.second, plain.second);
    firmware::modes::requestMode(Mode::fbwa, firmware::modes::ModeReason::ground);
    mutable_vehicle.attitude.roll_rad = core::Angle(0.5f);
    mutable_vehicle.imu.periods = 2;
    for (int i = 0; i < 12; ++i) run();
    ASSERT_LT(firmware::control::surfaces.aileron.toFloat(), -0.05f);
    const Moved levelling = moved(bench::kCentred, 1, 2);
    EXPECT_GT(levelling.first, levelling.second);
}

}  // namespace

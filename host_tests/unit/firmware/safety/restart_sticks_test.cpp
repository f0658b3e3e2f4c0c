// SPDX-License-Identifier: GPL-3.0-or-later
// What the hang timer's interrupt puts out, against MANUAL's own way from the same sticks.
#include "firmware/actuators/outputs.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware/safety/restart_records.hpp"
#include "firmware/state/restart_record.hpp"
#include "firmware_bench.hpp"
#include "hal/hang_timer.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "wrong_board.hpp"

namespace {

using firmware::state::mutable_vehicle;
using firmware::state::parameters;

class SticksWhileItHangs : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        firmware::actuators::startOutputs();
        mutable_vehicle.armed = true;
    }
    std::array<uint16_t, 4> now() {
        std::array<uint16_t, 4> pulses_us;
        for (uint8_t i = 0; i < 4; ++i)
            pulses_us[i] = static_cast<uint16_t>(fakes::servos().pulse_halfus[i] / 2);
        return pulses_us;
    }
    // A round of the interrupt; before it the servos stand as the program left them.
    std::array<uint16_t, 4> forgotten(const std::vector<uint16_t>& sticks) {
        fakes::receiveRc(sticks);
        for (int i = 0; i < 4; ++i) hal::passSticksToServos();
        return now();
    }
    std::array<uint16_t, 4> manual(const std::vector<uint16_t>& sticks) {
        settle(sticks);
        firmware::modes::runMode();
        prepareControl();
        firmware::control::runAttitudeControl();
        firmware::actuators::runOutputs();
        return now();
    }
    const std::vector<uint16_t> sticks_ = {1640, 1420, 1550, 1580, 1500, 1500, 1500, 1815};
    void expectNear(const std::array<uint16_t, 4>& a, const std::array<uint16_t, 4>& b, int us) {
        for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], us) << "output " << i + 1;
    }
};

}  // namespace

TEST_F(SticksWhileItHangs, go_straight_to_their_servos) {
    const auto as_in_manual = manual(sticks_);
    manual(bench::kCentred);

    expectNear(forgotten(sticks_), as_in_manual, 45);  // dead zones
}

TEST_F(SticksWhileItHangs, are_mixed_for_elevons_and_for_a_v_tail_of_every_kind) {
    for (int8_t kind = 1; kind <= 4; ++kind) {
        for (const bool elevons : {true, false}) {
            SCOPED_TRACE(testing::Message() << (elevons ? "elevons " : "v-tail ") << int(kind));
            parameters.elevon_output = elevons ? kind : 0;
            parameters.vtail_output = elevons ? 0 : kind;
            const auto as_in_manual = manual(sticks_);
            manual(bench::kCentred);

            expectNear(forgotten(sticks_), as_in_manual, 45);
        }
    }
}

TEST_F(SticksWhileItHangs, are_mixed_from_the_trims_of_their_own_channels) {
    parameters.elevon_output = 1;
    parameters.channel[0].trim_us = 1400;
    parameters.channel[1].trim_us = 1600;
    parameters.channel[2].trim_us = 1200;
    const std::vector<uint16_t> trimmed = {1400, 1600, 1100, 1500, 1500, 1500, 1500, 1815};
    EXPECT_EQ(forgotten(trimmed)[0], 1400) << "sticks at trim, servo at trim";
    EXPECT_EQ(forgotten(trimmed)[1], 1600);
}

TEST_F(SticksWhileItHangs, leave_the_gyros_turn_for_the_restart_after_each_round) {
    using namespace firmware::safety;
    for (int record = 0; record < 2; ++record) {
        finishFastRecord();
        records.fast[0].checksum = 0x1111;
        records.fast[1].checksum = 0x2222;
        records.hang.checksum = 0;
        forgotten(sticks_);
        EXPECT_TRUE(isValid(records.hang, newestFastRecord()));
        EXPECT_FALSE(isValid(records.hang, nextFastRecord()));
    }
}

TEST_F(SticksWhileItHangs, leave_the_gyros_turn_once_a_round) {
    using namespace firmware::safety;
    finishFastRecord();
    records.hang.checksum = 0;
    for (int i = 0; i < 3; ++i) {
        hal::passSticksToServos();
        EXPECT_FALSE(isValid(records.hang, newestFastRecord())) << i;
    }
    hal::passSticksToServos();
    EXPECT_TRUE(isValid(records.hang, newestFastRecord()));
}

TEST_F(SticksWhileItHangs, go_to_the_outputs_in_turn) {
    manual(bench::kCentred);
    fakes::receiveRc(sticks_);
    int changed = 0;
    for (int i = 0; i < 4; ++i) {
        const auto before = now();
        hal::passSticksToServos();
        const auto after = now();
        for (size_t output = 0; output < 4; ++output) {
            if (before[output] == after[output]) continue;
            ++changed;
            EXPECT_EQ(output, (1u + i) % 4) << "call " << i;
        }
    }
    EXPECT_EQ(changed, 4);
}

TEST_F(SticksWhileItHangs, never_turn_the_motor_of_a_disarmed_airplane) {
    mutable_vehicle.armed = false;
    const uint16_t idle_us = manual(bench::kCentred)[2];

    EXPECT_EQ(forgotten(sticks_)[2], idle_us);
}

TEST_F(SticksWhileItHangs, stay_where_they_were_when_the_radio_was_lost) {
    const auto before = manual(bench::kCentred);
    mutable_vehicle.radio.lost = true;

    EXPECT_EQ(forgotten(sticks_), before);
}

TEST_F(SticksWhileItHangs, move_nothing_before_a_frame_was_received) {
    const auto before = manual(bench::kCentred);

    EXPECT_EQ(forgotten({1640, 0, 1550, 1580, 1500, 1500, 1500, 1815}), before);
}

TEST_F(SticksWhileItHangs, move_nothing_on_a_board_with_other_pins) {
    const auto before = manual(bench::kCentred);
    bench::findBoard(true);

    EXPECT_EQ(forgotten(sticks_), before);
}

TEST_F(SticksWhileItHangs, are_found_where_RCMAP_says) {
    parameters.map_roll = 4;
    parameters.map_yaw = 1;
    const auto pulses_us = forgotten(sticks_);

    EXPECT_EQ(pulses_us[0], 1580);
    EXPECT_EQ(pulses_us[3], 1640);
}

TEST_F(SticksWhileItHangs, give_way_when_the_program_goes_on) {
    const auto before = manual(bench::kCentred);
    forgotten(sticks_);

    EXPECT_EQ(manual(bench::kCentred), before);
}

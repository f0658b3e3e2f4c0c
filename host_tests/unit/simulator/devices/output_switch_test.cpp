// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/output_switch.hpp"

#include <gtest/gtest.h>

using simulator::OutputSwitch;

namespace {

class OutputSwitchTest : public testing::Test {
protected:
    void hold(uint16_t channel_us, uint64_t for_us) {
        for (const uint64_t end_us = now_us + for_us; now_us < end_us; now_us += 2500)
            outputs.run(channel_us, now_us);
    }

    OutputSwitch outputs;
    uint64_t now_us = 0;
};

}  // namespace

TEST_F(OutputSwitchTest, gives_the_outputs_to_the_receiver_after_five_looks_above_1800_us) {
    hold(1801, 120'000);
    EXPECT_FALSE(outputs.toReceiver());
    hold(1801, 30'000);
    EXPECT_TRUE(outputs.toReceiver());
}

TEST_F(OutputSwitchTest, stays_where_it_is_between_1600_and_1800_us) {
    hold(1800, 1'000'000);
    EXPECT_FALSE(outputs.toReceiver());
    hold(1900, 200'000);
    hold(1600, 1'000'000);
    EXPECT_TRUE(outputs.toReceiver());
    hold(1599, 200'000);
    EXPECT_FALSE(outputs.toReceiver());
}

TEST_F(OutputSwitchTest, begins_to_count_again_when_a_look_disagrees) {
    hold(1900, 120'000);
    hold(1700, 30'000);
    hold(1900, 120'000);
    EXPECT_FALSE(outputs.toReceiver());
}

TEST_F(OutputSwitchTest, starts_with_the_outputs_at_the_firmware) {
    hold(1900, 200'000);
    outputs.reset();
    EXPECT_FALSE(outputs.toReceiver());
}

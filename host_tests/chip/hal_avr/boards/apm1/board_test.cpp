// SPDX-License-Identifier: GPL-3.0-or-later
// The whole image on the emulated first board.
#include <gtest/gtest.h>

#include "simulator/devices/ads7844.hpp"
#include "simulator/devices/bmp085.hpp"
#include "simulator/devices/mpu6000.hpp"
#include "simulator/machine/apm2_board.hpp"

namespace {

using simulator::AvrBoard;

simulator::WorldOptions quickBootloader() {
    simulator::WorldOptions options;
    options.bootloader = simulator::Bootloader::quick;
    return options;
}

struct Apm1Board : testing::Test {
    explicit Apm1Board(const simulator::WorldOptions& options = quickBootloader())
        : board(IMAGE_APM1, options, simulator::kApm1Wiring) {
        board.listen([this](int usart, uint8_t byte, uint64_t time_us) {
            auto& seen = heard[usart];
            seen.push_back(byte);
            if (first_us[usart] == 0) first_us[usart] = time_us;
        });
    }
    // MAVLink 1: FE, 9 bytes, sequence, system, component, HEARTBEAT 0.
    int heartbeats(int usart) const {
        int found = 0;
        const std::string& seen = heard[usart];
        for (size_t i = 0; i + 6 <= seen.size(); ++i) {
            const bool version_1 = seen[i] == '\xFE' && seen[i + 1] == 9 && seen[i + 5] == 0;
            const bool version_2 = seen[i] == '\xFD' && seen[i + 1] <= 9 && i + 10 <= seen.size() &&
                                   seen[i + 7] == 0 && seen[i + 8] == 0 && seen[i + 9] == 0;
            found += version_1 || version_2;
        }
        return found;
    }
    AvrBoard board;
    std::string heard[4];
    uint64_t first_us[4] = {};
};

TEST_F(Apm1Board, sends_on_usb_and_on_the_radio) {
    ASSERT_TRUE(board.runUntil(3'000'000)) << board.fault();

    EXPECT_GE(heartbeats(0), 2);
    EXPECT_GE(heartbeats(3), 2);
    EXPECT_LT(first_us[0], 300'000u);
    EXPECT_TRUE(heard[2].empty());  // the converter's bus
}

// The stock bootloader is busy for a second before the program begins.
TEST(Apm1Load, is_that_of_the_program_and_not_of_the_bootloader) {
    const auto loadAfter = [](const simulator::WorldOptions& options, uint64_t time_us) {
        AvrBoard board(IMAGE_APM1, options, simulator::kApm1Wiring);
        EXPECT_TRUE(board.runUntil(time_us)) << board.fault();
        return board.figures().cpu_load.value();
    };
    const double load = loadAfter(quickBootloader(), 2'065'000);
    EXPECT_LT(load, 0.5);
    EXPECT_NEAR(loadAfter({}, 3'065'000), load, 0.02);
}

TEST_F(Apm1Board, reads_the_sensors_of_the_first_board_and_not_those_of_the_second) {
    ASSERT_TRUE(board.runUntil(2'000'000)) << board.fault();

    EXPECT_NEAR(static_cast<double>(board.world().converter().conversions(0)), 1930, 60);
    EXPECT_EQ(board.world().converter().conversions(3), 0u);
    EXPECT_EQ(board.world().imu().samples().made, 0u);
}

TEST_F(Apm1Board, reads_each_conversion_before_what_is_held_has_leaked_away) {
    ASSERT_TRUE(board.runUntil(4'000'000)) << board.fault();

    const uint64_t longest_us = board.world().converter().longestConversion_us();
    EXPECT_GT(longest_us, 500u) << "the last of a set waits for the next one";
    EXPECT_LT(longest_us, 1600u) << "SBAS100: 16 clocks of 10 kHz";
}

TEST_F(Apm1Board, switches_its_lights_by_a_high_level_and_holds_the_relay_off) {
    int lit = 0;
    for (uint64_t ms = 100; ms < 3000; ms += 10) {
        ASSERT_TRUE(board.runUntil(ms * 1000)) << board.fault();
        lit += board.ledOn(AvrBoard::Led::a);
    }

    EXPECT_GT(lit, 5);
    EXPECT_LT(lit, 285);
    EXPECT_FALSE(board.world().relayOn());
}

TEST_F(Apm1Board, keeps_every_interrupt_within_40_us) {
    ASSERT_TRUE(board.runUntil(3'000'000)) << board.fault();

    for (const auto& interrupt : board.figures().interrupts) {
        EXPECT_LE(interrupt.max_cycles, 640u) << "vector " << interrupt.vector;
    }
}

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/chip_supply.hpp"

#include "machine.hpp"
#include "simulator/machine/apm2_board.hpp"

using simulator::ChipSupply;
using simulator::Supply;

namespace {

enum Cause { kPowerOn = 1, kBrownOut = 4 };
constexpr uint64_t kMs = 1000;

struct Supplied {
    explicit Supplied(const char* program) : machine(program) {}
    void sag(double volts, uint64_t from_ms, uint64_t to_ms) {
        supply.add({volts, from_ms * kMs, to_ms * kMs, 0});
    }
    void run_ms(uint64_t ms) { ASSERT_TRUE(chip.run(ms * kMs)); }
    std::vector<int> causes() const {
        std::vector<int> all;
        for (const Report& each : machine.reports)
            if (each.number != 0x80) all.push_back(each.low);
        return all;
    }
    Machine machine;
    Supply supply;
    ChipSupply chip{machine.chip, supply, 1.1, 1};
};

}  // namespace

TEST(ChipSupply, holds_the_chip_while_it_is_below_2_7_volts) {
    Supplied board("watchdog");
    board.sag(2.6, 100, 300);
    board.run_ms(50);
    const size_t before = board.machine.reports.size();
    board.run_ms(299);
    EXPECT_TRUE(board.chip.held());
    EXPECT_EQ(board.machine.reports.size(), before);
    EXPECT_EQ(board.machine.chip.cycle(), 299u * 16000) << "time goes on";
    board.run_ms(400);
    EXPECT_FALSE(board.chip.held());
    EXPECT_EQ(board.causes(), (std::vector<int>{kPowerOn, 8, kBrownOut}));
}

TEST(ChipSupply, does_nothing_to_the_chip_above_2_7_volts) {
    Supplied board("watchdog");
    board.sag(2.75, 100, 300);
    board.run_ms(400);
    EXPECT_EQ(board.causes(), (std::vector<int>{kPowerOn, 8}));
}

TEST(ChipSupply, that_fell_to_nothing_is_a_power_on) {
    Supplied board("watchdog");
    board.sag(0, 100, 300);
    board.run_ms(400);
    EXPECT_EQ(board.causes(), (std::vector<int>{kPowerOn, 8, kPowerOn | kBrownOut, 8}));
}

TEST(ChipSupply, leaves_memory_above_a_volt_and_noise_below) {
    for (const double volts : {1.1, 0.95}) {
        Supplied board("watchdog");
        board.run_ms(50);
        uint8_t* const ram = board.machine.chip.avr()->data + 0x1000;
        std::fill(ram, ram + 256, uint8_t{0x5A});
        board.sag(volts, 100, 300);
        board.run_ms(310);
        const auto left = std::count(ram, ram + 256, 0x5A);
        EXPECT_EQ(left == 256, volts > 1) << left;
    }
}

TEST(ChipSupply, is_the_reference_of_the_converter) {
    Supplied board("adc");
    board.sag(4, 0, 100);
    board.run_ms(10);
    EXPECT_EQ(board.machine.report(3).word(), static_cast<int>(1.1 / 4 * 1024));
}

TEST(ChipSupply, damages_a_byte_of_the_eeprom_that_is_written_below_4_5_volts) {
    for (const double volts : {4.6, 4.4}) {
        Supplied board("eeprom");
        board.sag(volts, 1, 2);
        board.run_ms(30);
        const auto bytes = board.machine.chip.eeprom().contents();
        EXPECT_EQ(bytes[0x11] == 0xA5, volts > 4.5);
        EXPECT_EQ(bytes[0x12], 0xA6) << "written later";
    }
}

TEST(ChipSupply, damages_the_byte_that_a_brown_out_breaks_off) {
    Supplied board("eeprom");
    board.sag(2, 1, 2);
    ASSERT_TRUE(board.chip.run(1500));
    EXPECT_FALSE(board.machine.chip.eeprom().busy());
    EXPECT_NE(board.machine.chip.eeprom().contents()[0x11], 0xA5);
}

TEST(ChipSupply, silences_the_board_and_starts_it_again) {
    simulator::WorldOptions options;
    options.bootloader = simulator::Bootloader::quick;
    options.faults = {*simulator::parseFault("supply:cut@1-1.2")};
    simulator::AvrBoard board(program("board.elf"), options);
    uint64_t last_us = 0, longest_us = 0;
    board.listen([&](int, uint8_t, uint64_t at_us) {
        longest_us = std::max(longest_us, at_us - last_us);
        last_us = at_us;
    });
    ASSERT_TRUE(board.runUntil(1'150'000));
    EXPECT_TRUE(board.heldInReset());
    EXPECT_EQ(board.time_us(), 1'150'000u);
    ASSERT_TRUE(board.runUntil(3'000'000));
    EXPECT_FALSE(board.heldInReset());
    EXPECT_GT(last_us, 1'260'000u);
}

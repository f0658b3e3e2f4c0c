// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.hpp"

using simulator::Reset;

enum Cause { kPowerOn = 1, kExternal = 2, kBrownOut = 4, kWatchdog = 8 };

TEST(Resets, the_watchdog_bites_15_ms_after_it_was_last_fed) {
    Machine machine("watchdog");
    machine.run_ms(60);

    EXPECT_EQ(machine.report(1).low, kPowerOn);
    EXPECT_EQ(machine.report(2).low, kWatchdog);
    EXPECT_NEAR(machine.cyclesBetween(0x80, 2) / 16000.0, 16, 1);
}

TEST(Resets, each_cause_is_reported_and_memory_survives) {
    Machine machine("watchdog");
    machine.run_ms(60);
    machine.chip.reset(Reset::external);
    machine.run_ms(1);
    machine.chip.reset(Reset::brown_out);
    machine.run_ms(1);

    EXPECT_EQ(machine.report(3).low, kExternal);
    EXPECT_EQ(machine.report(4).low, kBrownOut);
}

TEST(Resets, the_board_is_notified_of_each_reset_and_the_speed_stays) {
    Machine machine("watchdog");
    int resets = 0;
    machine.chip.on_reset = [&resets] { resets++; };
    machine.run_ms(60);
    machine.chip.reset(Reset::external);

    EXPECT_EQ(resets, 2);
    EXPECT_GT(machine.chip.avr()->run_cycle_limit, 1000u);
}

TEST(Resets, pins_driven_from_outside_keep_their_level) {
    Machine machine("watchdog");
    machine.chip.drive('A', 1, true);
    machine.chip.reset(Reset::external);
    machine.run_ms(1);
    constexpr uint16_t kPinA = 0x20;
    EXPECT_EQ(machine.chip.avr()->data[kPinA] & 2, 2);
}

TEST(Programming, leaves_another_program_and_the_boot_section_as_it_was) {
    Machine machine("watchdog");
    machine.boot("quick");
    const uint8_t* const flash = machine.chip.avr()->flash;
    const std::vector<uint8_t> loader(flash + simulator::kBootSection,
                                      flash + simulator::kFlashSize);
    const simulator::Image other = simulator::readImage(program("boot.elf"));
    machine.chip.program(other);
    machine.chip.reset(Reset::external);
    machine.run_ms(100);

    EXPECT_TRUE(std::equal(other.flash.begin(), other.flash.end(), flash));
    EXPECT_EQ(flash[simulator::kBootSection - 1], 0xFF) << "what was behind it is erased";
    EXPECT_TRUE(std::equal(loader.begin(), loader.end(), flash + simulator::kBootSection));
    EXPECT_EQ(machine.report(1).number, 1) << "and it runs";
}

static std::vector<int> words(const Machine& machine, int number) {
    std::vector<int> all;
    for (const Report& report : machine.reports)
        if (report.number == number) all.push_back(report.word());
    return all;
}

TEST(BootSection, the_second_boards_hides_the_cause_and_overwrites_memory_but_not_the_kept_part) {
    Machine machine("boot");
    machine.boot("apm2");
    machine.run_ms(1164);
    EXPECT_EQ(words(machine, 1).size(), 0u) << "it waits without USB for 1.1 s";
    machine.run_ms(3);
    EXPECT_EQ(words(machine, 1).size(), 1u) << "the application runs after that and the start-up";
    machine.run_ms(100);

    EXPECT_EQ(words(machine, 1), (std::vector<int>{0, 0}));
    EXPECT_EQ(words(machine, 2), (std::vector<int>{0, 0})) << "the watchdog is off";
    EXPECT_EQ(words(machine, 3).back(), 0xB0B0);
    EXPECT_EQ(words(machine, 4).back(), 0x5A);
}

TEST(BootSection, the_first_boards_hangs_after_a_watchdog_reset) {
    Machine machine("boot");
    machine.boot("apm1");
    int resets = 0;
    machine.chip.on_reset = [&resets] { ++resets; };
    machine.run_ms(3500);

    EXPECT_EQ(words(machine, 1), (std::vector<int>{0}));
    EXPECT_GT(resets, 10);
}

TEST(BootSection, the_reset_button_starts_either_board) {
    for (const char* board : {"apm1", "apm2"}) {
        Machine machine("boot");
        machine.boot(board);
        machine.run_ms(1167);
        machine.chip.reset(Reset::external);
        machine.run_ms(1167);
        EXPECT_EQ(words(machine, 1), (std::vector<int>{0, 0})) << board;
    }
}

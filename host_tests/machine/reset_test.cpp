// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine/machine.hpp"

using simulator::Reset;

enum Cause { kPowerOn = 1, kExternal = 2, kBrownOut = 4, kWatchdog = 8 };

TEST(Resets, the_watchdog_bites_15_ms_after_it_was_last_fed) {
    Machine machine("watchdog");
    machine.run_ms(60);

    EXPECT_EQ(machine.report(1).low, kPowerOn);
    EXPECT_EQ(machine.report(2).low, kWatchdog);
    EXPECT_NEAR(machine.cyclesBetween(0x80, 2) / 16000.0, 16, 1);
}

TEST(Resets, each_cause_is_told_and_memory_survives) {
    Machine machine("watchdog");
    machine.run_ms(60);
    machine.chip.reset(Reset::external);
    machine.run_ms(1);
    machine.chip.reset(Reset::brown_out);
    machine.run_ms(1);

    EXPECT_EQ(machine.report(3).low, kExternal);
    EXPECT_EQ(machine.report(4).low, kBrownOut);
}

TEST(Resets, whoever_drives_the_chip_is_told_of_each_and_the_speed_stays) {
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

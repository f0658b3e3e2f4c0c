// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.hpp"

static double volts(int pin) { return 0.1 + 0.3 * pin; }
static int counts(double v) { return static_cast<int>(v / 5 * 1024); }

class AdcTest : public testing::Test {
protected:
    AdcTest() {
        machine.chip.adc().volts = volts;
        machine.run_ms(10);
    }
    Machine machine{"adc"};
};

TEST_F(AdcTest, all_sixteen_pins_are_measured) {
    for (int pin = 0; pin < 16; pin++)
        EXPECT_EQ(machine.report(10 + pin).word(), counts(volts(pin))) << "A" << pin;
}

TEST_F(AdcTest, a_result_belongs_to_the_channel_chosen_at_the_start) {
    EXPECT_EQ(machine.report(2).word(), counts(volts(0)));
}

// Behind A0 with its 0.1 V: at 12 us 45 % of the difference are left.
TEST_F(AdcTest, the_band_gap_is_1_1_volts_once_it_has_settled) {
    EXPECT_NEAR(machine.report(5).word(), counts(0.65), 10);
    EXPECT_NEAR(machine.report(3).word(), counts(1.1), 1);
}

TEST_F(AdcTest, the_interrupt_brings_the_result) {
    EXPECT_EQ(machine.report(4).word(), counts(volts(12)));
}

TEST_F(AdcTest, a_conversion_takes_13_clocks_the_first_25) {
    constexpr int kClock = 128;
    EXPECT_NEAR(machine.cyclesBetween(1, 10), 25 * kClock, kClock);
    EXPECT_NEAR(machine.cyclesBetween(10, 11), 13 * kClock, kClock);
}

class AdcSleepTest : public testing::Test {
protected:
    AdcSleepTest() {
        machine.chip.adc().volts = volts;
        machine.run_ms(60);
    }
    Machine machine{"adc_sleep"};
};

TEST_F(AdcSleepTest, idle_starts_a_conversion_each_time_it_is_entered) {
    constexpr int kConversion = 13 * 128, kOverflow = 256 * 1024;
    EXPECT_NEAR(machine.report(1).low, kOverflow / kConversion, 6);
    EXPECT_EQ(machine.report(2).word(), counts(volts(3)));
}

TEST_F(AdcSleepTest, a_converter_that_is_off_stays_at_rest) { EXPECT_EQ(machine.report(3).low, 0); }

TEST_F(AdcSleepTest, without_its_interrupt_one_conversion_is_made_and_nobody_woken) {
    EXPECT_EQ(machine.report(4).low, 0);
    EXPECT_EQ(machine.report(5).low & 0x50, 0x10) << "done, its flag set";
}

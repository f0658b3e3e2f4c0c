// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"

namespace {

constexpr int kBrownOut = 2, kUnknown = 4;

struct HangTimer : Bench {
    HangTimer() : Bench("hang_timer") {}
    int causeAfterReset() {
        chip.reset(simulator::Reset::brown_out);
        chip.avr()->data[simulator::kMcusr] = 0;  // a bootloader's work
        chip.adc().supply_v = [] { return 5.0; };
        run_ms(100);
        return words(1).back();
    }
};

}  // namespace

TEST(HalGuard, calls_every_4_ms_once_nobody_has_touched_it_for_49_ms) {
    HangTimer bench;
    bench.run_ms(900);

    EXPECT_NEAR(static_cast<double>(bench.cyclesBetween(2, 3)) / 16000, 49, 5);
    const auto calls = bench.words(3).size();
    const double called_ms =
        static_cast<double>(bench.reports.back().cycle - bench.report(3).cycle) / 16000;
    EXPECT_NEAR(called_ms / static_cast<double>(calls - 1), 4.1, 0.1);
}

TEST(HalGuard, a_run_that_ends_on_a_sagging_supply_counts_as_a_brown_out) {
    HangTimer bench;
    bench.run_ms(300);
    bench.chip.adc().supply_v = [] { return 4.1; };
    bench.run_ms(10);

    EXPECT_EQ(bench.causeAfterReset(), kBrownOut);
}

TEST(HalGuard, a_run_that_ends_unannounced_on_a_steady_supply_has_no_known_cause) {
    HangTimer bench;
    bench.run_ms(300);

    EXPECT_EQ(bench.causeAfterReset(), kUnknown);
}

TEST(HalGuard, a_sag_is_forgotten_after_a_quarter_of_a_second) {
    HangTimer bench;
    bench.run_ms(300);
    bench.chip.adc().supply_v = [] { return 4.1; };
    bench.run_ms(10);
    bench.chip.adc().supply_v = [] { return 5.0; };
    bench.run_ms(100);
    EXPECT_EQ(bench.causeAfterReset(), kBrownOut);

    bench.run_ms(300);
    bench.chip.adc().supply_v = [] { return 4.1; };
    bench.run_ms(10);
    bench.chip.adc().supply_v = [] { return 5.0; };
    bench.run_ms(300);
    EXPECT_EQ(bench.causeAfterReset(), kUnknown);
}

TEST(HalGuard, nothing_is_stored_while_the_supply_sags) {
    HangTimer bench;
    const auto writesIn_ms = [&bench](int ms) {
        const uint64_t before = bench.chip.eeprom().writes();
        bench.run_ms(ms);
        return bench.chip.eeprom().writes() - before;
    };
    bench.run_ms(300);
    EXPECT_NEAR(writesIn_ms(400), 20, 1);
    bench.chip.adc().supply_v = [] { return 4.1; };
    EXPECT_LE(writesIn_ms(10), 1u);
    EXPECT_EQ(writesIn_ms(1500), 0u);
    bench.chip.adc().supply_v = [] { return 5.0; };
    EXPECT_EQ(writesIn_ms(200), 0u) << "for a quarter of a second";
    EXPECT_GT(writesIn_ms(500), 10u);
}

TEST(HalGuard, a_supply_that_stays_low_does_not_stop_the_storing) {
    HangTimer bench;
    bench.run_ms(300);
    bench.chip.adc().supply_v = [] { return 4.1; };
    bench.run_ms(2300);
    const uint64_t before = bench.chip.eeprom().writes();
    bench.run_ms(1000);
    EXPECT_GT(bench.chip.eeprom().writes(), before + 40);
}

TEST(HalGuard, its_own_conversions_are_not_counted_in_the_scans) {
    HangTimer bench;
    bench.chip.adc().volts = [](int) { return 2.5; };
    bench.run_ms(3000);

    EXPECT_GT(bench.words(4).size(), 100u);
    EXPECT_THAT(bench.words(4), testing::Each(512));
}

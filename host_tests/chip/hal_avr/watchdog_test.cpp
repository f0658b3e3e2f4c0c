// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"

using testing::ElementsAre;

namespace {
constexpr int kPowerOn = 0, kExternal = 1, kBrownOut = 2, kWatchdog = 3, kUnknown = 4, kAsked = 6;
}

TEST(HalWatchdog, leaves_a_fed_program_alone_and_starts_a_hung_one_again_after_125_ms) {
    Bench bench("watchdog");
    int resets = 0;
    bench.chip.on_reset = [&resets] { ++resets; };
    bench.run_ms(1500);

    ASSERT_THAT(bench.words(1), ElementsAre(kPowerOn, kWatchdog));
    const double bitten_ms = static_cast<double>(bench.reports[2].cycle - bench.reports[1].cycle);
    EXPECT_NEAR(bitten_ms / 16000, 125, 13);
    EXPECT_EQ(resets, 0);
}

// The loader of many clones; the stand-in is the first board's.
TEST(HalWatchdog, comes_back_behind_a_bootloader_that_loops_after_a_reset_by_the_watchdog) {
    Bench bench("watchdog");
    bench.boot("apm1");
    bench.run_ms(3500);  // it listens for a second, twice

    EXPECT_THAT(bench.words(1), ElementsAre(kUnknown, kWatchdog));
}

TEST(HalWatchdog, reboot_resets_within_15_ms_and_the_watchdog_is_off_afterwards) {
    Bench bench("watchdog");
    bench.run_ms(2500);

    ASSERT_THAT(bench.words(1), ElementsAre(kPowerOn, kWatchdog, kAsked));
    const auto asked = bench.report(3).cycle;
    EXPECT_NEAR(static_cast<double>(bench.reports.back().cycle - asked) / 16000, 16, 4);
}

TEST(HalWatchdog, distinguishes_the_causes_of_resets) {
    Bench bench("watchdog");
    bench.run_ms(100);
    bench.chip.reset(simulator::Reset::external);
    bench.run_ms(100);
    bench.chip.reset(simulator::Reset::brown_out);
    bench.run_ms(100);

    EXPECT_THAT(bench.words(1), ElementsAre(kPowerOn, kExternal, kBrownOut));
}

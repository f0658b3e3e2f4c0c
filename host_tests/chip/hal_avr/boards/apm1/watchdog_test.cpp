// SPDX-License-Identifier: GPL-3.0-or-later
// The first board's watchdog must never reset the chip: its bootloader would not come out again.
#include <gmock/gmock.h>

#include "host_tests/chip/hal_avr/bench.hpp"

using testing::ElementsAre;

namespace {

constexpr int kPowerOn = 0, kExternal = 1, kWatchdog = 3, kAsked = 6;

struct Watchdog : Bench {
    Watchdog() : Bench("watchdog") {
        chip.on_reset = [this] { ++resets; };
    }
    int resets = 0;
};

}  // namespace

TEST(Apm1Watchdog, starts_a_program_that_hangs_again_through_address_0) {
    Watchdog bench;
    bench.run_ms(1500);

    EXPECT_THAT(bench.words(1), ElementsAre(kPowerOn, kWatchdog));
    EXPECT_EQ(bench.resets, 0);
    const double bitten_ms = static_cast<double>(bench.reports[2].cycle - bench.reports[1].cycle);
    EXPECT_NEAR(bitten_ms / 16000, 125, 13);
}

TEST(Apm1Watchdog, reboot_comes_back_at_once_without_a_reset) {
    Watchdog bench;
    bench.run_ms(2500);

    ASSERT_THAT(bench.words(1), ElementsAre(kPowerOn, kWatchdog, kAsked));
    EXPECT_EQ(bench.resets, 0);
    const auto asked = bench.report(3).cycle;
    EXPECT_LT(static_cast<double>(bench.reports.back().cycle - asked) / 16000, 1);
}

TEST(Apm1Watchdog, a_reset_after_a_restart_is_reported_as_a_reset) {
    Watchdog bench;
    bench.run_ms(1500);
    bench.chip.reset(simulator::Reset::external);
    bench.run_ms(100);

    EXPECT_THAT(bench.words(1), ElementsAre(kPowerOn, kWatchdog, kExternal));
}

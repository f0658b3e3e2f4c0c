// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"

using testing::Each;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

uint32_t time_us(const Bench& bench, int number) {
    return static_cast<uint32_t>(bench.report(number).word()) |
           static_cast<uint32_t>(bench.report(number + 1).word()) << 16;
}

}  // namespace

TEST(HalClock, gives_the_chips_own_time) {
    Bench bench("clock");
    bench.runTo(5, 4000);

    const double passed_us = static_cast<double>(bench.cyclesBetween(1, 3)) / 16;
    EXPECT_NEAR(time_us(bench, 3) - time_us(bench, 1), passed_us, 2);
    EXPECT_NEAR(bench.report(5).word(), static_cast<double>(bench.report(5).cycle) / 16000, 1);
}

TEST(HalClock, never_goes_back_nor_leaps_at_any_phase_of_the_overflow) {
    Bench bench("clock");
    bench.runTo(5, 4000);

    EXPECT_THAT(bench.words(0x10), IsEmpty());  // us leapt
    EXPECT_THAT(bench.words(0x11), IsEmpty());  // ms leapt
    EXPECT_THAT(bench.words(0x12), IsEmpty());  // ms and us disagree
}

TEST(HalClock, goes_on_while_the_overflow_waits_to_be_served) {
    Bench bench("clock");
    bench.runTo(5, 4000);

    EXPECT_THAT(bench.words(0x13), IsEmpty());
    EXPECT_THAT(bench.words(0x20), SizeIs(20));
    EXPECT_THAT(bench.words(0x20), Each(1));  // it did wait
}

TEST(HalClock, idle_sleeps_until_the_next_interrupt) {
    Bench bench("idle");
    bench.run_ms(500);

    EXPECT_GT(bench.chip.asleepCycles(), 16000u * 496);
}

TEST(HalClock, idle_wakes_every_four_milliseconds_when_nothing_happens) {
    constexpr int kCompare = 47, kOverflow = 50;
    Bench bench("idle");
    bench.run_ms(500);

    const auto& interrupts = bench.chip.interrupts();
    EXPECT_NEAR(interrupts.count(kCompare).runs, 125, 3);
    EXPECT_EQ(interrupts.count(kOverflow).runs, 15u);
}

TEST(HalClock, idle_does_not_sleep_over_work_that_comes_at_any_moment) {
    Bench bench("idle");
    bench.run_ms(1);

    for (int i = 1; i <= 400; ++i) {
        bench.chip.drive('E', 6, true);
        ASSERT_TRUE(bench.chip.run(bench.chip.cycle() + 200 + i % 80));
        ASSERT_EQ(bench.words(1).size(), static_cast<size_t>(i));
        bench.chip.drive('E', 6, false);
    }
}

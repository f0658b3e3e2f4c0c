// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "bench.hpp"

namespace {
constexpr int kVector = 7;  // INT6
}

TEST(HalImuInterrupt, calls_the_firmware_once_for_every_rising_edge) {
    Bench bench("imu");
    bench.run_ms(1);

    for (int i = 0; i < 200; ++i) {
        bench.chip.drive('E', 6, true);
        bench.run_ms(0.1 + 0.001 * i);
        bench.chip.drive('E', 6, false);
        bench.run_ms(0.1);
    }

    EXPECT_EQ(bench.words(1).back(), 200);
    EXPECT_EQ(bench.chip.interrupts().count(kVector).runs, 200u);
}

TEST(HalImuInterrupt, an_edge_during_a_locked_bus_is_served_after_it) {
    Bench bench("imu");
    bench.run_ms(1);
    int inside = 0;
    for (int i = 1; i <= 100; ++i) {
        bench.runTo(2);  // the bus has just been locked
        ASSERT_TRUE(bench.chip.run(bench.chip.cycle() + i));
        bench.chip.drive('E', 6, true);
        inside += bench.runTo(3).word() == i;
        EXPECT_EQ(bench.runTo(1).word(), i);
        bench.chip.drive('E', 6, false);
    }
    EXPECT_EQ(inside, 0);
}

TEST(HalImuInterrupt, the_interrupt_itself_is_within_its_cost) {
    Bench bench("imu");
    bench.run_ms(1);
    bench.chip.drive('E', 6, true);
    bench.run_ms(1);

    EXPECT_LE(bench.longest(kVector), 100u);
}

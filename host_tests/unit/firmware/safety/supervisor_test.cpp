// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/supervisor.hpp"

#include <gtest/gtest.h>

#include "scheduler/scheduler.hpp"

namespace {

using scheduler::Tier;
constexpr uint8_t kFast = scheduler::bitOf(Tier::fast), kMedium = scheduler::bitOf(Tier::medium),
                  kSlow = scheduler::bitOf(Tier::slow);

// Frames until the dog is no longer fed when these tiers run as often as they do, and `silent`
// stops after a while; 0: never in ten seconds.
int fedFor(uint8_t silent) {
    firmware::safety::Supervisor supervisor;
    constexpr int kFrom = 300;
    for (int frame = 0; frame < kFrom + 1000; ++frame) {
        uint8_t served = kFast;
        if (frame % 2 == 0) served |= kMedium;
        if (frame % 10 == 5) served |= kSlow;
        if (frame >= kFrom) served &= static_cast<uint8_t>(~silent);
        if (!supervisor.wellAfter(served)) return frame - kFrom;
    }
    return 0;
}

}  // namespace

TEST(Supervisor, feeds_while_every_tier_runs) { EXPECT_EQ(fedFor(0), 0); }

TEST(Supervisor, stops_soon_after_one_tier_has_stopped) {
    EXPECT_EQ(fedFor(kFast), 2);
    EXPECT_NEAR(fedFor(kMedium), 20, 2);
    EXPECT_NEAR(fedFor(kSlow), 45, 2);
}

TEST(Supervisor, feeds_the_watchdog_while_a_tier_is_only_deferred) {
    firmware::safety::Supervisor supervisor;
    for (int frame = 0; frame < 1000; ++frame) {
        uint8_t served = kFast;
        if (frame % (2 + scheduler::kMediumPatience) == 0) served |= kMedium;
        if (frame % (10 + scheduler::kSlowPatience) == 0) served |= kSlow;
        EXPECT_TRUE(supervisor.wellAfter(served)) << frame;
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/rc_override.hpp"

#include "firmware_bench.hpp"

namespace {

using namespace firmware::sensors;

struct RcOverride : bench::Bench {
    static void hold(uint16_t roll_us) {
        setRcOverride({roll_us, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX, UINT16_MAX,
                       UINT16_MAX, UINT16_MAX});
    }
    uint16_t pulse_us = 0;
};

TEST_F(RcOverride, lasts_for_three_seconds) {
    hold(1700);
    fakes::advance_ms(3000);
    EXPECT_TRUE(rcOverride(0, pulse_us));
    EXPECT_EQ(pulse_us, 1700);
    fakes::advance_ms(1);
    EXPECT_FALSE(rcOverride(0, pulse_us));
    EXPECT_FALSE(rcOverridden());
}

TEST_F(RcOverride, holds_the_channels_that_were_given_and_leaves_those_of_65535) {
    hold(1700);
    EXPECT_FALSE(rcOverride(1, pulse_us));
    hold(UINT16_MAX);
    EXPECT_TRUE(rcOverride(0, pulse_us)) << "as before";
    hold(0);
    EXPECT_FALSE(rcOverride(0, pulse_us)) << "given back";
}

TEST_F(RcOverride, is_over_when_it_is_released) {
    hold(1700);
    ASSERT_TRUE(rcOverridden());
    rcOverrideRelease();
    EXPECT_FALSE(rcOverridden());
    EXPECT_FALSE(rcOverride(0, pulse_us));
}

}  // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/battery.hpp"

#include <gtest/gtest.h>

namespace {

using drivers::Battery;
using drivers::BatterySettings;

TEST(Battery, measures_volts_and_amperes_through_the_power_module) {
    Battery battery;
    const double volts_in = 11.1 / 10.1, amps_in = 8.5 / 17;
    battery.update(static_cast<float>(volts_in / 5 * 1024), static_cast<float>(amps_in / 5 * 1024),
                   5000, 0.1f, BatterySettings());

    EXPECT_NEAR(battery.voltage_v(), 11.1, 0.01);
    EXPECT_NEAR(battery.current_a(), 8.5, 0.01);
}

TEST(Battery, sums_up_the_charge_and_leaves_gaps_out) {
    Battery battery;
    const float reading = static_cast<float>(10.0 / 17 / 5 * 1024);
    for (int i = 0; i < 3600; ++i) battery.update(225, reading, 5000, 0.1f, BatterySettings());
    EXPECT_NEAR(battery.consumed_mah(), 1000, 1);

    battery.update(225, reading, 5000, 3.0f, BatterySettings());
    EXPECT_NEAR(battery.consumed_mah(), 1000, 1);
}

TEST(Battery, the_boards_own_supply_is_taken_into_account_within_4_to_6_volts) {
    EXPECT_EQ(drivers::boardSupply_mv(225), 5006);
    EXPECT_EQ(drivers::boardSupply_mv(0), 5000);
    EXPECT_EQ(drivers::boardSupply_mv(1), 6000);
    EXPECT_EQ(drivers::boardSupply_mv(1023), 4000);
}

}  // namespace

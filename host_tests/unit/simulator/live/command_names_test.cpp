// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/command_names.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace simulator;
using namespace simulator::live;

TEST(CommandName, is_the_fields) {
    EXPECT_EQ(commandName(16), "WAYPOINT");
    EXPECT_EQ(commandName(177), "JUMP");
    EXPECT_EQ(commandName(9999), "command 9999");
}

TEST(ItemText, has_height_and_numbers) {
    WaypointItem item;
    item.command = 18;
    item.frame = 3;
    item.altitude_m = 60.04;
    item.params = {2, 0, -50, std::nan("")};
    EXPECT_EQ(itemText(item), "60 m above home, p1 2, p3 -50");
    item.frame = 0;
    item.params = {};
    EXPECT_EQ(itemText(item), "60 m above sea");
    item.command = 177;
    EXPECT_EQ(itemText(item), "");
}

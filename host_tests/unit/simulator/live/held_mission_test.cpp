// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/held_mission.hpp"

#include <gtest/gtest.h>

#include "talking_board.hpp"

using namespace simulator;
using namespace simulator::live;

TEST(HeldMission, is_what_was_sent_up) {
    Fence fence;
    fence.areas = {{true, {{47, 8}, {47, 9}, {48, 9}}, 0},
                   {true, {{46, 8}, {46, 9}, {45, 9}}, 0},
                   {false, {{47.1, 8.1}, {47.1, 8.2}, {47.2, 8.2}, {47.2, 8.1}}, 0},
                   {false, {{47.3, 8.3}}, 80}};
    fence.way_back = Place{47.05, 8.05};
    const Waypoints mission = {itemAt(0, 16, 47, 8, 488)};

    const MissionFile held =
        heldMission(mission, fenceItems(fence), rallyItems({{{47.4, 8.4}, 70}}));

    EXPECT_EQ(held.items.size(), 1u);
    ASSERT_EQ(held.fence.areas.size(), 4u);
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(held.fence.areas[i].inclusion, fence.areas[i].inclusion) << i;
        EXPECT_EQ(held.fence.areas[i].rim.size(), fence.areas[i].rim.size()) << i;
        EXPECT_EQ(held.fence.areas[i].rim[0].latitude_deg, fence.areas[i].rim[0].latitude_deg);
    }
    EXPECT_EQ(held.fence.areas[3].radius_m, 80);
    ASSERT_TRUE(held.fence.way_back);
    EXPECT_EQ(held.fence.way_back->longitude_deg, 8.05);
    ASSERT_EQ(held.rally.size(), 1u);
    EXPECT_EQ(held.rally[0].height_m, 70);
}

TEST(HeldMission, leaves_out_a_polygon_that_is_cut_short) {
    Waypoints corners = {itemAt(0, 5001, 47, 8, 0), itemAt(1, 5001, 48, 8, 0)};
    corners[0].params[0] = corners[1].params[0] = 3;

    EXPECT_TRUE(heldMission({}, corners, {}).fence.areas.empty());
    EXPECT_TRUE(heldMission({}, {itemAt(0, 5001, 47, 8, 0)}, {}).fence.areas.empty());
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Fence and rally points one by one, as they were sent before the mission protocol had them.
#include "firmware/gcs/legacy_points.hpp"

#include <cmath>

#include "firmware/mission/fence_line.hpp"
#include "points_ground.hpp"

using doubles::lists;

namespace ground {
namespace {

mavlink::FencePoint fencePoint(uint8_t index, uint8_t total) {
    const auto& corner = kSquare[(index + 3) % 4];
    auto message = toVehicle<mavlink::FencePoint>();
    message.idx = index;
    message.count = total;
    message.lat = static_cast<float>((kNorth_e7 + (index == 0 ? 0 : corner[0])) * 1e-7);
    message.lng = static_cast<float>((kEast_e7 + (index == 0 ? 0 : corner[1])) * 1e-7);
    return message;
}

class OldPoints : public Points {
protected:
    std::vector<mavlink::FencePoint> fetchFence(uint8_t index) {
        auto message = toVehicle<mavlink::FenceFetchPoint>();
        message.idx = index;
        return ask<mavlink::FencePoint>(message, 200);
    }
    // As MAVProxy's older fence module: each point is read back before the next is sent.
    void sendFence(uint8_t total) {
        EXPECT_EQ(setParameter("FENCE_TOTAL", total), total);
        live_ms(200);
        for (uint8_t index = 0; index < total; ++index) {
            give(fencePoint(index, total));
            live_ms(200);
            const auto back = fetchFence(index);
            ASSERT_EQ(back.size(), 1u) << int(index);
            EXPECT_NEAR(back[0].lat, fencePoint(index, total).lat, 1e-6) << int(index);
            EXPECT_NEAR(back[0].lng, fencePoint(index, total).lng, 1e-6) << int(index);
            EXPECT_EQ(back[0].count, total);
        }
    }
};

TEST_F(OldPoints, a_fence_is_made_of_a_return_point_and_corners_of_which_the_first_comes_twice) {
    sendFence(6);
    EXPECT_EQ(firmware::mission::fenceLine(), firmware::mission::Line::fit);
    const Items items = download(kFence);
    ASSERT_EQ(items.size(), 5u);
    EXPECT_EQ(items[0].command, +MavCmd::nav_fence_return_point);
    for (int i = 1; i < 5; ++i) {
        EXPECT_EQ(items[i].command, +MavCmd::nav_fence_polygon_vertex_inclusion);
        EXPECT_EQ(items[i].param1, 4);
        EXPECT_NEAR(items[i].x, kNorth_e7 + kSquare[i - 1][0], 50);
    }
}

TEST_F(OldPoints, a_fence_of_the_mission_protocol_is_seen_point_by_point) {
    Items items = square();
    std::rotate(items.begin(), items.begin() + 1, items.end());  // the return point last
    upload(items, kFence);
    EXPECT_EQ(parameters.fence_total, 6);
    EXPECT_NEAR(fetchFence(0).at(0).lat, kNorth_e7 * 1e-7, 1e-5);
    for (uint8_t index = 1; index < 6; ++index)
        EXPECT_NEAR(fetchFence(index).at(0).lat, (kNorth_e7 + kSquare[(index - 1) % 4][0]) * 1e-7,
                    1e-5);
    station.forget();
    EXPECT_TRUE(fetchFence(6).empty());
    EXPECT_EQ(station.texts(), std::vector<std::string>{"Point 6 refused"});
}

TEST_F(OldPoints, a_fence_that_is_not_closed_is_refused) {
    sendFence(6);
    station.forget();
    give(fencePoint(5, 6));
    EXPECT_TRUE(station.texts().empty());
    auto open = fencePoint(5, 6);
    open.lat += 1e-3f;
    give(open);
    EXPECT_EQ(station.texts(), std::vector<std::string>{"Point 5 refused"});
}

TEST_F(OldPoints, a_fence_is_blank_and_not_fit_until_all_its_points_are_there) {
    EXPECT_EQ(setParameter("FENCE_TOTAL", 6), 6);
    live_ms(200);
    EXPECT_EQ(firmware::mission::fenceLine(), firmware::mission::Line::unfit);
    EXPECT_EQ(fetchFence(3).at(0).lat, 0);
    for (uint8_t total : {1, 4}) EXPECT_EQ(setParameter("FENCE_TOTAL", total), 6);
    EXPECT_EQ(setParameter("FENCE_TOTAL", 0), 0);
    live_ms(200);
    EXPECT_EQ(firmware::mission::fenceLine(), firmware::mission::Line::none);
}

TEST_F(OldPoints, a_fence_that_is_on_is_not_changed_point_by_point) {
    upload(square(), kFence);
    parameters.fence_action = 2;
    ASSERT_TRUE(firmware::safety::fenceEnable(1));
    give(fencePoint(2, 6));
    EXPECT_EQ(station.texts().back(), "Point 2 refused");
    EXPECT_EQ(setParameter("FENCE_TOTAL", 0), 6);
}

TEST_F(OldPoints, a_fence_with_zones_is_cleared_but_neither_seen_nor_changed) {
    const std::vector<std::string> why{"Fence has zones that are no points"};
    upload(zones(), kFence);
    EXPECT_EQ(parameters.fence_total, 0);
    station.forget();
    EXPECT_TRUE(fetchFence(0).empty());
    EXPECT_EQ(station.texts(), why);
    station.forget();
    give(fencePoint(2, 6));
    EXPECT_EQ(station.texts(), why);
    for (const float total : {6.0f, 11.0f, 12.0f}) {
        station.forget();
        EXPECT_EQ(setParameter("FENCE_TOTAL", total), 0);
        EXPECT_EQ(station.texts().at(0), why[0]) << total;
    }
    expectSame(download(kFence), zones());
    EXPECT_EQ(setParameter("FENCE_TOTAL", 0), 0);
    live_ms(500);
    EXPECT_TRUE(download(kFence).empty());
    sendFence(6);
}

TEST_F(OldPoints, a_point_is_refused_during_another_stations_upload) {
    upload(square(), kFence);
    second.send(count(3, kRally));
    run_ms(20);
    give(fencePoint(2, 6));
    EXPECT_EQ(station.texts().back(), "Point 2 not stored");
    EXPECT_EQ(lists.kind, firmware::mission::ListKind::rally);
    EXPECT_TRUE(lists.staging);
}

TEST_F(OldPoints, a_point_is_stored_though_the_store_is_slow) {
    upload(square(), kFence);
    lists.slow = 30;
    auto moved = fencePoint(2, 6);
    moved.lat += 1e-3f;
    give(moved);
    second.send(count(3, kRally));
    live_ms(500);
    EXPECT_NEAR(fetchFence(2).at(0).lat, moved.lat, 1e-6);
    EXPECT_EQ(acks(second, kRally), Results{MavMissionResult::denied});
}

TEST_F(OldPoints, a_point_that_is_given_up_is_named) {
    EXPECT_EQ(setParameter("FENCE_TOTAL", 6), 6);
    EXPECT_EQ(setParameter("RALLY_TOTAL", 2), 2);
    live_ms(200);
    station.forget();
    lists.slow = 1000;
    give(fencePoint(3, 6));
    live_ms(1500);
    EXPECT_EQ(station.texts(), std::vector<std::string>{"Point 3 refused"});
    live_ms(3000);
    auto rally = toVehicle<mavlink::RallyPoint>();
    rally.idx = 1;
    rally.count = 2;
    give(rally);
    live_ms(1500);
    EXPECT_EQ(station.texts(), std::vector<std::string>{"Point 1 refused"});
}

TEST_F(OldPoints, rally_points_one_by_one) {
    EXPECT_EQ(setParameter("RALLY_TOTAL", 2), 2);
    live_ms(200);
    auto point = toVehicle<mavlink::RallyPoint>();
    point.lat = kNorth_e7;
    point.lng = kEast_e7;
    point.alt = -42;
    point.idx = 1;
    point.count = 2;
    give(point);
    auto fetch = toVehicle<mavlink::RallyFetchPoint>();
    fetch.idx = 1;
    const auto back = ask<mavlink::RallyPoint>(fetch, 100);
    ASSERT_EQ(back.size(), 1u);
    EXPECT_EQ(back[0].lat, kNorth_e7);
    EXPECT_EQ(back[0].alt, -42);
    EXPECT_EQ(back[0].count, 2);

    point.count = 3;
    give(point);
    fetch.idx = 2;
    give(fetch);
    EXPECT_EQ(station.texts(), (std::vector<std::string>{"Point 1 refused", "Point 2 refused"}));
}

}  // namespace
}  // namespace ground

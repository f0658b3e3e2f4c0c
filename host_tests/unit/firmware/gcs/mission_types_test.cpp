// SPDX-License-Identifier: GPL-3.0-or-later
// Fence and rally points by the mission protocol.
#include "firmware/gcs/mission_types.hpp"

#include <cmath>

#include "firmware/mission/fence_line.hpp"
#include "points_ground.hpp"

using doubles::lists;

namespace ground {
namespace {

TEST_F(Points, a_fence_goes_up_and_comes_down_the_same) {
    EXPECT_EQ(upload(square(), kFence), Results{MavMissionResult::accepted});
    EXPECT_EQ(station.texts(), std::vector<std::string>{"Fence stored: 5 points"});
    expectSame(download(kFence), square());
    EXPECT_TRUE(doubles::plan.items.empty());
}

// As QGroundControl orders them: polygons, circles, the return point.
TEST_F(Points, zones_go_up_and_come_down_the_same) {
    const Items items = zones();
    EXPECT_EQ(upload(items, kFence), Results{MavMissionResult::accepted});
    EXPECT_EQ(station.texts(), std::vector<std::string>{"Fence stored: 11 points"});
    expectSame(download(kFence), items);
    live_ms(500);
    EXPECT_EQ(firmware::mission::fenceLine(), firmware::mission::Line::fit);
}

TEST_F(Points, a_zone_that_is_refused_is_named) {
    upload(square(), kFence);
    for (const size_t wrong : {size_t{2}, size_t{6}, size_t{8}, size_t{10}}) {
        Items items = zones();
        items[wrong].param1 = 0;
        station.forget();
        EXPECT_EQ(upload(items, kFence), Results{MavMissionResult::invalid_param1}) << wrong;
        EXPECT_EQ(station.texts(), std::vector<std::string>{"Item " + std::to_string(wrong) +
                                                            " refused: corners or radius"});
    }
    expectSame(download(kFence), square());
}

TEST_F(Points, rally_points_go_up_and_come_down_the_same) {
    EXPECT_EQ(upload(threeRallyPoints(), kRally), Results{MavMissionResult::accepted});
    EXPECT_EQ(station.texts(), std::vector<std::string>{"Rally stored: 3 points"});
    expectSame(download(kRally), threeRallyPoints());
    EXPECT_EQ(parameters.rally_total, 3);
}

TEST_F(Points, the_return_point_may_stand_anywhere) {
    Items items = square();
    std::rotate(items.begin(), items.begin() + 3, items.end());
    upload(items, kFence);
    expectSame(download(kFence), items);
    EXPECT_EQ(firmware::mission::fenceLine(), firmware::mission::Line::fit);
}

TEST_F(Points, more_than_there_is_room_for_is_refused) {
    give(count(21, kFence));
    EXPECT_EQ(acks(station, kFence), Results{MavMissionResult::no_space});
    give(count(11, kRally));
    EXPECT_EQ(acks(station, kRally), Results{MavMissionResult::no_space});
}

TEST_F(Points, an_unknown_list_is_unsupported) {
    give(count(2, 77));
    EXPECT_EQ(acks(station, 77), Results{MavMissionResult::unsupported});
    auto list = toVehicle<mavlink::MissionRequestList>();
    list.mission_type = 77;
    give(list);
    EXPECT_EQ(acks(station, 77), Results{MavMissionResult::unsupported});
}

struct Wrong {
    const char* what;
    Results result;
    void (*damage)(mavlink::MissionItemInt&);
    uint8_t type = kFence;
};
TEST_F(Points, unsupported_points_are_refused_and_the_old_list_stays) {
    const Wrong cases[] = {
        {"of an exclusion", {MavMissionResult::invalid_param1}, [](auto& i) { i.command = 5002; }},
        {"a circle", {MavMissionResult::invalid_param1}, [](auto& i) { i.command = 5003; }},
        {"of another one", {MavMissionResult::invalid_param1}, [](auto& i) { i.param1 = 3; }},
        {"a waypoint", {MavMissionResult::unsupported}, [](auto& i) { i.command = 16; }},
        {"above terrain", {MavMissionResult::unsupported_frame}, [](auto& i) { i.frame = 10; }},
        {"no place", {MavMissionResult::invalid_param5_x}, [](auto& i) { i.x = 900000001; }},
        {"nowhere", {MavMissionResult::invalid_param5_x}, [](auto& i) { i.x = i.y = 0; }},
        {"no height", {MavMissionResult::invalid_param7}, [](auto& i) { i.z = NAN; }, kRally},
        {"a waypoint", {MavMissionResult::unsupported}, [](auto& i) { i.command = 16; }, kRally},
    };
    upload(square(), kFence);
    upload(threeRallyPoints(), kRally);
    for (const Wrong& each : cases) {
        Items items = each.type == kFence ? square() : threeRallyPoints();
        each.damage(items[2]);
        EXPECT_EQ(upload(items, each.type), each.result) << each.what;
    }
    expectSame(download(kFence), square());
    expectSame(download(kRally), threeRallyPoints());
}

TEST_F(Points, an_item_of_another_list_does_not_get_into_this_one) {
    give(count(3, kRally));
    auto stray = square()[1];
    stray.seq = 0;
    give(stray);
    EXPECT_EQ(acks(station, kFence), Results{MavMissionResult::error});
    EXPECT_EQ(lists.staged.size(), 0u);
}

TEST_F(Points, a_part_is_replaced) {
    upload(threeRallyPoints(), kRally);
    auto part = toVehicle<mavlink::MissionWritePartialList>();
    part.start_index = part.end_index = 1;
    part.mission_type = kRally;
    give(part);
    Items items = threeRallyPoints();
    items[1].z = 77;
    items[1].seq = 1;
    give(items[1]);
    EXPECT_EQ(acks(station, kRally), Results{MavMissionResult::accepted});
    expectSame(download(kRally), items);
}

TEST_F(Points, a_part_of_a_fence_is_replaced_where_it_fits_to_the_rest) {
    const auto replace = [&](uint16_t seq, mavlink::MissionItemInt item) {
        auto part = toVehicle<mavlink::MissionWritePartialList>();
        part.start_index = part.end_index = static_cast<int16_t>(seq);
        part.mission_type = kFence;
        station.forget();
        give(part);
        item.seq = seq;
        give(item);
        const Results results = acks(station, kFence);
        live_ms(200);
        return results;
    };
    Items items = zones();
    upload(items, kFence);
    for (const uint16_t moved : {uint16_t{0}, uint16_t{5}, uint16_t{8}, uint16_t{10}}) {
        items[moved].x += 100;
        EXPECT_EQ(replace(moved, items[moved]), Results{MavMissionResult::accepted}) << moved;
        expectSame(download(kFence), items);
    }
    for (const uint16_t corner : {uint16_t{0}, uint16_t{5}, uint16_t{6}}) {
        EXPECT_EQ(replace(corner, items[8]), Results{MavMissionResult::invalid_param1}) << corner;
        expectSame(download(kFence), items);
    }
}

TEST_F(Points, a_part_is_given) {
    upload(square(), kFence);
    auto part = toVehicle<mavlink::MissionRequestPartialList>();
    part.mission_type = kFence;
    part.start_index = part.end_index = 2;
    const auto items = ask<mavlink::MissionItemInt>(part);
    ASSERT_EQ(items.size(), 1u);
    EXPECT_EQ(items[0].seq, 2);
    EXPECT_EQ(items[0].x, square()[2].x);

    part.end_index = -1;
    EXPECT_EQ(ask<mavlink::MissionCount>(part).at(0).count, 3);

    part.end_index = 5;
    give(part);
    EXPECT_EQ(acks(station, kFence), Results{MavMissionResult::invalid_sequence});
}

TEST_F(Points, one_list_is_cleared_or_all) {
    doubles::plan.items.resize(3);
    upload(square(), kFence);
    upload(threeRallyPoints(), kRally);
    auto clear = toVehicle<mavlink::MissionClearAll>();
    clear.mission_type = kFence;
    give(clear);
    EXPECT_EQ(acks(station, kFence), Results{MavMissionResult::accepted});
    EXPECT_TRUE(download(kFence).empty());
    EXPECT_EQ(download(kRally).size(), 3u);

    clear.mission_type = MavMissionType::all;
    give(clear);
    EXPECT_EQ(acks(station, MavMissionType::all), Results{MavMissionResult::accepted});
    EXPECT_TRUE(download(kRally).empty());
    EXPECT_TRUE(doubles::plan.items.empty());
}

TEST_F(Points, a_second_station_on_the_same_link_is_denied_until_the_first_is_done) {
    give(count(5, kFence));
    station.forget();
    station.system = 254;
    for (const uint8_t type : {uint8_t{0}, kFence, kRally}) {
        give(count(2, type));
        EXPECT_EQ(acks(station, type), Results{MavMissionResult::denied});
        auto clear = toVehicle<mavlink::MissionClearAll>();
        clear.mission_type = type;
        give(clear);
        EXPECT_EQ(acks(station, type), Results{MavMissionResult::denied});
    }
    auto intruder = square()[0];
    give(intruder);
    EXPECT_EQ(acks(station, kFence), Results{MavMissionResult::denied});
    auto give_up = toVehicle<mavlink::MissionAck>();
    give_up.type = MavMissionResult::operation_cancelled;
    give(give_up);

    station.system = 255;
    Items items = square();
    for (uint16_t seq = 0; seq < 5; ++seq) {
        items[seq].seq = seq;
        give(items[seq]);
    }
    EXPECT_EQ(acks(station, kFence), Results{MavMissionResult::accepted});
}

TEST_F(Points, an_upload_of_a_lost_station_times_out_for_the_others) {
    second.send(count(5, kFence));
    run_ms(20);
    give(count(3, kRally));
    EXPECT_EQ(acks(station, kRally), Results{MavMissionResult::denied});

    live_ms(10000);
    EXPECT_EQ(acks(second, kFence), Results{MavMissionResult::operation_cancelled});
    EXPECT_EQ(upload(threeRallyPoints(), kRally), Results{MavMissionResult::accepted});
}

TEST_F(Points, the_capabilities_say_so) {
    command(MavCmd::request_autopilot_capabilities);
    const auto capabilities = station.all<mavlink::AutopilotVersion>().at(0).capabilities;
    EXPECT_NE(capabilities & mavlink::MavProtocolCapability::mission_fence, 0u);
    EXPECT_NE(capabilities & mavlink::MavProtocolCapability::mission_rally, 0u);
}

TEST_F(Points, the_fence_is_switched_by_command_and_shown_in_sys_status) {
    constexpr uint32_t kBit = mavlink::MavSysStatusSensor::geofence;
    const auto status = [&] {
        command(MavCmd::request_message, mavlink::Wire<mavlink::SysStatus>::id);
        return station.all<mavlink::SysStatus>().at(0);
    };
    EXPECT_EQ(command(MavCmd::do_fence_enable, 1), +mavlink::MavResult::denied);
    EXPECT_EQ(status().onboard_control_sensors_present & kBit, 0u);
    EXPECT_NE(status().onboard_control_sensors_health & kBit, 0u) << "none is not a broken one";
    upload(square(), kFence);
    EXPECT_NE(status().onboard_control_sensors_present & kBit, 0u);
    EXPECT_EQ(status().onboard_control_sensors_enabled & kBit, 0u);
    parameters.fence_action = 1;
    EXPECT_EQ(command(MavCmd::do_fence_enable, 1), +mavlink::MavResult::accepted);
    EXPECT_NE(status().onboard_control_sensors_enabled & kBit, 0u);
    EXPECT_NE(status().onboard_control_sensors_health & kBit, 0u);
    EXPECT_EQ(command(MavCmd::do_fence_enable, 2), +mavlink::MavResult::accepted);
    EXPECT_EQ(command(MavCmd::do_fence_enable, 3), +mavlink::MavResult::denied);
    EXPECT_EQ(command(MavCmd::do_fence_enable, 0), +mavlink::MavResult::accepted);
    EXPECT_EQ(status().onboard_control_sensors_enabled & kBit, 0u);
}

}  // namespace
}  // namespace ground

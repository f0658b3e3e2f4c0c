// SPDX-License-Identifier: GPL-3.0-or-later
// Fence and rally points by the mission protocol, and one by one as they were sent before it.
#include <algorithm>
#include <cmath>

#include "firmware/mission/fence_line.hpp"
#include "firmware/mission/rally.hpp"
#include "ground.hpp"

using doubles::lists;
using firmware::state::parameters;
using ground::Framing;
using ground::Station;
using ground::Telemetry;
using mavlink::MavCmd;
using mavlink::MavMissionResult;
using mavlink::MavMissionType;

namespace {

constexpr uint8_t kFence = MavMissionType::fence, kRally = MavMissionType::rally;
constexpr int32_t kNorth_e7 = 473977000, kEast_e7 = 85456000;
constexpr int kSquare[4][2] = {{-9000, -9000}, {-9000, 9000}, {9000, 9000}, {9000, -9000}};

template <class Message>
Message toVehicle() {
    Message message = {};
    message.target_system = message.target_component = 1;
    return message;
}

mavlink::MissionCount count(uint16_t items, uint8_t type) {
    auto message = toVehicle<mavlink::MissionCount>();
    message.count = items;
    message.mission_type = type;
    return message;
}

mavlink::MissionItemInt item(uint8_t type, uint16_t command, int32_t x, int32_t y) {
    auto message = toVehicle<mavlink::MissionItemInt>();
    message.command = command;
    message.frame = 3;
    message.x = x;
    message.y = y;
    message.mission_type = type;
    return message;
}
using Items = std::vector<mavlink::MissionItemInt>;

// A return point, and a square about it.
Items square() {
    Items items = {item(kFence, MavCmd::nav_fence_return_point, kNorth_e7, kEast_e7)};
    for (const auto& corner : kSquare) {
        items.push_back(item(kFence, MavCmd::nav_fence_polygon_vertex_inclusion,
                             kNorth_e7 + corner[0], kEast_e7 + corner[1]));
        items.back().param1 = 4;
    }
    return items;
}
Items threeRallyPoints() {
    Items items;
    for (int i = 0; i < 3; ++i) {
        items.push_back(item(kRally, MavCmd::nav_rally_point, kNorth_e7 + i, kEast_e7 - i));
        items.back().z = 10.25f * static_cast<float>(i) - 5;
    }
    items[2].frame = 0;
    return items;
}

using Results = std::vector<int>;

class Points : public Telemetry {
protected:
    void SetUp() override {
        Telemetry::SetUp();
        station.framing = second.framing = Framing::v2;
        firmware::safety::runFence();
        firmware::mission::rallyFollow();
    }
    // As Telemetry's, and what follows the lists at 10 Hz.
    void live_ms(uint32_t time_ms) {
        for (uint32_t ms = 0; ms < time_ms; ms += 100) {
            run_ms(100);
            firmware::safety::runFence();
            firmware::mission::rallyFollow();
        }
    }
    template <class Message>
    void give(const Message& message) {
        station.send(message);
        run_ms(20);
    }
    Results acks(Station& from, uint8_t type) {
        Results results;
        for (const auto& ack : from.all<mavlink::MissionAck>()) {
            EXPECT_EQ(ack.mission_type, type);
            results.push_back(ack.type);
        }
        return results;
    }
    Results upload(const Items& items, uint8_t type) {
        give(count(static_cast<uint16_t>(items.size()), type));
        for (uint16_t seq = 0; seq < items.size(); ++seq) {
            const auto asked = station.all<mavlink::MissionRequestInt>();
            if (asked.size() != 1 || asked[0].seq != seq || asked[0].mission_type != type) break;
            auto each = items[seq];
            each.seq = seq;
            give(each);
        }
        const Results results = acks(station, type);
        live_ms(200);
        return results;
    }
    Items download(uint8_t type) {
        auto list = toVehicle<mavlink::MissionRequestList>();
        list.mission_type = type;
        const auto counts = ask<mavlink::MissionCount>(list);
        EXPECT_EQ(counts.size(), 1u);
        Items items;
        for (uint16_t seq = 0; !counts.empty() && seq < counts[0].count; ++seq) {
            auto request = toVehicle<mavlink::MissionRequestInt>();
            request.seq = seq;
            request.mission_type = type;
            for (const auto& each : ask<mavlink::MissionItemInt>(request)) items.push_back(each);
        }
        return items;
    }
    uint8_t setParameter(const char* name, float value) {
        auto message = toVehicle<mavlink::ParamSet>();
        memcpy(message.param_id, name, std::min(strlen(name), sizeof message.param_id));
        message.param_value = value;
        const auto answers = ask<mavlink::ParamValue>(message, 200);
        EXPECT_EQ(answers.size(), 1u);
        return answers.empty() ? 0xFF : static_cast<uint8_t>(answers[0].param_value);
    }
};

void expectSame(const Items& is, const Items& was) {
    ASSERT_EQ(is.size(), was.size());
    for (size_t i = 0; i < is.size(); ++i) {
        EXPECT_EQ(is[i].command, was[i].command) << i;
        EXPECT_EQ(is[i].frame, was[i].frame) << i;
        EXPECT_EQ(is[i].x, was[i].x) << i;
        EXPECT_EQ(is[i].y, was[i].y) << i;
        EXPECT_FLOAT_EQ(is[i].z, was[i].z) << i;
        EXPECT_FLOAT_EQ(is[i].param1, was[i].param1) << i;
        EXPECT_EQ(is[i].mission_type, was[i].mission_type) << i;
        EXPECT_EQ(is[i].current, 0) << i;
    }
}

TEST_F(Points, a_fence_goes_up_and_comes_down_the_same) {
    EXPECT_EQ(upload(square(), kFence), Results{MavMissionResult::accepted});
    EXPECT_EQ(station.texts(), std::vector<std::string>{"Fence stored: 5 points"});
    expectSame(download(kFence), square());
    EXPECT_TRUE(doubles::plan.items.empty());
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

TEST_F(Points, what_is_no_such_list_is_unsupported) {
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
    void (*spoil)(mavlink::MissionItemInt&);
    uint8_t type = kFence;
};
TEST_F(Points, what_this_airplane_does_not_fly_is_refused_and_the_old_list_stays) {
    const Wrong cases[] = {
        {"an exclusion", {MavMissionResult::unsupported}, [](auto& i) { i.command = 5002; }},
        {"a circle", {MavMissionResult::unsupported}, [](auto& i) { i.command = 5003; }},
        {"a second polygon", {MavMissionResult::unsupported}, [](auto& i) { i.param1 = 3; }},
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
        each.spoil(items[2]);
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

TEST_F(Points, an_owner_that_is_gone_does_not_lock_the_others_out) {
    second.send(count(5, kFence));
    run_ms(20);
    give(count(3, kRally));
    EXPECT_EQ(acks(station, kRally), Results{MavMissionResult::denied});

    live_ms(10000);
    EXPECT_EQ(acks(second, kFence), Results{MavMissionResult::operation_cancelled});
    EXPECT_EQ(upload(threeRallyPoints(), kRally), Results{MavMissionResult::accepted});
}

// ---- one by one

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

TEST_F(OldPoints, a_point_waits_for_nobody_elses_upload) {
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

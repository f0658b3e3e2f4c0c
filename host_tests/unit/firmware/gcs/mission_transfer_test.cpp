// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "ground.hpp"

using doubles::plan;
using firmware::mission::MissionItem;
using ground::Framing;
using ground::Telemetry;
using mavlink::MavMissionResult;
using mavlink::MavMissionType;

namespace {

mavlink::MissionCount count(uint16_t items, uint8_t type = MavMissionType::mission) {
    mavlink::MissionCount message = {};
    message.target_system = message.target_component = 1;
    message.count = items;
    message.mission_type = type;
    return message;
}

template <class Message>
Message item(uint16_t seq, uint16_t command = 16) {
    Message message = {};
    message.target_system = message.target_component = 1;
    message.seq = seq;
    message.command = command;
    message.frame = 3;
    message.param1 = static_cast<float>(seq);
    message.z = 100;
    message.autocontinue = 1;
    return message;
}
mavlink::MissionItemInt itemInt(uint16_t seq, uint16_t command = 16) {
    auto message = item<mavlink::MissionItemInt>(seq, command);
    message.x = -353632610 + seq;
    message.y = 1491652300 + seq;
    return message;
}

MissionItem stored(uint16_t seq) {
    MissionItem item = {};
    item.command = 16;
    item.frame = 3;
    item.param1 = static_cast<float>(seq);
    item.x = -353632610 + seq;
    item.y = 1491652300 - seq;
    item.z = 50;
    return item;
}

class MissionTransfer : public Telemetry {
protected:
    uint16_t asked() {
        const auto requests = station.all<mavlink::MissionRequestInt>();
        EXPECT_EQ(requests.size(), 1u);
        if (requests.size() != 1) return 0xFFFF;
        EXPECT_EQ(requests[0].target_system, 255);
        EXPECT_EQ(requests[0].target_component, 190);
        return requests[0].seq;
    }
    std::vector<int> acks(ground::Station& from) {
        std::vector<int> types;
        for (const auto& ack : from.all<mavlink::MissionAck>()) types.push_back(ack.type);
        return types;
    }
    std::vector<int> acks() { return acks(station); }
    template <class Message>
    void give(const Message& message) {
        station.send(message);
        run_ms(20);
    }
    void upload(uint16_t items) {
        give(count(items));
        for (uint16_t seq = 0; seq < items; ++seq) {
            ASSERT_EQ(asked(), seq);
            give(itemInt(seq));
        }
    }
};
using Results = std::vector<int>;

TEST_F(MissionTransfer, takes_a_mission_item_by_item_and_says_so_at_the_end) {
    upload(5);

    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
    ASSERT_EQ(plan.items.size(), 5u);
    EXPECT_EQ(plan.items[3].x, -353632607);
    EXPECT_EQ(plan.items[3].y, 1491652303);
    EXPECT_EQ(plan.items[3].frame, 3);
    EXPECT_EQ(plan.items[3].param1, 3);
    EXPECT_EQ(plan.items[3].z, 100);
}

TEST_F(MissionTransfer, takes_a_mission_in_mavlink_2) {
    station.framing = Framing::v2;
    upload(3);
    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
}

TEST_F(MissionTransfer, count_and_ack_carry_the_id_of_the_stored_plan) {
    station.framing = Framing::v2;
    plan.id = 0x1004BEEF;
    give(count(1));
    give(itemInt(0));
    EXPECT_EQ(station.all<mavlink::MissionAck>().at(0).opaque_id, 0x1004BEEFu);

    mavlink::MissionRequestList list = {};
    list.target_system = list.target_component = 1;
    EXPECT_EQ(ask<mavlink::MissionCount>(list).at(0).opaque_id, 0x1004BEEFu);
}

TEST_F(MissionTransfer, a_refusal_carries_no_id) {
    station.framing = Framing::v2;
    plan.id = 0x1004BEEF;
    give(count(1, 7));
    const auto ack = station.all<mavlink::MissionAck>().at(0);
    EXPECT_EQ(ack.type, MavMissionResult::unsupported);
    EXPECT_EQ(ack.opaque_id, 0u);
}

TEST_F(MissionTransfer, mission_current_says_which_plans_are_stored_and_how_far_the_mission_is) {
    using mavlink::MissionState;
    station.framing = Framing::v2;
    auto current = [&] {
        mavlink::CommandLong message = {};
        message.target_system = message.target_component = 1;
        message.command = mavlink::MavCmd::request_message;
        message.param1 = mavlink::Wire<mavlink::MissionCurrent>::id;
        return ask<mavlink::MissionCurrent>(message).at(0);
    };
    EXPECT_EQ(current().mission_state, MissionState::no_mission);
    EXPECT_EQ(current().total, 0xFFFF);

    plan.items = {stored(0), stored(1), stored(2)};
    plan.id = 77;
    EXPECT_EQ(current().mission_state, MissionState::not_started);
    EXPECT_EQ(current().total, 2) << "the last item's number";
    EXPECT_EQ(current().mission_id, 77u);
    EXPECT_EQ(current().fence_id, 1000u);
    EXPECT_EQ(current().rally_points_id, 2000u);
    EXPECT_EQ(current().mission_mode, 2) << "suspended: not in AUTO";

    plan.current = 1;
    EXPECT_EQ(current().mission_state, MissionState::paused);
    firmware::state::mutable_vehicle.mode = firmware::state::Mode::automatic;
    EXPECT_EQ(current().mission_state, MissionState::active);
    EXPECT_EQ(current().mission_mode, 1);
    plan.complete = true;
    EXPECT_EQ(current().mission_state, MissionState::complete);
}

TEST_F(MissionTransfer, takes_items_in_whole_degrees_too) {
    give(count(1));
    auto message = item<mavlink::MissionItem>(0);
    message.x = -35.3632610f;
    message.y = 149.1652300f;

    give(message);

    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
    EXPECT_NEAR(plan.items.at(0).x, -353632610, 20);  // what a float can hold
    EXPECT_NEAR(plan.items.at(0).y, 1491652300, 80);
}

TEST_F(MissionTransfer, invalid_positions_are_stored_as_unset) {
    give(count(2));
    auto message = item<mavlink::MissionItem>(0);
    message.x = NAN;
    message.y = 1e9f;
    give(message);
    give(itemInt(1));

    EXPECT_EQ(plan.items.at(0).x, INT32_MAX);
    EXPECT_EQ(plan.items.at(0).y, INT32_MAX);
}

TEST_F(MissionTransfer, asks_again_for_an_item_that_was_lost_and_of_both_kinds) {
    give(count(2));
    EXPECT_EQ(asked(), 0);

    run_ms(400);
    const auto old_kind = station.all<mavlink::MissionRequest>();
    ASSERT_EQ(old_kind.size(), 1u);  // for a ground station that knows no other
    EXPECT_EQ(old_kind[0].seq, 0);

    give(item<mavlink::MissionItem>(0));
    EXPECT_EQ(asked(), 1) << "a float would be off by metres: the whole numbers come first";
}

TEST_F(MissionTransfer, an_abandoned_upload_is_answered_and_leaves_the_old_mission) {
    plan.items = {stored(0), stored(1)};
    give(count(9));
    give(itemInt(0));

    run_ms(10000);

    EXPECT_EQ(acks(), Results{MavMissionResult::operation_cancelled});
    EXPECT_EQ(plan.aborts, 1);
    EXPECT_EQ(plan.items.size(), 2u);
    EXPECT_EQ(station.texts().at(0), "Upload given up at item 1");
}

TEST_F(MissionTransfer, asks_again_for_the_last_item_too) {
    give(count(1));
    station.forget();
    run_ms(700);
    EXPECT_EQ(asked(), 0);

    give(itemInt(0));

    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
}

TEST_F(MissionTransfer, an_item_that_comes_twice_is_taken_once) {
    give(count(3));
    give(itemInt(0));
    station.forget();

    give(itemInt(0));

    // asked for twice, item 1 would come twice, and so would all that follow
    EXPECT_TRUE(station.everything().empty());
    run_ms(700);
    EXPECT_EQ(asked(), 1);  // but the question itself may have been lost
    EXPECT_EQ(plan.aborts, 0);
}

TEST_F(MissionTransfer, waits_for_a_slow_store_without_losing_an_item) {
    give(count(3));
    for (uint16_t seq = 0; seq < 3; ++seq) {
        plan.busy = 6;
        give(itemInt(seq));
        run_ms(200);
    }

    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
    EXPECT_EQ(plan.items.size(), 3u);
}

TEST_F(MissionTransfer, refuses_what_it_cannot_fly_at_once) {
    plan.unsupported = 999;
    plan.items = {stored(0)};
    give(count(3));
    give(itemInt(0));

    give(itemInt(1, 999));

    EXPECT_EQ(acks(), Results{MavMissionResult::unsupported});
    EXPECT_EQ(plan.aborts, 1);
    EXPECT_EQ(plan.items.size(), 1u);
}

TEST_F(MissionTransfer, refuses_more_items_than_there_is_room_for) {
    give(count(999));
    EXPECT_EQ(acks(), Results{MavMissionResult::no_space});
}

TEST_F(MissionTransfer, an_unrequested_item_is_an_error) {
    give(itemInt(0));
    EXPECT_EQ(acks(), Results{MavMissionResult::error});
}

TEST_F(MissionTransfer, a_guided_order_is_not_taken_for_an_item_of_the_upload) {
    give(count(2));
    auto message = itemInt(0);
    message.current = 2;

    give(message);

    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
    EXPECT_EQ(doubles::vehicle.targets.size(), 1u);
    EXPECT_TRUE(plan.uploading);
    EXPECT_EQ(plan.aborts, 0);
}

TEST_F(MissionTransfer, one_upload_at_a_time) {
    give(count(2));

    second.send(count(5));
    run_ms(20);
    EXPECT_EQ(acks(second), Results{MavMissionResult::denied});

    give(itemInt(0));
    give(itemInt(1));
    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
    EXPECT_EQ(plan.items.size(), 2u);
}

// A station that answers one item every eight seconds would hold the upload for ever.
TEST_F(MissionTransfer, another_station_may_begin_when_the_owner_has_been_silent_for_two_seconds) {
    give(count(40));
    for (uint16_t item = 0; item < 3; ++item) {
        run_ms(7000);
        give(itemInt(item));
        second.send(count(5));
        run_ms(20);
        EXPECT_EQ(acks(second), Results{MavMissionResult::denied}) << "it has just been heard";
    }
    station.forget();
    run_ms(2600);
    second.send(count(1));
    run_ms(20);
    EXPECT_EQ(acks(), Results{MavMissionResult::operation_cancelled}) << "to the owner";
    second.send(itemInt(0));
    run_ms(100);
    EXPECT_EQ(acks(second), Results{MavMissionResult::accepted});
}

TEST_F(MissionTransfer, the_same_count_of_another_station_is_no_repetition) {
    give(count(2));
    run_ms(2600);
    second.send(count(2));
    run_ms(20);
    second.send(itemInt(0));
    second.send(itemInt(1));
    run_ms(100);
    EXPECT_EQ(acks(second), Results{MavMissionResult::accepted});
}

TEST_F(MissionTransfer, a_new_count_begins_anew) {
    give(count(5));
    give(itemInt(0));
    station.forget();

    upload(2);

    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
    EXPECT_EQ(plan.items.size(), 2u);
}

TEST_F(MissionTransfer, the_ground_station_may_give_up) {
    give(count(5));
    mavlink::MissionAck message = {};
    message.target_system = message.target_component = 1;
    message.type = MavMissionResult::operation_cancelled;
    give(message);
    station.forget();

    run_ms(3000);

    EXPECT_EQ(plan.aborts, 1);
    EXPECT_TRUE(station.all<mavlink::MissionRequest>().empty());
    EXPECT_TRUE(station.all<mavlink::MissionRequestInt>().empty());
}

TEST_F(MissionTransfer, a_part_of_the_mission_is_replaced_both_ends_included) {
    plan.items = {stored(0), stored(1), stored(2), stored(3), stored(4)};
    mavlink::MissionWritePartialList message = {};
    message.target_system = message.target_component = 1;
    message.start_index = 2;
    message.end_index = 3;
    give(message);
    EXPECT_EQ(asked(), 2);
    give(itemInt(2, 19));
    EXPECT_EQ(asked(), 3);

    give(itemInt(3, 19));

    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
    std::vector<int> commands;
    for (const MissionItem& each : plan.items) commands.push_back(each.command);
    EXPECT_EQ(commands, (std::vector<int>{16, 16, 19, 19, 16}));
}

TEST_F(MissionTransfer, a_part_that_does_not_exist_is_refused) {
    plan.items = {stored(0), stored(1)};
    mavlink::MissionWritePartialList message = {};
    message.target_system = message.target_component = 1;
    message.start_index = 1;
    message.end_index = 7;
    give(message);
    EXPECT_EQ(acks(), Results{MavMissionResult::invalid_sequence});
}

template <class Request>
Request request(uint16_t seq) {
    Request message = {};
    message.target_system = message.target_component = 1;
    message.seq = seq;
    return message;
}

TEST_F(MissionTransfer, gives_the_mission_in_either_form) {
    plan.items = {stored(0), stored(1)};
    plan.current = 1;
    mavlink::MissionRequestList list = {};
    list.target_system = list.target_component = 1;

    const auto counts = ask<mavlink::MissionCount>(list);
    ASSERT_EQ(counts.size(), 1u);
    EXPECT_EQ(counts[0].count, 2);
    EXPECT_EQ(counts[0].target_system, 255);

    const auto whole = ask<mavlink::MissionItemInt>(request<mavlink::MissionRequestInt>(1));
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(whole[0].x, -353632609);
    EXPECT_EQ(whole[0].y, 1491652299);
    EXPECT_EQ(whole[0].current, 1);
    EXPECT_EQ(whole[0].autocontinue, 1);

    const auto degrees = ask<mavlink::MissionItem>(request<mavlink::MissionRequest>(0));
    ASSERT_EQ(degrees.size(), 1u);
    EXPECT_FLOAT_EQ(degrees[0].x, -35.363261f);
    EXPECT_EQ(degrees[0].current, 0);
}

TEST_F(MissionTransfer, a_float_answer_is_the_nearest_there_is) {
    plan.items = {stored(0)};
    for (int32_t angle_e7 = 1491652300; angle_e7 < 1491662300; angle_e7 += 37) {
        plan.items[0].y = angle_e7;
        plan.items[0].x = -angle_e7 / 3;
        const auto sent = ask<mavlink::MissionItem>(request<mavlink::MissionRequest>(0)).at(0);
        ASSERT_NEAR(sent.y, angle_e7 * 1e-7, 0.77e-5);  // half a step of a float
        ASSERT_NEAR(sent.x, plan.items[0].x * 1e-7, 0.2e-5);
    }
}

TEST_F(MissionTransfer, an_item_that_does_not_exist_is_refused) {
    plan.items = {stored(0)};
    give(request<mavlink::MissionRequestInt>(1));
    EXPECT_EQ(acks(), Results{MavMissionResult::invalid_sequence});
}

TEST_F(MissionTransfer, an_item_that_is_still_being_read_comes_later) {
    plan.items = {stored(0)};
    plan.busy = 3;
    EXPECT_EQ(ask<mavlink::MissionItemInt>(request<mavlink::MissionRequestInt>(0), 100).size(), 1u);
}

TEST_F(MissionTransfer, a_store_that_stays_busy_is_answered_with_an_error) {
    plan.items = {stored(0)};
    plan.busy = 1000000;
    give(count(3));
    run_ms(1500);
    EXPECT_EQ(acks(), Results{MavMissionResult::error});

    give(request<mavlink::MissionRequestInt>(0));
    run_ms(1500);
    EXPECT_EQ(acks(), Results{MavMissionResult::error});

    EXPECT_EQ(command(mavlink::MavCmd::component_arm_disarm, 0), 0);  // the link lives on
}

TEST_F(MissionTransfer, clears_the_mission) {
    plan.items = {stored(0)};
    mavlink::MissionClearAll message = {};
    message.target_system = message.target_component = 1;

    give(message);

    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
    EXPECT_TRUE(plan.items.empty());
}

TEST_F(MissionTransfer, a_count_of_nothing_clears_the_mission) {
    plan.items = {stored(0)};
    give(count(0));
    EXPECT_EQ(acks(), Results{MavMissionResult::accepted});
    EXPECT_TRUE(plan.items.empty());
}

// MAVSDK asks again at once when it hears of another item than it asked for.
TEST_F(MissionTransfer, set_current_is_answered_with_the_current_item_only_when_it_was_set) {
    plan.items = {stored(0), stored(1), stored(2)};
    mavlink::MissionSetCurrent message = {};
    message.target_system = message.target_component = 1;
    message.seq = 2;
    EXPECT_EQ(ask<mavlink::MissionCurrent>(message).at(0).seq, 2);

    message.seq = 9;
    EXPECT_EQ(ask<mavlink::MissionCurrent>(message).size(), 0u);
    EXPECT_EQ(station.texts().at(0), "No mission item 9");
}

}  // namespace

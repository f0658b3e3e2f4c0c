// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/unit/simulator/invariants/flown.hpp"

namespace simulator::invariants {

using mavlink::MavCmd;

// Item 0 is home; 4 is a jump, to 2 unless it is given.
constexpr uint16_t kMission[] = {16, 22, 16, MavCmd::do_change_speed, MavCmd::do_jump, 16, 16, 21};

void upload(Flown& flown, uint8_t result = 0, float jumps_to = 2) {
    mavlink::MissionCount count{};
    count.count = std::size(kMission);
    flown.sent(count);
    for (uint16_t i = 0; i < std::size(kMission); ++i) {
        mavlink::MissionItemInt item{};
        item.seq = i;
        item.command = kMission[i];
        if (item.command == MavCmd::do_jump) item.param1 = jumps_to;
        flown.sent(item);
    }
    mavlink::MissionAck ack{};
    ack.type = result;
    flown.received(ack);
}

void current(Flown& flown, uint16_t item) {
    mavlink::MissionCurrent message{};
    message.seq = item;
    flown.received(message);
    flown.run(5);
}

void reached(Flown& flown, uint16_t item) {
    mavlink::MissionItemReached message{};
    message.seq = item;
    flown.received(message);
}

Flown flownTo(uint16_t item, float jumps_to = 2) {
    Flown flown;
    flown.mode = 10;
    upload(flown, 0, jumps_to);
    flown.run(10);
    current(flown, item);
    return flown;
}

TEST(MissionDoesNotJump, from_an_item_to_the_next_is_allowed) {
    Flown flown = flownTo(1);
    reached(flown, 1);
    current(flown, 2);
    EXPECT_EQ(flown.violated(), "");
}

TEST(MissionDoesNotJump, the_item_must_have_been_reached) {
    Flown flown = flownTo(1);
    current(flown, 2);
    EXPECT_EQ(flown.violated(), "mission_jump ");
}

TEST(MissionDoesNotJump, an_item_left_out_violates_it) {
    Flown flown = flownTo(5);
    reached(flown, 5);
    current(flown, 7);
    EXPECT_EQ(flown.violated(), "mission_jump ");
}

TEST(MissionDoesNotJump, the_target_of_a_jump_and_the_item_behind_it_are_allowed) {
    for (const uint16_t to : {2, 5}) {
        Flown flown = flownTo(2);
        reached(flown, 2);
        if (to == 2) current(flown, 1), flown = flownTo(2), reached(flown, 2);
        current(flown, to);
        EXPECT_EQ(flown.violated(), "") << to;
    }
    Flown flown = flownTo(2);
    reached(flown, 2);
    current(flown, 6);
    EXPECT_EQ(flown.violated(), "mission_jump ");
}

TEST(MissionDoesNotJump, two_items_that_end_at_once_are_allowed) {
    Flown flown = flownTo(5);
    reached(flown, 5);
    reached(flown, 6);
    current(flown, 7);
    EXPECT_EQ(flown.violated(), "");
}

TEST(MissionDoesNotJump, an_index_set_by_command_is_allowed) {
    Flown flown = flownTo(2);
    mavlink::MissionSetCurrent set{};
    set.seq = 6;
    flown.sent(set);
    current(flown, 6);
    EXPECT_EQ(flown.violated(), "");
}

TEST(MissionDoesNotJump, a_go_around_begins_the_landing_again_after_its_climb) {
    for (const bool ordered : {true, false}) {
        Flown flown = flownTo(7);
        if (ordered) flown.command(MavCmd::do_go_around);
        flown.run(30);
        current(flown, 6);
        EXPECT_EQ(flown.violated(), ordered ? "" : "mission_jump ");
    }
}

TEST(MissionDoesNotJump, a_refused_mission_changes_nothing) {
    Flown flown;
    flown.mode = 10;
    upload(flown, 4);
    flown.run(10);
    current(flown, 1);
    current(flown, 6);
    EXPECT_EQ(flown.violated(), "");
}

TEST(MissionDoesNotJump, a_jump_beside_a_nav_leads_away_from_it) {
    Flown led = flownTo(5), astray = flownTo(5);
    current(led, 2);
    current(astray, 7);
    EXPECT_EQ(led.violated(), "");
    EXPECT_EQ(astray.violated(), "mission_jump ");
}

TEST(MissionDoesNotJump, the_item_a_jump_leads_to_may_end_at_once) {
    for (const bool over : {true, false}) {
        Flown flown = flownTo(5, 1);
        if (over) reached(flown, 1);
        current(flown, 2);
        EXPECT_EQ(flown.violated(), over ? "" : "mission_jump ");
    }
}

TEST(MissionDoesNotJump, an_upload_whose_answer_is_lost_may_be_either_mission) {
    Flown flown = flownTo(1);
    flown.run(5);
    mavlink::MissionCount count{};
    count.count = 2;
    flown.sent(count);
    for (uint16_t i = 0; i < 2; ++i) {
        mavlink::MissionItemInt item{};
        item.seq = i;
        item.command = 16;
        flown.sent(item);
    }
    flown.run(10);
    current(flown, 7);
    EXPECT_EQ(flown.violated(), "");
}

TEST(MissionDoesNotJump, a_disarm_on_the_ground_begins_the_mission_again) {
    Flown flown = flownTo(5);
    flown.command(MavCmd::component_arm_disarm, 0);
    current(flown, 1);
    EXPECT_EQ(flown.violated(), "");
}

}  // namespace simulator::invariants

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

TEST(MissionDoesNotJump, FromAnItemToTheNext) {
    Flown flown = flownTo(1);
    reached(flown, 1);
    current(flown, 2);
    EXPECT_EQ(flown.violated(), "");
}

TEST(MissionDoesNotJump, TheItemMustHaveBeenReached) {
    Flown flown = flownTo(1);
    current(flown, 2);
    EXPECT_EQ(flown.violated(), "mission_jump ");
}

TEST(MissionDoesNotJump, OneThatIsLeftOutIsSeen) {
    Flown flown = flownTo(5);
    reached(flown, 5);
    current(flown, 7);
    EXPECT_EQ(flown.violated(), "mission_jump ");
}

TEST(MissionDoesNotJump, WhereAJumpLeadsAndBehindIt) {
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

TEST(MissionDoesNotJump, TwoThatAreOverAtOnce) {
    Flown flown = flownTo(5);
    reached(flown, 5);
    reached(flown, 6);
    current(flown, 7);
    EXPECT_EQ(flown.violated(), "");
}

TEST(MissionDoesNotJump, SetByCommand) {
    Flown flown = flownTo(2);
    mavlink::MissionSetCurrent set{};
    set.seq = 6;
    flown.sent(set);
    current(flown, 6);
    EXPECT_EQ(flown.violated(), "");
}

TEST(MissionDoesNotJump, AGoAroundBeginsTheLandingAgainAfterItsClimb) {
    for (const bool ordered : {true, false}) {
        Flown flown = flownTo(7);
        if (ordered) flown.command(MavCmd::do_go_around);
        flown.run(30);
        current(flown, 6);
        EXPECT_EQ(flown.violated(), ordered ? "" : "mission_jump ");
    }
}

TEST(MissionDoesNotJump, AMissionThatWasRefusedSaysNothing) {
    Flown flown;
    flown.mode = 10;
    upload(flown, 4);
    flown.run(10);
    current(flown, 1);
    current(flown, 6);
    EXPECT_EQ(flown.violated(), "");
}

TEST(MissionDoesNotJump, AJumpBesideANavLeadsAwayFromIt) {
    Flown led = flownTo(5), astray = flownTo(5);
    current(led, 2);
    current(astray, 7);
    EXPECT_EQ(led.violated(), "");
    EXPECT_EQ(astray.violated(), "mission_jump ");
}

TEST(MissionDoesNotJump, WhereItIsLedAwayToMayBeOverAtOnce) {
    for (const bool over : {true, false}) {
        Flown flown = flownTo(5, 1);
        if (over) reached(flown, 1);
        current(flown, 2);
        EXPECT_EQ(flown.violated(), over ? "" : "mission_jump ");
    }
}

TEST(MissionDoesNotJump, NorIsAnUploadWhoseAnswerIsNotHeardTheOldMission) {
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

TEST(MissionDoesNotJump, ADisarmOnTheGroundBeginsAgain) {
    Flown flown = flownTo(5);
    flown.command(MavCmd::component_arm_disarm, 0);
    current(flown, 1);
    EXPECT_EQ(flown.violated(), "");
}

}  // namespace simulator::invariants

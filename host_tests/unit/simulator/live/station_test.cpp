// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/station.hpp"

#include <gmock/gmock.h>

#include "talking_board.hpp"

using namespace simulator;
using namespace simulator::live;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;

namespace {

constexpr uint16_t kStart = mavlink::MavCmd::mission_start, kArm = 400, kMode = 176;

class StationTest : public testing::Test {
protected:
    StationTest() : station(board, 0) {
        board.listen([this](int usart, uint8_t byte, uint64_t time_us) {
            if (usart == 0) station.receive(byte, time_us);
        });
    }
    void run(double seconds) {
        const uint64_t end_us = board.time_us() + static_cast<uint64_t>(seconds * 1e6);
        while (board.time_us() < end_us) {
            board.runUntil(board.time_us() + 10'000);
            station.step(board.time_us());
        }
    }
    void give(const std::string& json) {
        answer = "none";
        station.give(readOrder(json), [this](bool ok, const std::string& text) {
            answer = (ok ? "ok: " : "no: ") + text;
        });
    }
    TalkingBoard board;
    Station station;
    std::string answer = "none";
};

}  // namespace

TEST_F(StationTest, asks_for_streams_but_sends_no_heartbeat) {
    run(5);

    EXPECT_THAT(board.asked, Contains(mavlink::Wire<mavlink::RequestDataStream>::id));
    EXPECT_THAT(board.asked, Not(Contains(mavlink::Wire<mavlink::Heartbeat>::id)));
}

TEST_F(StationTest, says_nothing_to_a_board_that_is_silent) {
    board.talks = false;
    run(5);

    EXPECT_TRUE(board.asked.empty());
    give(R"({"do":"arm"})");
    EXPECT_EQ(answer, "no: nothing has been heard of the autopilot yet");
}

TEST_F(StationTest, answers_with_result_and_texts) {
    board.on_command = [this](const mavlink::CommandLong& command) {
        EXPECT_EQ(command.command, kArm);
        EXPECT_EQ(command.param1, 1);
        board.sayText("PreArm: no GPS fix");
        return uint8_t{4};
    };
    run(2);
    give(R"({"do":"arm"})");
    run(1);

    EXPECT_EQ(answer, "no: FAILED: PreArm: no GPS fix");
}

TEST_F(StationTest, waits_until_the_heartbeat_shows_what_was_accepted) {
    run(2.5);
    board.on_command = [this](const mavlink::CommandLong&) {
        board.armed = true;
        return uint8_t{0};
    };
    give(R"({"do":"arm"})");
    run(0.4);
    EXPECT_EQ(answer, "none");
    run(0.3);
    EXPECT_EQ(answer, "ok: ACCEPTED");
    EXPECT_TRUE(station.telemetry().armed());
}

TEST_F(StationTest, asks_three_times_and_gives_up) {
    board.on_command = [](const mavlink::CommandLong&) { return std::nullopt; };
    run(2);
    give(R"({"do":"mode","mode":"AUTO"})");
    run(6);

    EXPECT_THAT(board.commands, ElementsAre(kMode, kMode, kMode));
    EXPECT_EQ(answer, "no: the autopilot does not answer");
}

TEST_F(StationTest, gives_one_command_after_the_other) {
    int commands = 0;
    board.on_command = [&](const mavlink::CommandLong&) -> std::optional<uint8_t> {
        ++commands;
        return uint8_t{2};
    };
    run(2);
    give(R"({"do":"arm"})");
    give(R"({"do":"disarm"})");
    run(0.05);
    EXPECT_EQ(commands, 1);
    run(1);
    EXPECT_EQ(commands, 2);
    EXPECT_EQ(answer, "no: DENIED");
}

TEST_F(StationTest, flies_to_a_place_as_ground_stations_do) {
    run(2);
    give(R"({"do":"goto","lat_deg":47.5,"lon_deg":8.5,"altitude_m":60})");
    run(1);

    ASSERT_EQ(board.places.size(), 1u);
    const mavlink::CommandInt place = board.places[0];
    EXPECT_EQ(place.command, mavlink::MavCmd::do_reposition);
    EXPECT_EQ(place.frame, mavlink::MavFrame::global_relative_alt_int);
    EXPECT_EQ(place.param2, 1);
    EXPECT_EQ(place.x, 475'000'000);
    EXPECT_EQ(place.z, 60);
    EXPECT_EQ(answer, "ok: ACCEPTED");
}

TEST_F(StationTest, takes_off_with_the_mission_that_begins_so) {
    board.armed = true;
    board.lists[0] = {itemAt(0, 16, 47, 8, 488), itemAt(1, 22, 0, 0, 50)};
    run(3);
    give(R"({"do":"takeoff"})");
    run(1);

    EXPECT_THAT(board.commands, ElementsAre(kStart));
    EXPECT_EQ(answer, "ok: ACCEPTED");
}

TEST_F(StationTest, leaves_another_mission_alone) {
    board.armed = true;
    board.lists[0] = {itemAt(0, 16, 47, 8, 488), itemAt(1, 16, 47.1, 8, 50)};
    run(3);
    give(R"({"do":"takeoff"})");

    EXPECT_EQ(answer, "no: the mission on the board does not begin with a take-off");
    EXPECT_TRUE(board.commands.empty());
}

TEST_F(StationTest, takes_nobody_off_who_is_not_armed) {
    run(3);
    give(R"({"do":"takeoff"})");

    EXPECT_EQ(answer, "no: not armed");
}

TEST_F(StationTest, gives_a_mission_to_a_board_that_has_none) {
    board.armed = true;
    run(3);
    mavlink::GlobalPositionInt position{};
    position.lat = 470'000'000;
    board.say(position);
    give(R"({"do":"takeoff"})");
    run(0.1);

    EXPECT_THAT(board.asked, Contains(mavlink::Wire<mavlink::MissionCount>::id));
    mavlink::MissionAck ack{};
    board.say(ack);
    run(1);
    EXPECT_THAT(board.commands, ElementsAre(kStart));
    EXPECT_EQ(answer, "ok: ACCEPTED");
}

TEST_F(StationTest, reads_a_plan_again_that_somebody_has_changed) {
    board.lists[1] = {itemAt(0, 5001, 47, 8, 0)};
    run(3);
    ASSERT_EQ(station.plans().items(1).size(), 1u);
    const unsigned before = station.plans().changes();

    board.lists[1].push_back(itemAt(1, 5001, 48, 8, 0));
    run(1);
    EXPECT_EQ(station.plans().items(1).size(), 1u);
    mavlink::MissionAck ack{};
    ack.mission_type = 1;
    uint8_t bytes[mavlink::kLongestFrame];
    const uint16_t size = mavlink::encode({mavlink::Framing::v2, 0, 1, 1}, ack, bytes);
    mavlink::PeerParser other_line;
    for (uint16_t i = 0; i < size; ++i)
        if (other_line.put(bytes[i])) station.overhear(other_line.frame());
    run(1);
    EXPECT_EQ(station.plans().items(1).size(), 2u);
    EXPECT_EQ(station.plans().changes(), before + 1);
}

TEST(ResultName, is_the_name_mavlink_gives_it) {
    EXPECT_EQ(resultName(1), "TEMPORARILY_REJECTED");
    EXPECT_EQ(resultName(99), "result 99");
}

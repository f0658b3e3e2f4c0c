// SPDX-License-Identifier: GPL-3.0-or-later
// The flight from the ground station's chair, of an autopilot that is not ours: it sends no results
// of its checks, knows SET_MODE but not the command, and stays armed where it has landed.
#include "simulator/ground/scripted_flight.hpp"

#include <gtest/gtest.h>

#include "echo_board.hpp"

using namespace simulator;

namespace {

constexpr int kUsart = 2;
constexpr uint64_t kStep_us = 20'000, kSecond_us = 1'000'000;

class OtherAutopilot : public Board {
public:
    explicit OtherAutopilot(bool knows_command) : knows_command_(knows_command) {
        WorldOptions options;
        options.bench_model = true;
        world_.emplace(options);
    }

    bool runUntil(uint64_t time_us) override {
        now_us_ = time_us;
        world_->advanceTo(time_us);
        for (const char byte : std::exchange(heard_, ""))
            for (bool whole = parser_.put(static_cast<uint8_t>(byte)); whole;
                 whole = parser_.next())
                answer(parser_.frame());
        if (time_us % kSecond_us == 0) beat();
        return true;
    }
    uint64_t time_us() const override { return now_us_; }
    std::string fault() const override { return ""; }
    void listen(Listener listener) override { listener_ = std::move(listener); }
    void send(int, const uint8_t* bytes, size_t size) override {
        heard_.append(bytes, bytes + size);
    }
    size_t unsent(int) const override { return 0; }
    void setUsb(bool) override {}
    void reset() override {}
    std::vector<uint8_t> eeprom() const override { return {}; }
    void setEeprom(const std::vector<uint8_t>&) override {}
    World& world() override { return *world_; }
    BoardFigures figures() const override { return {}; }

    template <class Message>
    void say(const Message& message) {
        uint8_t bytes[mavlink::kLongestFrame];
        const uint16_t size =
            mavlink::encode({mavlink::Framing::v1, sequence_++, 1, 1}, message, bytes);
        for (uint16_t i = 0; i < size; ++i) listener_(kUsart, bytes[i], now_us_);
    }
    void flies(uint16_t item) {
        mavlink::MissionCurrent message{};
        message.seq = item;
        say(message);
    }
    bool armed = false;
    uint32_t mode = 0;

private:
    void beat() {
        mavlink::Heartbeat message{};
        message.custom_mode = mode;
        message.autopilot = mavlink::MavAutopilot::ardupilotmega;
        message.base_mode = armed ? mavlink::MavModeFlag::safety_armed : 0;
        say(message);
    }
    void answer(const mavlink::Frame& frame) {
        if (as<mavlink::ParamRequestRead>(frame)) {
            mavlink::ParamValue value{};
            std::strcpy(value.param_id, "TRIM_ARSPD_CM");
            value.param_value = 1350;
            say(value);
        }
        if (as<mavlink::RequestDataStream>(frame)) {
            mavlink::GpsRawInt fix{};
            fix.fix_type = 3;
            say(fix);
            say(mavlink::VfrHud{});
            say(mavlink::Attitude{});
            say(mavlink::GlobalPositionInt{});
        }
        if (const auto count = as<mavlink::MissionCount>(frame)) request(0, count_ = count->count);
        if (const auto item = as<mavlink::MissionItem>(frame))
            request(static_cast<uint16_t>(item->seq + 1), count_);
        if (const auto order = as<mavlink::CommandLong>(frame)) {
            if (order->command == mavlink::MavCmd::component_arm_disarm) armed = true;
            if (order->command == mavlink::MavCmd::do_set_mode && knows_command_)
                mode = static_cast<uint32_t>(order->param2);
        }
        if (const auto order = as<mavlink::SetMode>(frame)) mode = order->custom_mode;
    }
    void request(uint16_t item, uint16_t count) {
        if (item == count) return say(mavlink::MissionAck{});
        mavlink::MissionRequest message{};
        message.seq = item;
        say(message);
    }

    const bool knows_command_;
    std::optional<World> world_;
    mavlink::PeerParser parser_;
    Listener listener_;
    std::string heard_;
    uint64_t now_us_ = 0;
    uint16_t count_ = 0;
    uint8_t sequence_ = 0;
};

class OfAnother : public testing::Test {
protected:
    void begin(bool knows_command) {
        board = std::make_unique<OtherAutopilot>(knows_command);
        flight = std::make_unique<ScriptedFlight>(*board, kUsart, kItems, 600);
        board->listen([this](int, uint8_t byte, uint64_t us) { flight->receive(byte, us); });
    }
    // Until `over`, `for_s` at most.
    template <class Over>
    bool run(double for_s, Over over) {
        const uint64_t end_us = now_us + static_cast<uint64_t>(for_s * 1e6);
        while (now_us < end_us && !flight->over() && !over()) {
            board->runUntil(now_us += kStep_us);
            flight->step(now_us);
        }
        return over();
    }
    bool inAuto() {
        return run(60, [this] { return board->mode == kModeAuto; });
    }
    void flyAndLand() {
        board->world().lift(30);
        run(2, [] { return false; });
        for (const uint16_t item : {1, 2}) board->flies(item);
        board->world().lift(0);
    }
    void flyAndStand() {
        begin(true);
        ASSERT_TRUE(inAuto());
        run(3, [] { return false; });
        flyAndLand();
        run(5, [] { return false; });
    }

    const Waypoints kItems = parseWaypoints(
        "QGC WPL 110\n"
        "0\t1\t0\t16\t0\t0\t0\t0\t47.3977\t8.5456\t488\t1\n"
        "1\t0\t3\t22\t15\t0\t0\t0\t0\t0\t40\t1\n"
        "2\t0\t3\t21\t0\t0\t0\t0\t47.3977\t8.5456\t0\t1\n",
        "test");
    std::unique_ptr<OtherAutopilot> board;
    std::unique_ptr<ScriptedFlight> flight;
    uint64_t now_us = 0;
};

}  // namespace

TEST_F(OfAnother, is_switched_to_auto_by_the_command_and_by_the_message_where_it_is_not_known) {
    for (const bool knows_command : {true, false}) {
        now_us = 0;
        begin(knows_command);
        EXPECT_TRUE(inAuto()) << flight->reason();
    }
}

TEST_F(OfAnother, is_complete_when_it_stands_though_it_stays_armed) {
    begin(false);
    flight->flyAnother();
    ASSERT_TRUE(inAuto());
    run(3, [] { return false; });
    flyAndLand();
    EXPECT_TRUE(run(90, [this] { return flight->over(); }));
    EXPECT_TRUE(flight->completed()) << flight->reason();
}

TEST_F(OfAnother, but_ours_has_to_disarm) {
    begin(true);
    ASSERT_TRUE(inAuto());
    run(3, [] { return false; });
    flyAndLand();
    EXPECT_TRUE(run(90, [this] { return flight->over(); }));
    EXPECT_EQ(flight->reason(), "it stands, but does not disarm");
}

TEST_F(OfAnother, is_complete_though_a_gust_lifts_it_where_it_stands_disarmed) {
    ASSERT_NO_FATAL_FAILURE(flyAndStand());
    board->armed = false;
    run(1.5, [] { return false; });
    board->world().lift(1);
    EXPECT_TRUE(run(10, [this] { return flight->over(); }));
    EXPECT_TRUE(flight->completed()) << flight->reason();
}

TEST_F(OfAnother, is_complete_though_a_gust_lifts_it_before_it_disarms) {
    ASSERT_NO_FATAL_FAILURE(flyAndStand());
    board->world().lift(1);
    board->armed = false;
    EXPECT_TRUE(run(10, [this] { return flight->over(); }));
    EXPECT_TRUE(flight->completed()) << flight->reason();
}

// SPDX-License-Identifier: GPL-3.0-or-later
// A board without a firmware that speaks MAVLink as one: a heartbeat a second on USART0, three
// lists of plans, and answers to commands as a test sets them.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "mavlink/peer.hpp"
#include "simulator/board.hpp"
#include "simulator/ground/link.hpp"
#include "simulator/ground/waypoints.hpp"

class TalkingBoard : public simulator::Board {
public:
    TalkingBoard() : world_(simulator::WorldOptions()) {}

    bool runUntil(uint64_t time_us) override {
        for (; now_us_ < time_us; now_us_ += 10'000) {
            if (now_us_ % 1'000'000 == 0 && talks) beat();
            hear();
            world_.advanceTo(now_us_);
        }
        return true;
    }
    uint64_t time_us() const override { return now_us_; }
    std::string fault() const override { return ""; }
    void listen(Listener listener) override { listener_ = std::move(listener); }
    void send(int usart, const uint8_t* bytes, size_t size) override {
        if (usart == 0) sent_.append(bytes, bytes + size);
    }
    size_t unsent(int) const override { return 0; }
    void setUsb(bool) override {}
    void reset() override {}
    std::vector<uint8_t> eeprom() const override { return {}; }
    void setEeprom(const std::vector<uint8_t>&) override {}
    simulator::World& world() override { return world_; }
    simulator::BoardFigures figures() const override { return {}; }

    template <class Message>
    void say(const Message& message, int usart = 0) {
        uint8_t bytes[mavlink::kLongestFrame];
        const uint16_t size = mavlink::encode(sender_, message, bytes);
        ++sender_.sequence;
        for (uint16_t i = 0; i < size; ++i) listener_(usart, bytes[i], now_us_);
    }
    void sayText(const std::string& text, uint8_t severity = 6) {
        mavlink::Statustext message{};
        message.severity = severity;
        std::memcpy(message.text, text.data(), text.size());
        say(message);
    }

    bool talks = true, armed = false;
    uint32_t mode = 0;
    simulator::Waypoints lists[3];
    // What a command is answered with; empty: not at all.
    std::function<std::optional<uint8_t>(const mavlink::CommandLong&)> on_command =
        [](const mavlink::CommandLong&) { return uint8_t{0}; };
    std::vector<uint16_t> commands;
    std::vector<mavlink::CommandInt> places;
    std::vector<uint16_t> asked;  // the ids of other messages
    int lose_items = 0;           // requests that are not answered

private:
    // What was sent before this step: the answers come with the next one.
    void hear() {
        const std::string heard = std::move(sent_);
        sent_.clear();
        for (const char byte : heard)
            for (bool whole = parser_.put(static_cast<uint8_t>(byte)); whole;
                 whole = parser_.next())
                take(parser_.frame());
    }
    void beat() {
        mavlink::Heartbeat message{};
        message.autopilot = 3;
        message.base_mode = armed ? mavlink::MavModeFlag::safety_armed : 0;
        message.custom_mode = mode;
        say(message);
    }
    void answer(uint16_t command, uint8_t result) {
        mavlink::CommandAck ack{};
        ack.command = command;
        ack.result = result;
        say(ack);
    }
    void take(const mavlink::Frame& frame) {
        using namespace mavlink;
        asked.push_back(frame.id);
        if (const auto order = simulator::as<CommandLong>(frame)) {
            commands.push_back(order->command);
            if (const auto result = on_command(*order)) answer(order->command, *result);
        }
        if (const auto order = simulator::as<CommandInt>(frame)) {
            places.push_back(*order);
            answer(order->command, 0);
        }
        if (const auto list = simulator::as<MissionRequestList>(frame)) {
            MissionCount count{};
            count.mission_type = list->mission_type;
            count.count = static_cast<uint16_t>(lists[list->mission_type].size());
            say(count);
        }
        if (const auto item = simulator::as<MissionRequestInt>(frame)) give(*item);
    }
    void give(const mavlink::MissionRequestInt& request) {
        if (lose_items > 0) return void(--lose_items);
        const simulator::WaypointItem& from = lists[request.mission_type].at(request.seq);
        mavlink::MissionItemInt item{};
        item.seq = request.seq;
        item.mission_type = request.mission_type;
        item.command = from.command;
        item.frame = from.frame;
        item.param1 = static_cast<float>(from.params[0]);
        item.x = static_cast<int32_t>(from.latitude_deg * 1e7);
        item.y = static_cast<int32_t>(from.longitude_deg * 1e7);
        item.z = static_cast<float>(from.altitude_m);
        say(item);
    }

    simulator::World world_;
    uint64_t now_us_ = 0;
    std::string sent_;
    Listener listener_ = [](int, uint8_t, uint64_t) {};
    mavlink::PeerParser parser_;
    mavlink::Sender sender_{mavlink::Framing::v2, 0, 1, 1};
};

inline simulator::WaypointItem itemAt(int index, uint16_t command, double latitude_deg,
                                      double longitude_deg, double altitude_m) {
    simulator::WaypointItem item;
    item.index = index;
    item.command = command;
    item.frame = index == 0 ? 0 : 3;
    item.latitude_deg = latitude_deg;
    item.longitude_deg = longitude_deg;
    item.altitude_m = altitude_m;
    return item;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The other end of a link: sends messages to the vehicle and reads what it answers.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fakes/fakes.hpp"
#include "firmware/gcs/telemetry.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/sensors/rc_override.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/processor_figures.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "mavlink/peer.hpp"
#include "vehicle_double.hpp"

namespace ground {

using mavlink::Framing;

struct Heard {
    uint16_t id;
    Framing framing;
    uint8_t sequence, system, component;
    std::vector<uint8_t> payload;
};

class Station {
public:
    explicit Station(hal::Port port) : port_(port) {}

    Framing framing = Framing::v1;
    uint8_t system = 255, component = 190;

    template <class Message>
    void send(const Message& message) {
        uint8_t bytes[mavlink::kLongestFrame];
        const uint16_t size =
            mavlink::encode({framing, sequence_++, system, component}, message, bytes);
        line().receive(std::vector<uint8_t>(bytes, bytes + size));
    }
    void sendRaw(const mavlink::Outgoing& message) {
        mavlink::writeFrame(
            [this](const uint8_t* bytes, uint8_t size) {
                line().receive(std::vector<uint8_t>(bytes, bytes + size));
            },
            {Framing::v2, sequence_++, system, component}, message);
    }
    // Everything heard since the last call that is a Message.
    template <class Message>
    std::vector<Message> all() {
        listen();
        std::vector<Message> found;
        std::vector<Heard> others;
        for (const Heard& heard : heard_) {
            if (heard.id != mavlink::Wire<Message>::id) {
                others.push_back(heard);
                continue;
            }
            Message message = {};
            memcpy(&message, heard.payload.data(), std::min(heard.payload.size(), sizeof message));
            found.push_back(message);
        }
        heard_ = others;
        return found;
    }
    std::vector<Heard> everything() {
        listen();
        std::vector<Heard> all;
        all.swap(heard_);
        return all;
    }
    std::vector<std::string> texts() {
        std::vector<std::string> found;
        for (const auto& message : all<mavlink::Statustext>())
            found.push_back(std::string(message.text, strnlen(message.text, sizeof message.text)));
        return found;
    }
    void forget() {
        listen();
        heard_.clear();
    }
    uint16_t broken() { return parser_.rejected(); }
    fakes::Serial& line() { return fakes::serial(port_); }

private:
    void listen() {
        for (const uint8_t byte : line().out)
            for (bool whole = parser_.put(byte); whole; whole = parser_.next()) {
                const mavlink::Frame frame = parser_.frame();
                heard_.push_back(
                    {frame.id, frame.framing, frame.sequence, frame.system, frame.component,
                     std::vector<uint8_t>(frame.payload, frame.payload + frame.length)});
            }
        line().out.clear();
    }

    hal::Port port_;
    uint8_t sequence_ = 0;
    mavlink::PeerParser parser_;
    std::vector<Heard> heard_;
};

class Telemetry : public testing::Test {
protected:
    void SetUp() override {
        station.line().room = second.line().room =
            hal::kLinkRoom;  // as the real ports, and never less
        firmware::state::mutable_vehicle.prearm_ok = true;
        firmware::state::processor_figures = {250, 3, 4321};
        firmware::state::mutable_vehicle.mode = firmware::state::Mode::manual;
        while (firmware::state::parametersLoad() == core::Status::busy) fakes::advance_ms(10);
        for (auto& rates : firmware::state::parameters.streams)
            rates = {};  // silence but for heartbeats
        firmware::gcs::telemetryStart();
        run_ms(100);
        station.forget();
        second.forget();
    }

    // The frames and the rest of each: telemetrySend every second one, telemetryPump in between.
    void run_ms(uint32_t time_ms) {
        for (uint32_t ms = 0; ms < time_ms; ms += 10) {
            if (frame_++ % 2 == 0) firmware::gcs::telemetrySend();
            rest();
            fakes::advance_ms(10);
        }
    }
    void rest() {
        for (int i = 0; i < 200 && firmware::gcs::telemetryPump(); ++i) {
        }
    }
    template <class Answer, class Question>
    std::vector<Answer> ask(const Question& question, uint32_t wait_ms = 20) {
        station.send(question);
        run_ms(wait_ms);
        return station.all<Answer>();
    }
    uint8_t command(uint16_t id, float param1 = 0, float param2 = 0, float param3 = 0,
                    float param4 = 0, float param5 = 0, float param6 = 0, float param7 = 0) {
        mavlink::CommandLong message = {};
        message.command = id;
        message.param1 = param1;
        message.param2 = param2;
        message.param3 = param3;
        message.param4 = param4;
        message.param5 = param5;
        message.param6 = param6;
        message.param7 = param7;
        message.target_system = 1;
        message.target_component = 1;
        const auto acks = ask<mavlink::CommandAck>(message);
        EXPECT_EQ(acks.size(), 1u);
        if (acks.size() != 1) return 0xFF;
        EXPECT_EQ(acks[0].command, id);
        return acks[0].result;
    }

    Station station{hal::Port::link0}, second{hal::Port::link1};

private:
    uint32_t frame_ = 0;
};

}  // namespace ground

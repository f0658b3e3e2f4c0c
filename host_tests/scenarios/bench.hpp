// SPDX-License-Identifier: GPL-3.0-or-later
// A board on the bench with a ground station at its USB port that sends commands, and remembers
// the texts it sent.
#pragma once
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "simulator/ground/link.hpp"
#include "simulator/ground/telemetry.hpp"

namespace simulator {

class Bench {
public:
    explicit Bench(Board& board)
        : board_(board), link_(board, 0, [this](const mavlink::Frame& frame, uint64_t at_us) {
              take(frame, at_us);
          }) {
        board_.setUsb(true);
        board_.listen([this](int usart, uint8_t byte, uint64_t at_us) {
            if (usart == 0) link_.receive(byte, at_us);
        });
    }

    void run_s(double seconds) {
        const uint64_t end_us = board_.time_us() + static_cast<uint64_t>(seconds * 1e6);
        if (!board_.runUntil(end_us)) throw std::runtime_error(board_.fault());
    }
    template <class Done>
    bool waitUntil(double seconds, Done done) {
        for (int i = 0; i < seconds * 100 && !done(); ++i) run_s(0.01);
        return done();
    }
    // The newest result; -1: none came.
    int command(uint16_t number, float param1 = 0, float param2 = 0, float param5 = 0) {
        mavlink::CommandLong message{};
        message.command = number;
        message.param1 = param1;
        message.param2 = param2;
        message.param5 = param5;
        message.target_system = 1;
        message.target_component = 1;
        results_.erase(number);
        link_.send(message);
        waitUntil(2, [&] { return results_.count(number) != 0; });
        return result(number);
    }
    int result(uint16_t number) const {
        const auto found = results_.find(number);
        return found == results_.end() ? -1 : found->second;
    }
    void pressKey(uint16_t count) {
        mavlink::CommandAck key{};
        key.command = count;
        key.result = 1;
        link_.send(key);
    }
    float parameter(const std::string& name) {
        mavlink::ParamRequestRead request{};
        request.param_index = -1;
        request.target_system = 1;
        request.target_component = 1;
        name.copy(request.param_id, sizeof request.param_id);
        values_.erase(name);
        for (int i = 0; i < 5 && values_.count(name) == 0; ++i) {
            link_.send(request);
            waitUntil(1, [&] { return values_.count(name) != 0; });
        }
        return values_.count(name) != 0 ? values_[name] : NAN;
    }
    bool received(const std::string& part) const {
        for (const Event& text : telemetry.texts)
            if (text.text.find(part) != std::string::npos) return true;
        return false;
    }
    int timesReceived(const std::string& part) const {
        int count = 0;
        for (const Event& text : telemetry.texts)
            count += text.text.find(part) != std::string::npos;
        return count;
    }

    void stream(uint8_t which, uint16_t rate_hz) {
        mavlink::RequestDataStream request{};
        request.target_system = 1;
        request.target_component = 1;
        request.req_stream_id = which;
        request.req_message_rate = rate_hz;
        request.start_stop = 1;
        link_.send(request);
    }

    Telemetry telemetry;
    std::optional<mavlink::RawImu> raw_imu;
    int wanted_side = 0;  // of the accelerometers' calibration, as the vehicle last asked for it

private:
    void take(const mavlink::Frame& frame, uint64_t at_us) {
        telemetry.take(frame, at_us);
        if (const auto imu = as<mavlink::RawImu>(frame)) raw_imu = imu;
        if (const auto ack = as<mavlink::CommandAck>(frame)) results_[ack->command] = ack->result;
        if (const auto asked = as<mavlink::CommandLong>(frame))
            if (asked->command == 42429) wanted_side = static_cast<int>(asked->param1);
        if (const auto value = as<mavlink::ParamValue>(frame))
            values_[std::string(value->param_id, strnlen(value->param_id, 16))] =
                value->param_value;
    }

    Board& board_;
    Link link_;
    std::map<uint16_t, int> results_;
    std::map<std::string, float> values_;
};

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// A ground station without any delay at a board's USB port, 115,200 baud: it answers a request in
// the moment in which its last byte has come. Sends missions up and reads them back.
#pragma once
#include <cmath>
#include <cstring>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "simulator/ground/link.hpp"
#include "simulator/ground/waypoints.hpp"

namespace simulator {

inline mavlink::ParamSet paramSet(uint8_t system, const char* name, float value) {
    mavlink::ParamSet message{};
    message.target_system = system;
    message.target_component = 1;
    message.param_value = value;
    std::memcpy(message.param_id, name, strnlen(name, sizeof message.param_id));
    message.param_type = mavlink::MavParamType::real32;
    return message;
}

class Station {
public:
    static constexpr int kUsb = 0;

    explicit Station(Board& board)
        : board_(board), link_(board, kUsb, [this](const mavlink::Frame& frame, uint64_t at_us) {
              take(frame, at_us);
          }) {
        board_.setUsb(true);
        board_.listen([this](int usart, uint8_t byte, uint64_t at_us) {
            if (usart == kUsb) link_.receive(byte, at_us);
        });
    }

    void connect() {
        waitUntil("a heartbeat", 10, [this] { return system_ != 0; });
    }

    // Each throws when it is not accepted.
    void upload(const Waypoints& items) {
        mavlink::MissionCount message{};
        message.count = static_cast<uint16_t>(items.size());
        change(message, items);
    }
    void replace(int first, int last, const Waypoints& items) {
        mavlink::MissionWritePartialList message{};
        message.start_index = static_cast<int16_t>(first);
        message.end_index = static_cast<int16_t>(last);
        change(message, items);
    }
    void clear() { change(mavlink::MissionClearAll{}, {}); }

    void set(const char* parameter, float value) {
        link_.send(paramSet(system_, parameter, value));
        run_us(200'000);
    }
    // Whatever the checks say.
    void arm(bool armed) {
        constexpr float kForce = 21196;
        mavlink::CommandLong message{};
        message.command = mavlink::MavCmd::component_arm_disarm;
        message.target_system = system_;
        message.target_component = 1;
        message.param1 = armed;
        message.param2 = kForce;
        link_.send(message);
    }

    // Of the last one: from its first byte to the last of the last request, and of the answer.
    uint64_t asked_us() const { return request_us_ - began_us_; }
    uint64_t answered_us() const { return answer_us_ - began_us_; }
    bool answered() const { return result_.has_value(); }

    std::vector<mavlink::MissionItemInt> download() {
        mavlink::MissionRequestList ask{};
        ask.target_system = system_;
        ask.target_component = 1;
        count_.reset();
        items_.clear();
        link_.send(ask);
        waitUntil("a mission's count", 5, [this] { return count_.has_value(); });
        while (items_.size() < *count_) {
            const size_t had = items_.size();
            mavlink::MissionRequestInt request{};
            request.target_system = system_;
            request.target_component = 1;
            request.seq = static_cast<uint16_t>(had);
            link_.send(request);
            waitUntil("an item", 5, [&] { return items_.size() > had; });
        }
        return items_;
    }

    template <class Done>
    void waitUntil(const std::string& what, double seconds, Done done) {
        const uint64_t end_us = board_.time_us() + static_cast<uint64_t>(seconds * 1e6);
        while (!done()) {
            if (board_.time_us() > end_us) throw std::runtime_error("no " + what + " came");
            run_us(1000);
        }
    }
    // on_step, when there is one, sees the board every tenth of a millisecond.
    std::function<void()> on_step;
    void run_us(uint64_t time_us) {
        for (; on_step && time_us > kStep_us; time_us -= kStep_us) {
            if (!board_.runUntil(board_.time_us() + kStep_us))
                throw std::runtime_error(board_.fault());
            on_step();
        }
        if (!board_.runUntil(board_.time_us() + time_us)) throw std::runtime_error(board_.fault());
    }

    Link& link() { return link_; }
    uint8_t system() const { return system_; }

private:
    static constexpr uint64_t kStep_us = 100;

    template <class Message>
    void change(Message message, const Waypoints& items) {
        message.target_system = system_;
        message.target_component = 1;
        to_send_ = items;
        result_.reset();
        began_us_ = board_.time_us();
        link_.send(message);
        waitUntil("answer to a change of the mission", 30, [this] { return answered(); });
        if (*result_ != mavlink::MavMissionResult::accepted)
            throw std::runtime_error("mission refused: " + std::to_string(*result_));
    }

    void answer(unsigned number) {
        if (number >= to_send_.size()) return;
        const WaypointItem& from = to_send_[number];
        mavlink::MissionItemInt item{};
        item.target_system = system_;
        item.target_component = 1;
        item.seq = static_cast<uint16_t>(number);
        item.command = from.command;
        item.frame = from.frame;
        item.x = static_cast<int32_t>(std::lround(from.latitude_deg * 1e7));
        item.y = static_cast<int32_t>(std::lround(from.longitude_deg * 1e7));
        item.z = static_cast<float>(from.altitude_m);
        item.autocontinue = 1;
        link_.send(item);
    }

    void take(const mavlink::Frame& frame, uint64_t at_us) {
        system_ = frame.system;
        if (const auto request = as<mavlink::MissionRequestInt>(frame)) {
            request_us_ = at_us;
            answer(request->seq);
        }
        if (const auto ack = as<mavlink::MissionAck>(frame)) {
            answer_us_ = at_us;
            result_ = ack->type;
        }
        if (const auto count = as<mavlink::MissionCount>(frame)) count_ = count->count;
        if (const auto item = as<mavlink::MissionItemInt>(frame))
            if (item->seq == items_.size()) items_.push_back(*item);
    }

    Board& board_;
    Link link_;
    uint8_t system_ = 0;
    Waypoints to_send_;
    uint64_t began_us_ = 0, request_us_ = 0, answer_us_ = 0;
    std::optional<uint8_t> result_;
    std::optional<uint16_t> count_;
    std::vector<mavlink::MissionItemInt> items_;
};

// Home and waypoints; another `seed`, other places.
inline Waypoints someMission(int count, int seed) {
    Waypoints items(static_cast<size_t>(count));
    for (int i = 0; i < count; ++i) {
        WaypointItem& item = items[static_cast<size_t>(i)];
        item.index = i;
        item.frame = i == 0 ? 0 : 3;
        item.command = mavlink::MavCmd::nav_waypoint;
        item.latitude_deg = 47.3977 + 1e-5 * (37 * i + 101 * seed);
        item.longitude_deg = 8.5456 + 1e-5 * (53 * i + 11 * seed);
        item.altitude_m = 50 + seed;
    }
    return items;
}

// Item 0 is home, which is the vehicle's.
inline bool same(const std::vector<mavlink::MissionItemInt>& stored, const Waypoints& wanted) {
    if (stored.size() != wanted.size()) return false;
    for (size_t i = 1; i < wanted.size(); ++i) {
        if (stored[i].command != wanted[i].command || stored[i].frame != wanted[i].frame ||
            stored[i].x != std::lround(wanted[i].latitude_deg * 1e7) ||
            stored[i].y != std::lround(wanted[i].longitude_deg * 1e7) ||
            std::fabs(stored[i].z - wanted[i].altitude_m) > 0.005)
            return false;
    }
    return true;
}

}  // namespace simulator

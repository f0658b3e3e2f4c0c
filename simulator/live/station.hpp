// SPDX-License-Identifier: GPL-3.0-or-later
// The ground station behind the live page: asks for all streams, reads the plans that the board
// holds, and gives commands, one at a time. It sends no heartbeats, so that the loss of the user's
// own ground station is still noticed. Times are emulated.
#pragma once
#include <deque>
#include <functional>
#include <map>
#include <memory>

#include "simulator/ground/mission_upload.hpp"
#include "simulator/ground/telemetry.hpp"
#include "simulator/live/order.hpp"
#include "simulator/live/plan_download.hpp"

namespace simulator::live {

// Of a command: what the autopilot has answered, with the texts it sent meanwhile.
using Answer = std::function<void(bool ok, const std::string& text)>;

std::string resultName(uint8_t result);  // MAV_RESULT

class Station {
public:
    Station(Board& board, int usart);

    int usart() const { return link_.usart(); }
    void receive(uint8_t byte, uint64_t time_us) { link_.receive(byte, time_us); }
    // What the board sends to others: an upload of theirs changes what is known of its plans.
    void overhear(const mavlink::Frame& frame);
    void step(uint64_t now_us);

    // arm, disarm, takeoff, mode, go_to.
    void give(const Order& order, Answer answer);

    const Telemetry& telemetry() const { return telemetry_; }
    Telemetry& telemetry() { return telemetry_; }
    const PlanDownload& plans() const { return plans_; }
    std::optional<double> parameter(const std::string& name) const;  // of those it asks for

    // Called for each; the texts go to the telemetry as well.
    std::function<void(const mavlink::Statustext&, uint64_t time_us)> on_text =
        [](const mavlink::Statustext&, uint64_t) {};

private:
    struct Command {
        std::function<void(uint8_t confirmation)> send;
        uint16_t number;
        Answer answer;
        std::function<bool()> shows = {};  // in the heartbeat, once it was accepted
        int tries = 0;
        uint64_t sent_us = 0;
        std::optional<uint8_t> result = {};
        uint64_t answered_us = 0;
        std::string texts = {};
    };
    void take(const mavlink::Frame& frame, uint64_t time_us);
    void takeAck(const mavlink::CommandAck& ack, uint64_t time_us);
    void takeText(const mavlink::Statustext& text, uint64_t time_us);
    void askForStreams(uint64_t now_us);
    void askForParameters(uint64_t now_us);
    void runCommand(uint64_t now_us);
    void finish(bool ok, const std::string& text);
    void command(uint16_t number, std::array<float, 2> params, Answer answer,
                 std::function<bool()> shows = {});
    void arm(bool armed, Answer answer);
    void setMode(uint32_t mode, Answer answer);
    void goTo(const Order& order, Answer answer);
    void takeOff(Answer answer);
    bool beginsWithTakeoff() const;
    void uploadTakeoff(Answer answer);
    void runUpload(uint64_t now_us);

    Link link_;
    Telemetry telemetry_;
    PlanDownload plans_;
    std::deque<Command> commands_;  // the first one is under way
    std::map<std::string, double> parameters_;
    uint64_t streams_asked_us_ = 0, attitude_us_ = 0, parameters_asked_us_ = 0;
    bool was_armed_ = false;
    Waypoints upload_items_;
    std::unique_ptr<MissionUpload> upload_;
    Answer upload_answer_;
};

}  // namespace simulator::live

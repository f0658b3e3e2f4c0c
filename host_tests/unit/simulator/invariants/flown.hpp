// SPDX-License-Identifier: GPL-3.0-or-later
// A flight that a test makes up: it stands or flies as it is set, sends a heartbeat a second, and
// is seen by a Watch in every frame.
#pragma once
#include <cstring>
#include <string>

#include "mavlink/peer.hpp"
#include "simulator/ground/link.hpp"
#include "simulator/invariants/watch.hpp"

namespace simulator::invariants {

class Flown {
public:
    Flown() {
        now.truth.on_ground = true;
        now.truth.latitude_deg = 47;
        now.truth.longitude_deg = 8;
        now.truth.altitude_m = 488;
        now.servo_us = {1500, 1500, 1100, 1500, 1500, 1500, 1500, 1500};
        now.stick_us = {1500, 1500, 1100, 1500, 1500, 1500, 1500, 1425};
        now.transmitting = true;
    }

    Snapshot now;
    bool armed = false, reports_place = false;
    uint32_t mode = 5;
    mavlink::GlobalPositionInt place{};
    mavlink::VfrHud hud{};
    Watch watch;

    void arm() {
        command(mavlink::MavCmd::component_arm_disarm, 1);
        armed = true;
    }
    void inTheAir(double height_m = 100) {
        arm();
        now.truth.on_ground = false;
        now.truth.height_m = height_m;
        now.truth.airspeed_mps = now.truth.equivalent_airspeed_mps = 12;
        now.truth.velocity_north_mps = 12;
    }
    void onTheGround() {
        now.truth.on_ground = true;
        now.truth.height_m = now.truth.velocity_north_mps = now.truth.airspeed_mps = 0;
    }
    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds * 100 + 0.5); ++i) {
            now.time_us += 10'000;
            watch.frame(now);
            if (now.time_us % 1'000'000 == 0) beat();
            if (reports_place && now.time_us % 100'000 == 0) reportPlace();
        }
    }
    template <class Message>
    void received(const Message& message) {
        whole(message,
              [this](const mavlink::Frame& frame) { watch.received(frame, now.time_s()); });
    }
    template <class Message>
    void sent(const Message& message) {
        whole(message, [this](const mavlink::Frame& frame) { watch.sent(frame, now.time_s()); });
    }
    void sets(const char* name, float value) {
        mavlink::ParamSet message{};
        std::strncpy(message.param_id, name, sizeof message.param_id);
        message.param_value = value;
        sent(message);
    }
    void text(const char* words) {
        mavlink::Statustext message{};
        std::strncpy(message.text, words, sizeof message.text);
        received(message);
    }
    void command(uint16_t number, float param1 = 0, float param2 = 0) {
        mavlink::CommandLong message{};
        message.command = number;
        message.param1 = param1;
        message.param2 = param2;
        sent(message);
    }
    void parameter(const char* name, float value) {
        mavlink::ParamValue message{};
        std::strncpy(message.param_id, name, sizeof message.param_id);
        message.param_value = value;
        received(message);
    }
    // By the program of a bootloader that takes no time.
    void restart() {
        ++now.restarts;
        now.begun_us = now.time_us;
    }
    // The names of what was violated, in order, with a blank behind each.
    std::string violated() {
        watch.end(figures);
        std::string names;
        for (const Violation& each : watch.violations()) names += each.name + " ";
        return names;
    }
    BoardFigures figures;

private:
    template <class Message, class Use>
    void whole(const Message& message, Use use) {
        uint8_t bytes[mavlink::kLongestFrame];
        const mavlink::Sender sender{mavlink::Framing::v2, 0, 1, 1};
        const uint16_t size = mavlink::encode(sender, message, bytes);
        mavlink::PeerParser parser;
        for (uint16_t i = 0; i < size; ++i)
            if (parser.put(bytes[i])) use(parser.frame());
    }
    void beat() {
        mavlink::Heartbeat message{};
        message.autopilot = 3;
        message.custom_mode = mode;
        message.base_mode = armed ? mavlink::MavModeFlag::safety_armed : 0;
        received(message);
    }
    void reportPlace() {
        received(place);
        received(hud);
    }
};

}  // namespace simulator::invariants

// SPDX-License-Identifier: GPL-3.0-or-later
// What the autopilot has said of itself so far: the newest of each message, and the mission's
// progress as a list of events with their times.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mavlink/frame.hpp"
#include "mavlink/messages.hpp"

namespace simulator {

constexpr uint32_t kModeAuto = 10;
std::string modeName(uint32_t custom_mode);  // ArduPlane's numbers

struct Event {
    double time_s;
    std::string text;
    int severity = 6;  // MAV_SEVERITY of a status text
};

class Telemetry {
public:
    void take(const mavlink::Frame& frame, uint64_t time_us);
    void note(uint64_t time_us, const std::string& text);  // adds an event

    bool heard() const { return heartbeat.has_value(); }
    uint32_t mode() const { return heartbeat ? heartbeat->custom_mode : 0; }
    bool armed() const;
    bool prearmOk() const;  // also true when the autopilot does not report it
    int current() const { return mission_current ? mission_current->seq : 0; }

    uint8_t system = 0, component = 0;
    uint64_t heartbeat_us = 0;
    std::optional<mavlink::Heartbeat> heartbeat;
    std::optional<mavlink::SysStatus> status;
    std::optional<mavlink::GpsRawInt> gps;
    std::optional<mavlink::Attitude> attitude;
    std::optional<mavlink::GlobalPositionInt> position;
    std::optional<mavlink::VfrHud> hud;
    std::optional<mavlink::NavControllerOutput> navigation;
    std::optional<mavlink::MissionCurrent> mission_current;
    std::optional<mavlink::ServoOutputRaw> servos;
    std::optional<mavlink::RcChannels> rc;
    std::optional<mavlink::RawImu> imu;
    std::optional<mavlink::Wind> wind;
    std::optional<mavlink::Hwstatus> hardware;
    std::vector<int> reached;   // MISSION_ITEM_REACHED in order
    std::vector<int> visited;   // what MISSION_CURRENT has named in AUTO, in order
    std::vector<Event> events;  // mode, arming and mission progress
    std::vector<Event> texts;   // STATUSTEXT
    uint32_t messages = 0;

private:
    void takeHeartbeat(const mavlink::Frame& frame, uint64_t time_us);
    void takeCurrent(const mavlink::MissionCurrent& current, uint64_t time_us);
    void takeReached(int item, uint64_t time_us);
    void takeText(const mavlink::Statustext& text, uint64_t time_us);
};

}  // namespace simulator

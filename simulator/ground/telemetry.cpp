// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/telemetry.hpp"

#include <array>
#include <utility>

#include "simulator/ground/link.hpp"

namespace simulator {

using namespace mavlink;

std::string modeName(uint32_t custom_mode) {
    static constexpr std::array<const char*, 27> kNames = {
        "MANUAL",  "CIRCLE",       "STABILIZE",  "TRAINING", "ACRO",         "FBWA",
        "FBWB",    "CRUISE",       "AUTOTUNE",   nullptr,    "AUTO",         "RTL",
        "LOITER",  "TAKEOFF",      "AVOID_ADSB", "GUIDED",   "INITIALISING", "QSTABILIZE",
        "QHOVER",  "QLOITER",      "QLAND",      "QRTL",     "QAUTOTUNE",    "QACRO",
        "THERMAL", "LOITER2QLAND", "AUTOLAND"};
    if (custom_mode < kNames.size() && kNames[custom_mode]) return kNames[custom_mode];
    return "mode " + std::to_string(custom_mode);
}

bool Telemetry::armed() const {
    return heartbeat && (heartbeat->base_mode & MavModeFlag::safety_armed) != 0;
}

bool Telemetry::prearmOk() const {
    constexpr uint32_t kPrearm = 0x10000000;  // MAV_SYS_STATUS_PREARM_CHECK
    if (!status || (status->onboard_control_sensors_present & kPrearm) == 0) return true;
    return (status->onboard_control_sensors_health & kPrearm) != 0;
}

void Telemetry::note(uint64_t time_us, const std::string& text) {
    events.push_back({static_cast<double>(time_us) * 1e-6, text});
}

void Telemetry::take(const Frame& frame, uint64_t time_us) {
    ++messages;
    if (frame.id == Wire<Heartbeat>::id) return takeHeartbeat(frame, time_us);
    if (auto m = as<SysStatus>(frame)) status = m;
    if (auto m = as<GpsRawInt>(frame)) gps = m;
    if (auto m = as<Attitude>(frame)) attitude = m;
    if (auto m = as<GlobalPositionInt>(frame)) position = m;
    if (auto m = as<VfrHud>(frame)) hud = m;
    if (auto m = as<NavControllerOutput>(frame)) navigation = m;
    if (auto m = as<ServoOutputRaw>(frame)) servos = m;
    if (auto m = as<RcChannels>(frame)) rc = m;
    if (auto m = as<RawImu>(frame)) imu = m;
    if (auto m = as<Wind>(frame)) wind = m;
    if (auto m = as<Hwstatus>(frame)) hardware = m;
    if (auto m = as<MissionCurrent>(frame)) takeCurrent(*m, time_us);
    if (auto m = as<MissionItemReached>(frame)) takeReached(m->seq, time_us);
    if (auto m = as<Statustext>(frame)) takeText(*m, time_us);
}

void Telemetry::takeHeartbeat(const Frame& frame, uint64_t time_us) {
    const auto message = frame.read<Heartbeat>();
    if (message.autopilot == MavAutopilot::invalid) return;  // a ground station, not a vehicle
    const bool was_armed = armed();
    const bool mode_changed = !heard() || mode() != message.custom_mode;
    heartbeat = message;
    heartbeat_us = time_us;
    system = frame.system;
    component = frame.component;
    if (mode_changed) note(time_us, "mode " + modeName(mode()));
    if (armed() != was_armed) note(time_us, armed() ? "armed" : "disarmed");
}

void Telemetry::takeCurrent(const MissionCurrent& message, uint64_t time_us) {
    mission_current = message;
    if (mode() != kModeAuto || message.seq == 0) return;
    if (!visited.empty() && visited.back() == message.seq) return;
    visited.push_back(message.seq);
    note(time_us, "flies item " + std::to_string(message.seq));
}

void Telemetry::takeReached(int item, uint64_t time_us) {
    reached.push_back(item);
    note(time_us, "reached item " + std::to_string(item));
}

void Telemetry::takeText(const Statustext& message, uint64_t time_us) {
    const std::string text(message.text, strnlen(message.text, sizeof message.text));
    texts.push_back({static_cast<double>(time_us) * 1e-6, text, message.severity});
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// A flight of the image in which happens what a quiet mission never shows: both links stream at
// 10 Hz, the radio is lost for a while and for long, the mode switch moves, parameters are set,
// lists are asked for, the mission is sent up again in the air. Writes OUT/summary.json, so that
// what the tasks took is known for these cases too. Fails when the airplane does not stay in the
// air, a frame is late, or something asked for was not done.
//   rough_flight FIRMWARE MISSION OUT MINUTES_FOLDER [PROFILE]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "host_tests/scenarios/flight_scenario.hpp"
#include "simulator/devices/at45db.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/invariants/watched_board.hpp"

using namespace simulator;
namespace fs = std::filesystem;
using mavlink::MavCmd;

namespace {

constexpr uint64_t kStep_us = 10'000;
constexpr double kFrom_s = 25;  // in the air and past the take-off
constexpr double kEnd_s = 175;
constexpr uint16_t kFencePoints = 20;
constexpr uint16_t kManual = 1815, kFbwa = 1425, kRtl = 1165;  // pulses of FLTMODE_CH

class RoughFlight : FlightScenario {
public:
    RoughFlight(Board& board, const Waypoints& items)
        : FlightScenario(board, items, kEnd_s + 60, kStep_us,
                         [this](const mavlink::Frame& f, uint64_t at_us) { take(f, at_us); }),
          upload_(usb_, items_) {}

    void fly() {
        size_t next = 0;
        while (!flight_.over() && sinceAirborne_s() < kEnd_s) {
            advance();
            if (uploading_)
                upload_.step(board_.time_us(), telemetry().system, telemetry().component);
            if (next == kTroubles.size() || sinceAirborne_s() < kTroubles[next].at_s) continue;
            std::printf("%6.1f s  %s\n", seconds(), kTroubles[next].what);
            (this->*kTroubles[next++].happens)();
        }
    }

    bool check();
    Summary summary(const std::string& firmware, const WorldOptions& world) const {
        return summarised("rough flight", passed_, firmware, world);
    }

private:
    struct Trouble {
        double at_s;  // after take-off
        const char* what;
        void (RoughFlight::*happens)();
    };
    static const std::vector<Trouble> kTroubles;

    const Telemetry& telemetry() const { return flight_.telemetry(); }

    void take(const mavlink::Frame& frame, uint64_t at_us) {
        ++usb_messages_;
        upload_.take(frame, at_us);
        if (as<mavlink::ParamValue>(frame)) ++parameters_sent_;
        const auto asked = as<mavlink::MissionRequestInt>(frame);
        if (asked && asked->mission_type == mavlink::MavMissionType::fence)
            sendFencePoint(asked->seq);
        if (as<mavlink::MissionCount>(frame)) asked_for_mission_ = false;
    }

    template <class Message>
    Message addressed() const {
        Message message{};
        message.target_system = telemetry().system;
        message.target_component = telemetry().component;
        return message;
    }

    void streams() {
        auto request = addressed<mavlink::RequestDataStream>();
        request.req_message_rate = 10;
        request.start_stop = 1;
        usb_.send(request);
    }
    void listParameters() { usb_.send(addressed<mavlink::ParamRequestList>()); }
    void listMission() {
        usb_.send(addressed<mavlink::MissionRequestList>());
        asked_for_mission_ = true;
    }
    void setParameters() {
        send("WP_LOITER_RAD", 70);
        send("RLL2SRV_P", 0.8F);
        send("PTCH2SRV_P", 1.1F);
        send("FS_LONG_ACTN", 1);  // so that a lasting loss of the radio is seen: RTL
        send("LIM_ROLL_CD", 4000);
    }
    void sendMission() {
        uploading_ = true;
        modes_.push_back(telemetry().mode());
    }
    // The largest there is, around all of the flight, and only to be reported.
    void sendFence() {
        send("FENCE_ACTION", 2);
        auto count = addressed<mavlink::MissionCount>();
        count.count = kFencePoints;
        count.mission_type = mavlink::MavMissionType::fence;
        usb_.send(count);
    }
    void sendFencePoint(uint16_t seq) {
        auto item = addressed<mavlink::MissionItemInt>();
        const double angle = 2 * M_PI * seq / (kFencePoints - 1);
        const double away_deg = seq == 0 ? 0 : 0.05;  // 4 km and more
        item.seq = seq;
        item.command =
            seq == 0 ? MavCmd::nav_fence_return_point : MavCmd::nav_fence_polygon_vertex_inclusion;
        item.param1 = kFencePoints - 1;
        item.x = static_cast<int32_t>((items_[0].latitude_deg + away_deg * std::cos(angle)) * 1e7);
        item.y = static_cast<int32_t>((items_[0].longitude_deg + away_deg * std::sin(angle)) * 1e7);
        item.mission_type = mavlink::MavMissionType::fence;
        usb_.send(item);
    }
    void fenceOn() { command(MavCmd::do_fence_enable, 1, 0); }
    void command(uint16_t number, float param1, float param2) {
        auto message = addressed<mavlink::CommandLong>();
        message.command = number;
        message.param1 = param1;
        message.param2 = param2;
        usb_.send(message);
    }
    void toAuto() { command(MavCmd::do_set_mode, 1, kModeAuto); }
    void disarm() { command(MavCmd::component_arm_disarm, 0, 0); }  // refused in the air
    void sticks(uint16_t mode_us, bool on = true, uint16_t throttle_us = 1500) {
        board_.world().radio().sticks({1500, 1500, throttle_us, 1500, 1500, 1500, 1500, mode_us},
                                      on);
    }
    void switchToRtl() { sticks(kRtl); }
    void switchToManual() { sticks(kManual); }
    void switchToFbwa() { sticks(kFbwa); }
    void radioOff() { sticks(kFbwa, false); }
    void radioFailsafePulses() { sticks(kFbwa, true, 900); }

    bool said(const char* text) const {
        return std::any_of(
            telemetry().texts.begin(), telemetry().texts.end(),
            [&](const Event& event) { return event.text.find(text) != std::string::npos; });
    }
    bool happened(const char* event) const {
        return std::any_of(telemetry().events.begin(), telemetry().events.end(),
                           [&](const Event& e) { return e.text == event; });
    }

    MissionUpload upload_;
    std::vector<uint32_t> modes_;
    bool uploading_ = false, asked_for_mission_ = false, passed_ = false;
    int usb_messages_ = 0, parameters_sent_ = 0;
};

const std::vector<RoughFlight::Trouble> RoughFlight::kTroubles = {
    {2, "all streams on USB too", &RoughFlight::streams},
    {5, "a fence is sent up", &RoughFlight::sendFence},
    {15, "and switched on", &RoughFlight::fenceOn},
    {kFrom_s, "parameters are asked for", &RoughFlight::listParameters},
    {kFrom_s + 15, "parameters are set", &RoughFlight::setParameters},
    {kFrom_s + 20, "the mission is asked for", &RoughFlight::listMission},
    {kFrom_s + 25, "disarm, which must be refused", &RoughFlight::disarm},
    {kFrom_s + 30, "mode switch to RTL", &RoughFlight::switchToRtl},
    {kFrom_s + 36, "mode switch to MANUAL", &RoughFlight::switchToManual},
    {kFrom_s + 37.5, "mode switch to FBWA", &RoughFlight::switchToFbwa},
    {kFrom_s + 42, "AUTO again", &RoughFlight::toAuto},
    {kFrom_s + 55, "the radio sends its failsafe pulses", &RoughFlight::radioFailsafePulses},
    {kFrom_s + 59, "the radio is back", &RoughFlight::switchToFbwa},
    {kFrom_s + 65, "the radio is silent", &RoughFlight::radioOff},
    {kFrom_s + 80, "the radio is back", &RoughFlight::switchToFbwa},
    {kFrom_s + 84, "AUTO again", &RoughFlight::toAuto},
    {kFrom_s + 95, "the mission is sent up again", &RoughFlight::sendMission},
    {kFrom_s + 115, "AUTO again", &RoughFlight::toAuto},
    {kFrom_s + 120, "parameters are asked for again", &RoughFlight::listParameters},
};

bool RoughFlight::check() {
    const BoardFigures figures = board_.figures();
    passed_ = printChecks({
        {"it flew to the end", !flight_.over()},
        {"no frame was late", figures.frame_overruns == 0u},
        {"no inertial sample was lost",
         recorder_.imuSamples() && recorder_.imuSamples()->lost == 0},
        {"USB sent all its streams", usb_messages_ > 1000},
        {"every parameter was sent", parameters_sent_ > 200},
        {"the mission was sent", !asked_for_mission_},
        {"the fence was stored", said("Fence stored: 20 points")},
        {"the fence was on, and never broken", said("Fence on") && !said("Fence breach")},
        {"the mode switch led to RTL", happened("mode RTL")},
        {"the mode switch led to MANUAL", happened("mode MANUAL")},
        {"the short failsafe was reported", said("short failsafe")},
        {"the long failsafe was reported", said("long failsafe")},
        {"the missions went through the DataFlash", board_.world().dataflash().programs(0) > 0},
        {"the DataFlash was never asked for what it cannot do then",
         board_.world().dataflash().ignored() == 0},
        {"the radio came back", said("Radio back")},
        {"the mission was taken in flight", upload_.accepted()},
        {"it is armed and in AUTO again", telemetry().armed() && telemetry().mode() == kModeAuto},
    });
    if (!upload_.failure().empty()) std::printf("  %s\n", upload_.failure().c_str());
    if (!passed_) printEvents(flight_);
    return passed_;
}

}  // namespace

int main(int count, char** words) {
    if (count != 5 && count != 6) {
        std::cerr << "usage: rough_flight FIRMWARE MISSION OUT MINUTES_FOLDER [PROFILE]\n";
        return 2;
    }
    const std::string firmware = words[1];
    const fs::path out = words[3], minutes = words[4];
    emptyFolder(out);
    const Waypoints items = readWaypoints(words[2]);
    const WorldOptions world = gustyWorldAt(items, 5, 4);
    AvrBoard board(firmware, world);
    WatchedBoard watched(board);
    RoughFlight flight(watched, items);
    if (count == 6) board.profileTo(words[5]);
    flight.fly();
    board.closeProfile();
    const bool passed = flight.check() && watched.held();
    writeOutcome(out, minutes, flight.summary(firmware, world));
    return passed ? 0 : 1;
}

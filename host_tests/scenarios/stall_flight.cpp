// SPDX-License-Identifier: GPL-3.0-or-later
// Every airplane is stalled from 120 m in FBWA by a pilot who closes the throttle and pulls: who
// lets go then, and who holds the stick back. Fails when the wing does not fly again with less than
// 60 m lost, and when it does without the firmware's help, as then nothing is shown.
//   stall_flight AIRPLANES_FOLDER
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "host_tests/scenarios/flight_report.hpp"
#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/native/native_board.hpp"
#include "simulator/parameter_file.hpp"

using namespace simulator;

namespace {

constexpr int kTelemetry = 2;
constexpr uint64_t kStep_us = 20'000;
constexpr double kDegree = M_PI / 180;
constexpr double kFrom_m = 120, kMaxLost_m = 60, kLimit_s = 240;
constexpr double kStalled_rad = 20 * kDegree;  // each of them has stalled at 17
constexpr double kFlying_rad = 12 * kDegree;
constexpr double kFlyingFor_s = 1;
constexpr double kSinking_mps = 2;  // no faster, when it is out

struct Case {
    const char* airplane;
    bool holds;  // the stick back, all the way down
    bool prevented;
};

Waypoints climb() {
    const auto item = [](int index, uint16_t command, uint8_t frame, double height_m) {
        WaypointItem made;
        made.index = index;
        made.command = command;
        made.frame = frame;
        made.latitude_deg = 47.3977;
        made.longitude_deg = 8.5456;
        made.altitude_m = height_m;
        return made;
    };
    Waypoints items = {item(0, mavlink::MavCmd::nav_waypoint, 0, 488),
                       item(1, mavlink::MavCmd::nav_takeoff, 3, kFrom_m),
                       item(2, mavlink::MavCmd::nav_loiter_unlim, 3, kFrom_m)};
    items[1].params[0] = 15;
    return items;
}

ParameterSettings settingsOf(const std::string& folder, const Case& flown) {
    auto settings = readParameterFile(folder + "/" + flown.airplane + ".param");
    settings.push_back({"FLTMODE2", 10.0f});  // AUTO, where the switch is moved from
    settings.push_back({"STALL_PREVENTION", flown.prevented ? 1.0f : 0.0f});
    return settings;
}

class StallFlight {
public:
    StallFlight(Board& board, const Waypoints& items, const std::string& folder, const Case& flown)
        : case_(flown),
          board_(board),
          flight_(board, kTelemetry, items, kLimit_s, settingsOf(folder, flown)) {
        board_.listen([this](int usart, uint8_t byte, uint64_t at_us) {
            if (usart == kTelemetry) flight_.receive(byte, at_us);
        });
        switchTransmitterOn(board_.world());
    }

    // How much height it cost; nothing when the wing did not fly again.
    std::optional<double> fly() {
        for (uint64_t step = 1; seconds() < kLimit_s; ++step) {
            if (!board_.runUntil(step * kStep_us)) return std::nullopt;
            const Truth& truth = board_.world().truth();
            if (!fbwa_ && !flight_.over()) flight_.step(board_.time_us());
            if (truth.crashed || (stalled_m_ > 0 && truth.on_ground)) return std::nullopt;
            steer(truth);
            watch(truth);
            if (flying_s_ >= kFlyingFor_s) return stalled_m_ - truth.height_m;
        }
        return std::nullopt;
    }

private:
    double seconds() const { return static_cast<double>(board_.time_us()) * 1e-6; }

    void steer(const Truth& truth) {
        constexpr uint16_t kAuto_us = 1300, kFbwa_us = 1425, kClosed_us = 1100, kBack_us = 1900;
        if (!flight_.airborne_s()) return;
        fbwa_ = fbwa_ || (truth.height_m > kFrom_m - 5 && std::abs(truth.roll_rad) < 30 * kDegree);
        const bool pulls = fbwa_ && (case_.holds || stalled_m_ == 0);
        const uint16_t pitch_us = pulls ? kBack_us : 1500;
        board_.world().radio().sticks(
            {1500, pitch_us, kClosed_us, 1500, 1500, 1500, 1500, fbwa_ ? kFbwa_us : kAuto_us},
            true);
    }

    void watch(const Truth& truth) {
        if (!fbwa_) return;
        if (stalled_m_ == 0 && truth.alpha_rad > kStalled_rad) stalled_m_ = truth.height_m;
        const bool flies = truth.alpha_rad < kFlying_rad && truth.velocity_down_mps < kSinking_mps;
        flying_s_ = stalled_m_ > 0 && flies ? flying_s_ + kStep_us * 1e-6 : 0;
    }

    const Case case_;
    Board& board_;
    ScriptedFlight flight_;
    bool fbwa_ = false;
    double stalled_m_ = 0, flying_s_ = 0;
};

bool flyAndTell(const std::string& folder, const Case& flown) {
    const Waypoints items = climb();
    WorldOptions world = worldAt(items);
    world.airplane = flown.airplane;
    NativeBoard board(world);
    WatchedBoard watched(board);
    if (!flown.prevented) watched.watch().excuse("surface_at_its_stop");
    const auto lost_m = StallFlight(watched, items, folder, flown).fly();
    const bool out = lost_m && *lost_m < kMaxLost_m;
    const bool well = out == flown.prevented && watched.held();
    std::printf("  %s  %s, stick %s, STALL_PREVENTION %d: ", well ? "ok    " : "FAILED",
                flown.airplane, flown.holds ? "held back" : "let go", flown.prevented);
    if (lost_m)
        std::printf("%.0f m lost\n", *lost_m);
    else
        std::printf("down to the ground\n");
    std::fflush(stdout);
    return well;
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) {
        std::cerr << "usage: stall_flight AIRPLANES_FOLDER\n";
        return 2;
    }
    // nothing holds the flying wing in a stall
    constexpr Case kCases[] = {
        {"foam_trainer", false, true}, {"foam_trainer", true, true}, {"foam_trainer", false, false},
        {"trainer_6kg", false, true},  {"trainer_6kg", true, true},  {"trainer_6kg", false, false},
        {"flying_wing", false, true},  {"flying_wing", true, true},
    };
    int failed = 0;
    for (const Case& flown : kCases) {  // the firmware is global state: a process each
        const pid_t child = fork();
        if (child == 0) _exit(flyAndTell(words[1], flown) ? 0 : 1);
        int status = 0;
        waitpid(child, &status, 0);
        failed += status != 0;
    }
    return failed == 0 ? 0 : 1;
}

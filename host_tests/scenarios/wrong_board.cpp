// SPDX-License-Identifier: GPL-3.0-or-later
// The image of one board in the chip of the other: it says so and keeps saying it, does not arm
// even when forced to, and puts nothing out on the servos' pins, one of which is a motor's.
//   wrong_board FIRMWARE apm1|apm2 MINUTES_FILE
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "host_tests/scenarios/bench.hpp"
#include "simulator/ground/scripted_flight.hpp"
#include "simulator/machine/apm2_board.hpp"

using namespace simulator;

namespace {

bool ok = true;
void hold(bool holds, const char* what) {
    std::printf("  %s %s\n", holds ? "ok    " : "FAILED", what);
    ok = ok && holds;
}

bool anyPulse(Board& board) {
    for (int output = 1; output <= 8; ++output)
        if (board.world().servoPulse_us(output) != 0) return true;
    return false;
}

// Behind the quickest bootloader, with an inertial sensor that needs all of its 100 ms to answer
// (PS-MPU-6000A 6.3: start-up time for register access), after a regulator that came up 50 ms late.
WorldOptions slowSensor() {
    WorldOptions options;
    options.bootloader = Bootloader::quick;
    constexpr double kLost_s = 0.05 + 0.1 - 0.011;  // once it has its supply the model takes 11 ms
    options.faults = {{Faulty::imu, FaultKind::lost, 0, kLost_s}};
    return options;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 4) throw std::runtime_error("expected FIRMWARE apm1|apm2 MINUTES_FILE");
    const bool first = std::strcmp(argv[2], "apm1") == 0;
    AvrBoard board(argv[1], slowSensor(), first ? kApm1Wiring : kApm2Wiring);
    switchTransmitterOn(board.world());
    board.setUsb(true);  // force is obeyed there alone
    Bench bench(board);
    const char* const text = first ? "Wrong board: for an APM 2" : "Wrong board: for an APM 1";

    bool pulses = false;
    const auto watched = [&](bool done) {
        pulses = pulses || anyPulse(board);
        return done;
    };
    hold(bench.waitUntil(12, [&] { return watched(bench.received(text)); }), "it says so");
    hold(bench.command(mavlink::MavCmd::component_arm_disarm, 1) == mavlink::MavResult::failed,
         "arming is refused");
    hold(bench.command(mavlink::MavCmd::component_arm_disarm, 1, 21196) ==
             mavlink::MavResult::failed,
         "arming by force is refused");
    bench.waitUntil(6, [&] { return watched(false); });
    hold(bench.timesReceived(text) >= 4, "it goes on saying so");
    hold(!bench.telemetry.armed(), "it is not armed");
    hold(!pulses && board.world().truth().throttle == 0, "nothing is put out");
    std::filesystem::create_directories(std::filesystem::path(argv[3]).parent_path());
    std::ofstream(argv[3]) << static_cast<double>(board.time_us()) / 60e6 << '\n';
    return ok ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "wrong_board: %s\n", error.what());
    return 1;
}

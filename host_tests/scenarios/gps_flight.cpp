// SPDX-License-Identifier: GPL-3.0-or-later
// A mission in the course of which the receiver falls silent and another one answers in its place,
// twice: each is found, and the mission is flown to its end.
//   gps_flight MISSION MINUTES_FOLDER
#include <cstdio>
#include <filesystem>

#include "host_tests/scenarios/flight_report.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/native/native_board.hpp"

using namespace simulator;
namespace fs = std::filesystem;

namespace {

struct Swap {
    double airborne_s;
    const char* kind;
    uint32_t baud;
    const char* found;
};
constexpr Swap kSwaps[] = {
    {40, "nmea", 9600, "GPS: NMEA at 9600"},
    {90, "mtk19", 38400, "GPS: MTK 1.9 at 38400"},
    {140, "nmea", 57600, "GPS: NMEA at 57600"},
    {190, "ublox", 9600, "GPS: u-blox at 38400"},
};
constexpr double kMax_s = 12.5;  // the one before must be missed first
constexpr uint64_t kStep_us = 20'000;
constexpr int kTelemetry = 2;

double secondsUntil(const Telemetry& reported, const Swap& swap, double plugged_s) {
    for (const Event& text : reported.texts)
        if (text.time_s > plugged_s && text.text == swap.found) return text.time_s - plugged_s;
    return 1e9;
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) return 2;
    const Waypoints items = readWaypoints(words[1]);
    WorldOptions world = worldAt(items, 4, 320);
    world.gusts = true;
    WatchedBoard board(std::make_unique<NativeBoard>(world));
    ScriptedFlight flight(board, kTelemetry, items, 1200);
    board.listen([&](int usart, uint8_t byte, uint64_t time_us) {
        if (usart == kTelemetry) flight.receive(byte, time_us);
    });
    board.setUsb(false);
    switchTransmitterOn(board.world());
    const Swap* next = kSwaps;
    double plugged_s[std::size(kSwaps)] = {};
    for (uint64_t until_us = kStep_us; !flight.over(); until_us += kStep_us) {
        if (!board.runUntil(until_us)) flight.stop(board.fault());
        flight.step(board.time_us());
        const double now_s = static_cast<double>(until_us) * 1e-6;
        if (next == std::end(kSwaps) || !flight.airborne_s()) continue;
        if (now_s - *flight.airborne_s() < next->airborne_s) continue;
        board.world().plugGps(next->kind, next->baud);
        plugged_s[next++ - kSwaps] = now_s;
    }
    bool ok = flight.completed() && board.held() && next == std::end(kSwaps);
    say(ok, "flown " + flight.reason());
    for (size_t i = 0; i < std::size(kSwaps); ++i) {
        const double after_s = secondsUntil(flight.telemetry(), kSwaps[i], plugged_s[i]);
        ok = ok && after_s <= kMax_s;
        std::printf("  %s %s after %.1f s, at most %.1f\n", after_s <= kMax_s ? "ok    " : "FAILED",
                    kSwaps[i].found, after_s, kMax_s);
    }
    if (!ok) printEvents(flight);
    writeMinutes(fs::path(words[2]) / "gps_flight", static_cast<double>(board.time_us()) / 60e6);
    return ok ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The board finds the receiver it is switched on with, and then every other one that is plugged in
// its place, at its rate, and has a fix of it.
//   gps_bench FIRMWARE|native apm1|apm2 MINUTES_FILE
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "host_tests/scenarios/bench.hpp"
#include "simulator/ground/scripted_flight.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/native/native_board.hpp"

using namespace simulator;

namespace {

struct Case {
    const char* kind;
    uint32_t baud;
    const char* found;
    double max_s;  // from plugging it in; what was there before must be missed first
};
constexpr double kFirst_s = 2;
// clang-format off
constexpr Case kCases[] = {
    {"ublox", 38400,  "GPS: u-blox at 38400",  kFirst_s},
    {"mtk16", 38400,  "GPS: MTK 1.6 at 38400", 11.2},
    {"nmea",  115200, "GPS: NMEA at 115200",   11.2},
    {"mtk19", 9600,   "GPS: MTK 1.9 at 38400", 12.5},
    {"nmea",  57600,  "GPS: NMEA at 57600",    11.2},
    {"ublox", 9600,   "GPS: u-blox at 38400",  12.5},
};
// clang-format on

std::unique_ptr<Board> makeBoard(const char* firmware, bool first) {
    WorldOptions world;
    world.gps = kCases[0].kind;
    world.gps_baud = kCases[0].baud;
    if (std::strcmp(firmware, "native") == 0) return std::make_unique<NativeBoard>(world);
    return std::make_unique<AvrBoard>(firmware, world, first ? kApm1Wiring : kApm2Wiring);
}

bool isFound(Board& board, Bench& bench, const Case& gps) {
    const int before = bench.timesReceived(gps.found);
    if (gps.max_s > kFirst_s) board.world().plugGps(gps.kind, gps.baud);
    const double began_s = static_cast<double>(board.time_us()) * 1e-6;
    const auto fixed = [&] { return bench.telemetry.gps && bench.telemetry.gps->fix_type == 3; };
    bool ok = bench.waitUntil(gps.max_s, [&] { return bench.timesReceived(gps.found) > before; });
    const double found_s = static_cast<double>(board.time_us()) * 1e-6 - began_s;
    ok = bench.waitUntil(5, fixed) && ok;
    std::printf("  %s %s at %u: %.2f s, at most %.1f, and %s fix\n", ok ? "ok    " : "FAILED",
                gps.kind, gps.baud, found_s, gps.max_s, fixed() ? "a" : "NO");
    return ok;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 4) throw std::runtime_error("expected FIRMWARE|native apm1|apm2 MINUTES_FILE");
    WatchedBoard board(makeBoard(argv[1], std::strcmp(argv[2], "apm1") == 0));
    switchTransmitterOn(board.world());
    Bench bench(board);
    bool ok = true;
    for (const Case& gps : kCases) {
        ok = isFound(board, bench, gps) && ok;
        bench.stream(2, 10);  // GPS_RAW_INT
    }
    std::filesystem::create_directories(std::filesystem::path(argv[3]).parent_path());
    std::ofstream(argv[3]) << static_cast<double>(board.time_us()) / 60e6 << '\n';
    return board.held() && ok ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "gps_bench: %s\n", error.what());
    return 1;
}

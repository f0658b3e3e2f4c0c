// SPDX-License-Identifier: GPL-3.0-or-later
// How long the image takes for a mission of 160 items at 115,200 baud, from MISSION_COUNT to
// MISSION_ACK. Prints the times, writes the emulated minutes, exits 0 when all limits hold.
//   upload_time FIRMWARE MINUTES_FILE
#include <cstdio>

#include "host_tests/scenarios/flight_report.hpp"
#include "host_tests/scenarios/station.hpp"
#include "simulator/machine/apm2_board.hpp"

using namespace simulator;

namespace {

constexpr int kItems = 160;
constexpr double kLongest_s = 1.5;

// Of one upload; true: in time.
bool timeUpload(Station& station, const char* what, int seed) {
    const Waypoints mission = someMission(kItems, seed);
    station.upload(mission);
    const double total_s = 1e-6 * static_cast<double>(station.answered_us());
    const double items_s = 1e-6 * static_cast<double>(station.asked_us());
    const bool ok = total_s <= kLongest_s;
    std::printf("  %s %s: %.3f s, of it %.3f s until the last item was asked for\n",
                ok ? "ok    " : "FAILED", what, total_s, items_s);
    return ok;
}

void streamAll(Station& station, uint16_t rate_hz) {
    mavlink::RequestDataStream request{};
    request.target_system = station.system();
    request.target_component = 1;
    request.req_message_rate = rate_hz;
    request.start_stop = 1;
    station.link().send(request);
    station.run_us(1'000'000);
}

bool isStored(Station& station, int seed) {
    const bool ok = same(station.download(), someMission(kItems, seed));
    std::printf("  %s read back\n", ok ? "ok    " : "FAILED");
    return ok;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 3) throw std::runtime_error("expected FIRMWARE MINUTES_FILE");
    AvrBoard board(argv[1], WorldOptions{});
    Station station(board);
    station.connect();
    station.run_us(3'000'000);
    bool ok = timeUpload(station, "the first upload", 1);
    ok = timeUpload(station, "the next, while that is copied", 2) && ok;
    station.link().setFraming(mavlink::Framing::v1);
    ok = timeUpload(station, "in MAVLink 1", 3) && ok;
    streamAll(station, 4);
    ok = timeUpload(station, "beside all streams at 4 Hz", 4) && ok;
    ok = isStored(station, 4) && ok;
    writeMinutes(argv[2], static_cast<double>(board.time_us()) / 60e6);
    return ok ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "upload_time: %s\n", error.what());
    return 1;
}

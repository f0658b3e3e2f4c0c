// SPDX-License-Identifier: GPL-3.0-or-later
// A flight model as others write them for ArduPilot's JSON SITL protocol: it listens on a UDP
// port, is sent servo pulses, moves an airplane on by one step and answers with its state. The
// airplane is the simulator's; the wire is read and written here by hand, on its own.
//   example_peer PORT [AIRPLANE [LAST_WORD AFTER_FRAMES]]
// LAST_WORD is sent instead of a state after so many frames, "-": silence. Ends when nothing has
// come for 20 s.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "simulator/airplane/airplane.hpp"

namespace {

using simulator::Airplane;
using simulator::Truth;

constexpr int kPatience_ms = 20'000;
constexpr uint64_t kThrown_us = 25'000'000;

int listenOn(uint16_t port) {
    const int socket_ = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    own.sin_port = htons(port);
    if (bind(socket_, reinterpret_cast<sockaddr*>(&own), sizeof own) != 0) return -1;
    return socket_;
}

struct Packet {
    uint16_t magic, rate_hz;
    uint32_t count;
    uint16_t pulses_us[16];
};
static_assert(sizeof(Packet) == 40, "as the protocol has it");

simulator::Controls controlsOf(const Packet& packet, bool elevons) {
    const auto deflection = [&packet](int output) {
        const double pulse = packet.pulses_us[output];
        return pulse == 0 ? 0 : std::fmax(-1, std::fmin(1, (pulse - 1500) / 400));
    };
    simulator::Controls out;
    const double first = deflection(0), second = deflection(1);
    out.aileron = elevons ? (first - second) / 2 : first;
    out.elevator = elevons ? (first + second) / 2 : second;
    out.rudder = elevons ? 0 : deflection(3);
    out.throttle = std::fmax(0, std::fmin(1, (packet.pulses_us[2] - 1100.0) / 800));
    return out;
}

std::string stateOf(const Truth& t) {
    char text[900];
    std::snprintf(text, sizeof text,
                  "\n{\"timestamp\":%.6f,\"imu\":{\"gyro\":[%.9g,%.9g,%.9g],\"accel_body\":[%.9g,"
                  "%.9g,%.9g]},\"position\":[%.9g,%.9g,%.9g],\"attitude\":[%.9g,%.9g,%.9g],"
                  "\"velocity\":[%.9g,%.9g,%.9g],\"velocity_wind\":[%.9g,%.9g,%.9g],"
                  "\"battery\":{\"voltage\":%.4f,\"current\":%.4f}}\n",
                  100 + static_cast<double>(t.time_us) * 1e-6, t.roll_rate_rads, t.pitch_rate_rads,
                  t.yaw_rate_rads, t.force_x_mss, t.force_y_mss, t.force_z_mss, t.north_m, t.east_m,
                  -t.height_m, t.roll_rad, t.pitch_rad, t.yaw_rad, t.velocity_north_mps,
                  t.velocity_east_mps, t.velocity_down_mps, t.wind_north_mps, t.wind_east_mps,
                  t.wind_down_mps, t.battery_v, t.motor_current_a);
    return text;
}

}  // namespace

int main(int count, char** words) {
    const auto port = static_cast<uint16_t>(count > 1 ? std::atoi(words[1]) : 9002);
    const std::string last_word = count > 4 ? words[3] : "";
    const auto last_frame = static_cast<uint32_t>(count > 4 ? std::atoi(words[4]) : -1);
    const int socket_ = listenOn(port);
    if (socket_ < 0) {
        std::fprintf(stderr, "example_peer: UDP port %u is taken\n", port);
        return 1;
    }
    simulator::WorldOptions options;
    options.heading_deg = 340;  // the runway of first_flight.waypoints
    const auto parameters = simulator::loadAirplane(count > 2 ? words[2] : "foam_trainer");
    Airplane airplane(parameters, options, 0);
    std::puts("ready");
    std::fflush(stdout);
    double owed_s = 0;
    for (pollfd ready = {socket_, POLLIN, 0}; poll(&ready, 1, kPatience_ms) > 0;) {
        Packet packet;
        sockaddr_in from{};
        socklen_t size = sizeof from;
        const ssize_t got =
            recvfrom(socket_, &packet, sizeof packet, 0, reinterpret_cast<sockaddr*>(&from), &size);
        if (got != sizeof packet || packet.magic != 18458 || packet.rate_hz == 0) {
            std::fprintf(stderr, "example_peer: that is no servo packet\n");
            return 1;
        }
        if (airplane.truth().time_us > kThrown_us) airplane.launch();  // one without wheels
        for (owed_s += 1.0 / packet.rate_hz; owed_s > Airplane::kStep_s / 2;
             owed_s -= Airplane::kStep_s)
            airplane.step(controlsOf(packet, parameters.elevons));
        std::string answer = stateOf(airplane.truth());
        if (packet.count > last_frame) answer = last_word == "-" ? "" : last_word;
        if (!answer.empty())
            sendto(socket_, answer.data(), answer.size(), 0, reinterpret_cast<sockaddr*>(&from),
                   size);
    }
    close(socket_);
}

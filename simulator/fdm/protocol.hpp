// SPDX-License-Identifier: GPL-3.0-or-later
// ArduPilot's JSON SITL protocol, the autopilot's side of it
// (ardupilot.org/dev/docs/sitl-with-JSON.html): servo pulses out in a packet of 40 bytes, the
// state of the airplane in as one line of JSON. Fields not named here are left unread.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "simulator/airplane/vector.hpp"

namespace simulator {

constexpr int kPacketPulses = 16;

// uint16 18458, uint16 rate in Hz, uint32 count, uint16[16] pulses in us; little-endian.
std::vector<uint8_t> servoPacket(uint16_t rate_hz, uint32_t count,
                                 const std::array<uint16_t, kPacketPulses>& pulses_us);

struct ModelState {
    double timestamp_s = 0;
    Vec3 rates_rads, force_mss;     // body; the specific force, at rest (0, 0, -9.81)
    Vec3 position_m, velocity_mps;  // north, east, down of the start
    Quaternion attitude;            // "quaternion", else from "attitude"
    std::optional<double> airspeed_mps;
    Vec3 wind_mps;  // "velocity_wind": of the air, north, east, down
    struct Battery {
        double voltage_v, current_a;
    };
    std::optional<Battery> battery;
    // "rc": channels 1 to 8 in us, of which those that are not sent stay 0.
    std::optional<std::array<uint16_t, 8>> radio_us;
};

class ModelStateError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Of the last line of a datagram. Throws ModelStateError with one line.
ModelState readModelState(const std::string& datagram);

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/flightgear.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>

namespace simulator::live {
namespace {

constexpr double kFeet = 1 / 0.3048, kKnots = 3600 / 1852.0, kRadians = M_PI / 180;

class Packet {
public:
    void word(uint32_t value) { put(value, 4); }
    void real(double value) {
        const auto narrow = static_cast<float>(value);
        uint32_t bits;
        std::memcpy(&bits, &narrow, sizeof bits);
        put(bits, sizeof bits);
    }
    void wide(double value) {
        uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        put(bits, sizeof bits);
    }
    void nothing(int words) {
        for (int i = 0; i < words; ++i) word(0);
    }
    std::vector<uint8_t> bytes;

private:
    void put(uint64_t bits, int size) {
        for (int i = size - 1; i >= 0; --i) bytes.push_back(static_cast<uint8_t>(bits >> (8 * i)));
    }
};

void putPlace(Packet& packet, const Truth& t) {
    packet.wide(t.longitude_deg * kRadians);
    packet.wide(t.latitude_deg * kRadians);
    packet.wide(t.altitude_m);
    for (const double value :
         {t.height_m, t.roll_rad, t.pitch_rad, t.yaw_rad, t.alpha_rad, t.beta_rad})
        packet.real(value);
}

// Rates of the angles, not about the body's axes.
void putRates(Packet& packet, const Truth& t) {
    const double sine = std::sin(t.roll_rad), cosine = std::cos(t.roll_rad);
    const double level = std::max(std::cos(t.pitch_rad), 1e-3);
    const double turn = (t.pitch_rate_rads * sine + t.yaw_rate_rads * cosine) / level;
    packet.real(t.roll_rate_rads + turn * std::sin(t.pitch_rad));
    packet.real(t.pitch_rate_rads * cosine - t.yaw_rate_rads * sine);
    packet.real(turn);
}

void putVelocities(Packet& packet, const Truth& t) {
    const double through = t.airspeed_mps * kFeet;
    packet.real(t.equivalent_airspeed_mps * kKnots);
    packet.real(-t.velocity_down_mps * kFeet);
    packet.real(t.velocity_north_mps * kFeet);
    packet.real(t.velocity_east_mps * kFeet);
    packet.real(t.velocity_down_mps * kFeet);
    packet.real(through * std::cos(t.alpha_rad) * std::cos(t.beta_rad));
    packet.real(through * std::sin(t.beta_rad));
    packet.real(through * std::sin(t.alpha_rad) * std::cos(t.beta_rad));
    packet.real(t.force_x_mss * kFeet);
    packet.real(t.force_y_mss * kFeet);
    packet.real(t.force_z_mss * kFeet);
}

// One engine that runs or does not, no tanks, three wheels.
void putParts(Packet& packet, const Truth& t) {
    constexpr int kEngines = 4, kTanks = 4, kWheels = 3, kEngineReadings = 9;
    constexpr uint32_t kRunning = 2;
    constexpr double kFull_rpm = 9000;  // what is heard of it; the model does not publish its speed
    packet.real(0);                     // stall warning
    packet.real(t.beta_rad / kRadians);
    packet.word(1);
    packet.word(t.throttle > 0 ? kRunning : 0);
    packet.nothing(kEngines - 1);
    packet.real(t.throttle * kFull_rpm);
    packet.nothing(kEngines - 1 + (kEngineReadings - 1) * kEngines);
    packet.word(0);
    packet.nothing(kTanks);
    packet.word(kWheels);
    for (int i = 0; i < kWheels; ++i) packet.word(t.on_ground ? 1 : 0);
    for (int i = 0; i < kWheels; ++i) packet.real(1);  // all are down
    packet.nothing(2 * kWheels);                       // steering, compression
}

// A trailing edge that goes up is positive of the right aileron alone.
void putSurfaces(Packet& packet, const Truth& t) {
    packet.real(-t.elevator);
    packet.nothing(3);  // trim tab, flaps
    packet.real(t.aileron);
    packet.real(-t.aileron);
    packet.real(t.rudder);
    packet.real(t.rudder);  // the nose wheel goes with it
    packet.nothing(2);      // speed brake, spoilers
}

}  // namespace

std::vector<uint8_t> nativeFdm(const Truth& truth, uint32_t unix_time_s) {
    constexpr double kVisibility_m = 20'000;
    Packet packet;
    packet.word(kNativeFdmVersion);
    packet.nothing(1);
    putPlace(packet, truth);
    putRates(packet, truth);
    putVelocities(packet, truth);
    putParts(packet, truth);
    packet.word(unix_time_s);
    packet.nothing(1);  // warp
    packet.real(kVisibility_m);
    putSurfaces(packet, truth);
    return packet.bytes;
}

std::optional<FlightGearAddress> flightGearAddress(const std::string& text) {
    const size_t colon = text.rfind(':');
    if (colon == text.npos || colon == 0) return std::nullopt;
    const std::string digits = text.substr(colon + 1);
    const bool number = !digits.empty() && digits.size() <= 5 &&
                        digits.find_first_not_of("0123456789") == digits.npos;
    const int port = number ? std::stoi(digits) : 0;
    if (port < 1 || port > 65535) return std::nullopt;
    return FlightGearAddress{text.substr(0, colon), static_cast<uint16_t>(port)};
}

FlightGear::FlightGear(const FlightGearAddress& address)
    : peer_(address.host, address.port, 0), start_s_(std::time(nullptr)) {}

void FlightGear::step(const Truth& truth, uint64_t now_us) {
    if (now_us < due_us_) return;
    due_us_ = now_us / kEvery_us * kEvery_us + kEvery_us;
    peer_.send(nativeFdm(
        truth, static_cast<uint32_t>(start_s_ + static_cast<int64_t>(now_us / 1'000'000))));
}

}  // namespace simulator::live

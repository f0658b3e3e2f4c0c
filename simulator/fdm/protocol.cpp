// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fdm/protocol.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace simulator {
namespace {

using Json = nlohmann::json;
constexpr uint16_t kMagic = 18458;
constexpr size_t kShown = 60;
constexpr double kMax = 1e7;              // m, m/s, m/s2, rad/s: beyond it a model has come apart
constexpr double kMaxTimestamp_s = 1e10;  // microseconds can still be seen in it
constexpr double kMaxSpeed_mps = 1000, kMaxBattery_v = 100, kMaxBattery_a = 1000;

// One line of letters that a terminal shows.
std::string excerpt(const std::string& text) {
    std::string shown;
    for (const char letter : text.substr(0, kShown))
        shown += letter >= 32 && letter < 127 ? letter : '?';
    return "'" + shown + (text.size() > kShown ? "...'" : "'");
}

const Json& fieldOf(const Json& object, const std::string& path) {
    const Json::json_pointer at(path);
    if (!object.contains(at)) throw ModelStateError("expected the field " + path.substr(1));
    return object.at(at);
}

double numberOf(const Json& value, const std::string& path) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
        throw ModelStateError(path.substr(1) + ": expected a number, found " +
                              excerpt(value.dump()));
    return value.get<double>();
}

double numberWithin(const Json& object, const std::string& path, double least, double most) {
    const double value = numberOf(fieldOf(object, path), path);
    if (value < least || value > most)
        throw ModelStateError(path.substr(1) + ": expected " + Json(least).dump() + " to " +
                              Json(most).dump() + ", found " + Json(value).dump());
    return value;
}

template <size_t size>
std::array<double, size> numbersOf(const Json& object, const std::string& path) {
    const Json& value = fieldOf(object, path);
    if (!value.is_array() || value.size() != size)
        throw ModelStateError(path.substr(1) + ": expected " + std::to_string(size) +
                              " numbers, found " + excerpt(value.dump()));
    std::array<double, size> numbers;
    for (size_t i = 0; i < size; ++i) {
        numbers[i] = numberOf(value[i], path);
        if (std::abs(numbers[i]) > kMax)
            throw ModelStateError(path.substr(1) + ": expected what an airplane can do, found " +
                                  excerpt(value.dump()));
    }
    return numbers;
}

Vec3 vectorOf(const Json& object, const std::string& path) {
    const auto numbers = numbersOf<3>(object, path);
    return {numbers[0], numbers[1], numbers[2]};
}

Quaternion attitudeOf(const Json& object) {
    if (!object.contains("quaternion")) {
        if (!object.contains("attitude"))
            throw ModelStateError("expected the field attitude or quaternion");
        const Vec3 angles = vectorOf(object, "/attitude");
        return quaternion(angles.x, angles.y, angles.z);
    }
    const auto q = numbersOf<4>(object, "/quaternion");
    if (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] < 1e-6)
        throw ModelStateError("quaternion: expected an attitude, found one of length 0");
    return normalized({q[0], q[1], q[2], q[3]});
}

void readRadio(const Json& object, ModelState& state) {
    if (!object.contains("rc")) return;
    state.radio_us.emplace();
    for (size_t i = 0; i < state.radio_us->size(); ++i) {
        const std::string path = "/rc/rc_" + std::to_string(i + 1);
        if (!object.contains(Json::json_pointer(path))) continue;
        (*state.radio_us)[i] = static_cast<uint16_t>(numberWithin(object, path, 800, 2200));
    }
}

std::string lastLine(const std::string& datagram) {
    const size_t end = datagram.find_last_not_of(" \t\r\n") + 1;
    const size_t begin = end == 0 ? std::string::npos : datagram.find_last_of('\n', end - 1);
    return datagram.substr(begin == std::string::npos ? 0 : begin + 1,
                           end - (begin == std::string::npos ? 0 : begin + 1));
}

}  // namespace

std::vector<uint8_t> servoPacket(uint16_t rate_hz, uint32_t count,
                                 const std::array<uint16_t, kPacketPulses>& pulses_us) {
    std::vector<uint8_t> packet;
    const auto put = [&packet](uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) packet.push_back(static_cast<uint8_t>(value >> (8 * i)));
    };
    put(kMagic, 2);
    put(rate_hz, 2);
    put(count, 4);
    for (const uint16_t pulse_us : pulses_us) put(pulse_us, 2);
    return packet;
}

ModelState readModelState(const std::string& datagram) {
    const std::string line = lastLine(datagram);
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object()) throw ModelStateError("expected a JSON object, found " + excerpt(line));
    ModelState state;
    state.timestamp_s = numberWithin(json, "/timestamp", -kMaxTimestamp_s, kMaxTimestamp_s);
    state.rates_rads = vectorOf(json, "/imu/gyro");
    state.force_mss = vectorOf(json, "/imu/accel_body");
    state.position_m = vectorOf(json, "/position");
    state.velocity_mps = vectorOf(json, "/velocity");
    state.attitude = attitudeOf(json);
    if (json.contains("airspeed"))
        state.airspeed_mps = numberWithin(json, "/airspeed", -kMaxSpeed_mps, kMaxSpeed_mps);
    if (json.contains("velocity_wind")) state.wind_mps = vectorOf(json, "/velocity_wind");
    if (json.contains("battery"))
        state.battery = {numberWithin(json, "/battery/voltage", 0, kMaxBattery_v),
                         numberWithin(json, "/battery/current", -kMaxBattery_a, kMaxBattery_a)};
    readRadio(json, state);
    return state;
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/faults.hpp"

#include <cstdlib>

namespace simulator {
namespace {

constexpr const char* kSensors[kFaulty] = {"imu", "baro", "airspeed", "compass", "gps", "radio"};
constexpr const char* kKinds[kFaultKinds] = {"none",       "lost",    "stuck", "noisy",
                                             "nonsense",   "jump",    "drift", "dead_roll",
                                             "dead_pitch", "dead_yaw"};

template <size_t N>
std::optional<int> find(const char* const (&names)[N], const std::string& name) {
    for (size_t i = 0; i < N; ++i)
        if (name == names[i]) return static_cast<int>(i);
    return std::nullopt;
}

std::optional<double> seconds(const std::string& text) {
    char* rest = nullptr;
    const double value = std::strtod(text.c_str(), &rest);
    if (text.empty() || *rest != 0 || !(value >= 0 && value < 1e9)) return std::nullopt;
    return value;
}

}  // namespace

const char* nameOf(Faulty sensor) { return kSensors[static_cast<int>(sensor)]; }
const char* nameOf(FaultKind kind) { return kKinds[static_cast<int>(kind)]; }

std::optional<Fault> parseFault(const std::string& text) {
    const size_t colon = text.find(':'), at = text.find('@');
    if (colon == text.npos || at == text.npos || at < colon) return std::nullopt;
    const size_t dash = text.find('-', at);
    const auto sensor = find(kSensors, text.substr(0, colon));
    const auto kind = find(kKinds, text.substr(colon + 1, at - colon - 1));
    const size_t from_size = dash == text.npos ? text.npos : dash - at - 1;
    const auto from_s = seconds(text.substr(at + 1, from_size));
    const auto to_s = dash == text.npos ? 1e9 : seconds(text.substr(dash + 1));
    if (!sensor || !kind || *kind == 0 || !from_s || !to_s || *to_s <= *from_s) return std::nullopt;
    const Fault fault = {static_cast<Faulty>(*sensor), static_cast<FaultKind>(*kind), *from_s,
                         *to_s};
    if (!canFail(fault.sensor, fault.kind)) return std::nullopt;
    return fault;
}

// A receiver of the radio says nothing of what it hears, it is there or not.
bool canFail(Faulty sensor, FaultKind kind) {
    if (deadGyro(kind) >= 0) return sensor == Faulty::imu;
    if (sensor == Faulty::gps) return kind != FaultKind::drift;
    return sensor != Faulty::radio || kind == FaultKind::lost;
}

int deadGyro(FaultKind kind) {
    const int axis = static_cast<int>(kind) - static_cast<int>(FaultKind::dead_roll);
    return axis >= 0 && axis < 3 ? axis : -1;
}

double FaultyValue::of(double good, const FaultShape& shape, Random& random) {
    switch (kind_) {
        case FaultKind::stuck:
            if (!held_) held_ = good;
            return *held_;
        case FaultKind::noisy:
            return good + shape.noise * random.normal();
        case FaultKind::nonsense:
            return shape.lowest + (shape.highest - shape.lowest) * random.uniform();
        case FaultKind::jump:
            return good + shape.jump;
        case FaultKind::drift:
            return good + shape.drift * for_s_;
        default:
            return good;
    }
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/faults.hpp"

#include <cstdio>
#include <cstdlib>

#include "simulator/devices/supply.hpp"

namespace simulator {
namespace {

constexpr const char* kSensors[kFaulty] = {"imu",   "baro",   "airspeed", "compass", "gps",
                                           "radio", "supply", "i2c",      "spi"};
// clang-format off
constexpr const char* kKinds[kFaultKinds] = {
    "none", "lost", "stuck", "noisy", "nonsense", "jump", "drift",
    "dead_roll", "dead_pitch", "dead_yaw",
    "cut", "sag",
    "silent", "held", "throttle_lost", "missed_edge", "extra_edge", "nine_channels", "wide",
    "scl_low", "sda_low", "miso_low", "miso_high",
};
// clang-format on

// The kinds from one to another, as bits.
constexpr uint32_t kinds(FaultKind from, FaultKind to) {
    return (2u << static_cast<int>(to)) - (1u << static_cast<int>(from));
}
constexpr uint32_t only(FaultKind kind) { return kinds(kind, kind); }

constexpr uint32_t kOfSensor = kinds(FaultKind::lost, FaultKind::drift);
constexpr uint32_t kMay[kFaulty] = {
    kinds(FaultKind::lost, FaultKind::dead_yaw),                                // imu
    kOfSensor,                                                                  // baro
    kOfSensor,                                                                  // airspeed
    kOfSensor,                                                                  // compass
    kinds(FaultKind::lost, FaultKind::jump),                                    // gps
    only(FaultKind::lost) | kinds(FaultKind::silent, FaultKind::wide),          // radio
    kinds(FaultKind::cut, FaultKind::sag),                                      // supply
    only(FaultKind::noisy) | kinds(FaultKind::scl_low, FaultKind::sda_low),     // i2c
    only(FaultKind::noisy) | kinds(FaultKind::miso_low, FaultKind::miso_high),  // spi
};

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

// Capacitors of some 200 uF that feed 200 mA.
constexpr double kFall_ms_per_v = 1;

// cut, sag_3.2v or sag_3.2v_20ms
bool parseShape(const std::string& text, Fault& fault) {
    int end = 0;
    const char* const words = text.c_str();
    if (text == "cut") {
        fault.kind = FaultKind::cut;
    } else if (std::sscanf(words, "sag_%lfv%n", &fault.volts, &end) == 1 && end > 0) {
        fault.kind = FaultKind::sag;
    } else {
        return false;
    }
    if (!(fault.volts >= 0 && fault.volts < Supply::kNominal_v)) return false;
    fault.fall_ms = (Supply::kNominal_v - fault.volts) * kFall_ms_per_v;
    if (fault.kind == FaultKind::cut || words[end] == 0) return true;
    int rest = 0;
    return std::sscanf(words + end, "_%lfms%n", &fault.fall_ms, &rest) == 1 && rest > 0 &&
           words[end + rest] == 0 && fault.fall_ms >= 0 && fault.fall_ms <= 1e6;
}

bool parseKind(const std::string& text, Fault& fault) {
    if (fault.sensor == Faulty::supply) return parseShape(text, fault);
    const auto kind = find(kKinds, text);
    if (!kind || *kind == 0) return false;
    fault.kind = static_cast<FaultKind>(*kind);
    return canFail(fault.sensor, fault.kind);
}

}  // namespace

const char* nameOf(Faulty sensor) { return kSensors[static_cast<int>(sensor)]; }
const char* nameOf(FaultKind kind) { return kKinds[static_cast<int>(kind)]; }

std::optional<Fault> parseFault(const std::string& text) {
    const size_t colon = text.find(':'), at = text.find('@');
    if (colon == text.npos || at == text.npos || at < colon) return std::nullopt;
    const size_t dash = text.find('-', at);
    const auto sensor = find(kSensors, text.substr(0, colon));
    const size_t from_size = dash == text.npos ? text.npos : dash - at - 1;
    const auto from_s = seconds(text.substr(at + 1, from_size));
    const auto to_s = dash == text.npos ? 1e9 : seconds(text.substr(dash + 1));
    if (!sensor || !from_s || !to_s || *to_s <= *from_s) return std::nullopt;
    Fault fault = {static_cast<Faulty>(*sensor), FaultKind::none, *from_s, *to_s};
    if (!parseKind(text.substr(colon + 1, at - colon - 1), fault)) return std::nullopt;
    return fault;
}

std::string faultName(const Fault& fault) {
    const std::string name = nameOf(fault.sensor) + std::string(":") + nameOf(fault.kind);
    if (fault.kind != FaultKind::sag) return name;
    char depth[16];
    std::snprintf(depth, sizeof depth, "_%gv", fault.volts);
    return name + depth;
}

bool canFail(Faulty sensor, FaultKind kind) {
    return kMay[static_cast<int>(sensor)] >> static_cast<int>(kind) & 1;
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

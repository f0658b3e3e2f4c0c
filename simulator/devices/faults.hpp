// SPDX-License-Identifier: GPL-3.0-or-later
// Sensors that fail in flight: which, how, from when to when. Written SENSOR:HOW@FROM[-TO] in
// seconds since power-on, as in gps:lost@60-90 or compass:stuck@100.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "simulator/devices/random.hpp"

namespace simulator {

// jump: away from the truth by a constant, and believable in itself.
enum class FaultKind { none, lost, stuck, noisy, nonsense, jump };
enum class Faulty { imu, barometer, airspeed, compass, gps, radio };
constexpr int kFaulty = 6, kFaultKinds = 6;

const char* nameOf(Faulty sensor);
const char* nameOf(FaultKind kind);

struct Fault {
    Faulty sensor;
    FaultKind kind;
    double from_s = 0, to_s = 1e9;
};
std::optional<Fault> parseFault(const std::string& text);

// What becomes of a quantity: noise and range are the failing sensor's, jump is what it is off by.
struct FaultShape {
    double noise, lowest, highest, jump;
};
constexpr FaultShape kBarometerFaults = {300, 60'000, 110'000, 1200};  // Pa
class FaultyValue {
public:
    void fail(FaultKind kind) {
        if (kind != kind_) held_.reset();
        kind_ = kind;
    }
    FaultKind kind() const { return kind_; }
    bool lost() const { return kind_ == FaultKind::lost; }
    // No random number is drawn in health: the flight until then stays the same.
    double of(double good, const FaultShape& shape, Random& random);

private:
    FaultKind kind_ = FaultKind::none;
    std::optional<double> held_;
};

}  // namespace simulator

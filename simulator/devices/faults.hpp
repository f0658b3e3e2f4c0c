// SPDX-License-Identifier: GPL-3.0-or-later
// What fails in flight: which part, how, from when to when. Written PART:HOW@FROM[-TO] in seconds
// since power-on, as in gps:lost@60-90, compass:stuck@100 or supply:sag_3.2v@60-60.012.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "simulator/devices/random.hpp"

namespace simulator {

// jump: away from the truth by a constant, with plausible values; drift: ever farther from it;
// dead: one gyro alone says the same for ever; cut and sag: the supply falls to nothing, or to so
// many volts; from silent to wide they are the radio's, see simulator/devices/ppm_encoder.hpp; the
// last ones are lines of the buses that stay where they are.
enum class FaultKind {
    none,
    lost,
    stuck,
    noisy,
    nonsense,
    jump,
    drift,
    dead_roll,
    dead_pitch,
    dead_yaw,
    cut,
    sag,
    silent,
    held,
    throttle_lost,
    missed_edge,
    extra_edge,
    nine_channels,
    wide,
    scl_low,
    sda_low,
    miso_low,
    miso_high
};
enum class Faulty { imu, barometer, airspeed, compass, gps, radio, supply, i2c, spi };
constexpr int kFaulty = 9, kFaultKinds = 23;

const char* nameOf(Faulty sensor);
const char* nameOf(FaultKind kind);

struct Fault {
    Faulty sensor;
    FaultKind kind;
    double from_s = 0, to_s = 1e9;
    double volts = 0;    // of the supply: how low it falls
    double fall_ms = 0;  // and how fast
};
// The supply's is cut or sag_Vv, which fall by 1 V in a millisecond, or sag_Vv_Nms, which takes
// that long to fall.
std::optional<Fault> parseFault(const std::string& text);

std::string faultName(const Fault& fault);  // PART:HOW, of a sag with its depth

bool canFail(Faulty sensor, FaultKind kind);
// The gyro that is dead, about x, y or z; -1: none.
int deadGyro(FaultKind kind);

// What becomes of a quantity: noise and range are the failing sensor's, jump is what it is off by,
// drift what it goes off by in a second.
struct FaultShape {
    double noise, lowest, highest, jump, drift;
};
constexpr FaultShape kBarometerFaults = {300, 60'000, 110'000, 1200, 12};  // Pa
class FaultyValue {
public:
    void fail(FaultKind kind, double for_s = 0) {
        if (kind != kind_) held_.reset();
        kind_ = kind;
        for_s_ = for_s;
    }
    double failing_s() const { return for_s_; }
    FaultKind kind() const { return kind_; }
    bool lost() const { return kind_ == FaultKind::lost; }
    // No random number is drawn in health: the flight until then stays the same.
    double of(double good, const FaultShape& shape, Random& random);

private:
    FaultKind kind_ = FaultKind::none;
    double for_s_ = 0;
    std::optional<double> held_;
};

}  // namespace simulator

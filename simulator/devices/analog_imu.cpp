// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/analog_imu.hpp"

#include <cmath>

#include "simulator/constants.hpp"
#include "simulator/world.hpp"

namespace simulator {
namespace {

constexpr double kStep_v = 3.3 / 4096;
// Data sheets: 2 mV per deg/s about 1.35 V, 330 mV/g about half of 3.3 V; as the board's makers
// found them on theirs: 1658 steps, 0.40 and 0.41 deg/s a step, 2041 steps, 424 a g.
constexpr double kRateZero_v = 1658 * kStep_v, kForceZero_v = 2041 * kStep_v;
constexpr double kRollPerDps_v = kStep_v / 0.40, kOtherPerDps_v = kStep_v / 0.41;
constexpr double kPerG_v = 424 * kStep_v;
constexpr double kTemperature_v = 1.25;

}  // namespace

AnalogImu::AnalogImu(uint64_t seed, const SensorErrors& errors)
    : errors_(errors), random_(seed, 7) {
    for (size_t i = 0; i < bias_.size(); ++i)
        bias_[i] = (i < 4 ? errors_.gyro_bias_dps : errors_.accel_bias_g) * random_.normal();
    Random of_scale(seed, 12);
    for (double& scale : scale_) scale = 1 + errors_.accel_scale * of_scale.normal();
}

// How they lie on the shield: only the roll rate and the forward axis have the airplane's sign.
double AnalogImu::good_v(int input, const Truth& t) {
    switch (input) {
        case 0:
            return rate_v(input, -t.yaw_rate_rads, t.throttle);
        case 1:
            return rate_v(input, t.roll_rate_rads, t.throttle);
        case 2:
            return rate_v(input, -t.pitch_rate_rads, t.throttle);
        case 4:
            return force_v(input, t.force_x_mss, t.throttle);
        case 5:
            return force_v(input, -t.force_y_mss, t.throttle);
        case 6:
            return force_v(input, -t.force_z_mss, t.throttle);
        default:
            return kTemperature_v;
    }
}

void AnalogImu::fail(FaultKind kind, double for_s) {
    constexpr int kGyros[] = {1, 2, 0};  // inputs of roll, pitch, yaw
    const int dead = deadGyro(kind);
    for (int input = 0; input < static_cast<int>(faults_.size()); ++input) {
        FaultKind here = kind;
        if (dead >= 0) here = kGyros[dead] == input ? FaultKind::stuck : FaultKind::none;
        if (kind == FaultKind::drift && input >= 3) here = FaultKind::none;
        faults_[static_cast<size_t>(input)].fail(here, for_s);
    }
}

double AnalogImu::volts(int input, const Truth& truth) {
    FaultyValue& fault = faults_[static_cast<size_t>(input)];
    return fault.lost()
               ? 0
               : fault.of(good_v(input, truth), {0.5, 0.1, 3.2, 0, 0.1 * kOtherPerDps_v}, random_);
}

double AnalogImu::rate_v(int input, double rate_rads, double throttle) {
    const double noise_dps =
        std::hypot(errors_.gyro_noise_dps, errors_.gyro_vibration_dps * throttle);
    const double rate_dps =
        rate_rads * kDegrees + bias_[static_cast<size_t>(input)] + noise_dps * random_.normal();
    return kRateZero_v + rate_dps * (input == 1 ? kRollPerDps_v : kOtherPerDps_v);
}

double AnalogImu::force_v(int input, double force_mss, double throttle) {
    const double noise_g = std::hypot(errors_.accel_noise_g, errors_.accel_vibration_g * throttle);
    const auto i = static_cast<size_t>(input);
    const double force_g =
        force_mss / kGravity_mss * scale_[i] + bias_[i] + noise_g * random_.normal();
    return kForceZero_v + force_g * kPerG_v;
}

}  // namespace simulator

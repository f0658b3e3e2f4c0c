// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/analog_sensors.hpp"

#include <algorithm>
#include <cmath>

#include "simulator/constants.hpp"
#include "simulator/world.hpp"

namespace simulator {
namespace {

constexpr double kZero_v = 2.5, kVoltsPerPascal = 1e-3;  // MPXV7002DP at 5 V
constexpr double kDivider = 10.1, kAmperesPerVolt = 17.0;

}  // namespace

AnalogSensors::AnalogSensors(uint64_t seed, const SensorErrors& errors)
    : errors_(errors),
      random_(seed, 4),
      ratio_(1 + errors.airspeed_ratio * random_.normal()),
      zero_v_(kZero_v + errors.airspeed_offset_v * random_.normal()) {}

double AnalogSensors::volts(int pin, const Truth& truth) {
    double value_v = 0;
    if (pin == kAirspeedPin) value_v = airspeed_v(truth);
    if (pin == kCurrentPin) value_v = truth.motor_current_a / kAmperesPerVolt;
    if (pin == kVoltagePin) value_v = truth.battery_v / kDivider;
    return std::clamp(value_v, 0.0, kSupply_v);
}

// A pitot tube does not mind small angles; with the air from behind it sees nothing.
double AnalogSensors::airspeed_v(const Truth& truth) {
    const double ahead = std::max(0.0, std::cos(truth.alpha_rad) * std::cos(truth.beta_rad));
    const double seen = std::min(1.0, 1.2 * ahead);
    if (fault_.lost()) return 0;
    if (fault_.kind() == FaultKind::jump)
        return zero_v_ + errors_.airspeed_noise_v * random_.normal();
    // the tube clogs, or ice closes it
    constexpr double kClosed_s = 60;
    const bool clogs = fault_.kind() == FaultKind::drift;
    const double open = clogs ? std::max(0.0, 1 - fault_.failing_s() / kClosed_s) : 1;
    const double pressure_pa = open * 0.5 * kSeaLevelDensity_kgm3 * truth.equivalent_airspeed_mps *
                               truth.equivalent_airspeed_mps * seen;
    const double good_v = zero_v_ + pressure_pa * ratio_ * kVoltsPerPascal +
                          errors_.airspeed_noise_v * random_.normal();
    return fault_.of(good_v, {0.7, 0, kSupply_v, 0, 0}, random_);
}

}  // namespace simulator

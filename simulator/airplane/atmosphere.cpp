// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/atmosphere.hpp"

#include <cmath>

namespace simulator {

Atmosphere atmosphere(double altitude_m) {
    constexpr double kPressure_pa = 101325, kTemperature_k = 288.15, kLapse_km = 0.0065;
    constexpr double kGasConstant = 287.05287;
    const double temperature_k = kTemperature_k - kLapse_km * altitude_m;
    const double pressure_pa = kPressure_pa * std::pow(temperature_k / kTemperature_k,
                                                       kGravity_mss / (kLapse_km * kGasConstant));
    return {pressure_pa, temperature_k, pressure_pa / (kGasConstant * temperature_k)};
}

}  // namespace simulator

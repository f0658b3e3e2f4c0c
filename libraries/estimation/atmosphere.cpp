// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/atmosphere.hpp"

#include "core/maths.hpp"
#include "core/seldom.hpp"

namespace estimation {
namespace {

constexpr float kGasConstant = 287.053f;  // J / (kg K), dry air: US Standard Atmosphere 1976
constexpr float kZeroCelsius_k = 273.15f;
constexpr float kSeaDensity_kgm3 = 1.225f;
// The standard atmosphere's cooling with height; half of it is the mean air's.
constexpr float kHalfLapse_kpm = 0.00325f;

}  // namespace

float pressureHeight_m(float pressure_pa, float ground_pa, float ground_temperature_c) {
    const float sum_pa = ground_pa + pressure_pa;
    if (!(pressure_pa > 0) || !(ground_pa > 0)) return 0;
    const float ratio = (ground_pa - pressure_pa) / sum_pa;
    const float squared = ratio * ratio;
    // ln(ground / pressure) = 2 artanh(ratio)
    const float logarithm = 2.0f * ratio * (1.0f + squared * (1.0f / 3.0f + squared * 0.2f));
    const float warm_m =
        logarithm * (ground_temperature_c + kZeroCelsius_k) * (kGasConstant / core::kGravity_mss);
    return warm_m * (1.0f - logarithm * (kHalfLapse_kpm * kGasConstant / core::kGravity_mss));
}

SELDOM float trueSpeedRatio(float pressure_pa, float temperature_c) {
    const float pressure = core::limit(pressure_pa, 10000.0f, 120000.0f);
    return sqrtf(kSeaDensity_kgm3 * kGasConstant * (temperature_c + kZeroCelsius_k) / pressure);
}

}  // namespace estimation

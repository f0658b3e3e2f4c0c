// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/airspeed.hpp"

#include "core/maths.hpp"

namespace drivers {
namespace {

// Data sheet, figure 4: Vout = Vs (0.2 P[kPa] + 0.5).
constexpr float kPascalsPerSupply = 5000.0f;
constexpr float kPascalsPerUnit = 1000.0f / 819.0f;  // the unit that ratio is given for
constexpr float kCalibration_s = 1.0f;
constexpr float kFilter_s = 0.17f;
// Zero is at half the supply within 2.5 % of 4 V (data sheet), with the board's own share 0.3 V.
constexpr float kLeastZero = 0.44f, kMostZero = 0.56f;
constexpr float kLowRail = 0.02f, kHighRail = 0.98f;
constexpr float kLeast_pa = -39.0f;  // -8 m/s: the hoses are swapped or one is off

}  // namespace

void Airspeed::calibrate(float ratio_of_supply, float dt_s, const AirspeedSettings& settings) {
    if (settings.keep_offset) {
        offset_ = settings.offset_v / kSupply_v;
        calibrated_ = true;
        return;
    }
    if (ratio_of_supply < kLeastZero || ratio_of_supply > kMostZero) {  // nothing fitted, or wind
        means_ = 0;
        calibrating_s_ = 0;
        return;
    }
    if (means_ < 255) ++means_;
    offset_ += (ratio_of_supply - offset_) / means_;
    calibrating_s_ += dt_s;
    calibrated_ = calibrating_s_ >= kCalibration_s && means_ >= 10;
}

void Airspeed::judge(float raw_pa, float ratio_of_supply, float dt_s, bool either_tube) {
    const bool bad = ratio_of_supply < kLowRail || ratio_of_supply > kHighRail ||
                     (!either_tube && raw_pa < kLeast_pa);
    bad_s_ = core::limit(bad ? bad_s_ + dt_s : bad_s_ - dt_s, 0.0f, 2.0f);
}

void Airspeed::update(uint16_t sum, uint8_t count, float dt_s, const AirspeedSettings& settings) {
    if (count == 0) return;
    const float ratio_of_supply = sum / static_cast<float>(uint16_t{count} * 1024U);
    if (!calibrated_) return calibrate(ratio_of_supply, dt_s, settings);
    const float raw_pa = (ratio_of_supply - offset_) * kPascalsPerSupply;
    judge(raw_pa, ratio_of_supply, dt_s, settings.either_tube);
    // The pressure is filtered, not its root: noise about zero then gives no speed.
    pressure_pa_ += (raw_pa - pressure_pa_) * core::limit(dt_s * (1.0f / kFilter_s), 0.0f, 1.0f);
    const float head_pa = settings.either_tube ? fabsf(pressure_pa_) : pressure_pa_;
    const float squared = head_pa * settings.ratio * (1.0f / kPascalsPerUnit);
    speed_mps_ = squared > 0 ? sqrtf(squared) : 0;
}

}  // namespace drivers

// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/airspeed.hpp"

#include "core/maths.hpp"
#include "core/multiply.hpp"

namespace drivers {
namespace {

constexpr uint8_t kFraction = 29;
constexpr float kSteps = 1UL << kFraction;
constexpr float kSupply_v = 5.0f;
// Data sheets: Vout = Vs (0.2 P[kPa] + 0.5) of the MPXV7002DP, figure 4, and
// Vs (0.2 P[kPa] + 0.2) of the MPXV5004DP.
constexpr float kPascalsPerSupply = 5000.0f;
constexpr float kPascalsPerUnit = 1000.0f / 819.0f;  // the unit that ratio is given for
constexpr float kPascalsPerStep = kPascalsPerSupply / kSteps;
constexpr float kUnitsPerStep = kPascalsPerStep / kPascalsPerUnit;
constexpr uint32_t kFilter_us = 170000;
// Half the supply within 6.25 % of 4 V, and a fifth of it within 0.25 V (data sheets). The sensor's
// supply is not the measure on APM 1, whose converter has a reference of its own: 4.7 to 5.3 V.
constexpr float kLeastRail = 4.7f / kSupply_v, kMaxRail = 5.3f / kSupply_v;
constexpr uint16_t ofSupply(float share) { return static_cast<uint16_t>(65536 * share); }
constexpr uint16_t kLeastZero = ofSupply(0.45f * kLeastRail), kMaxZero = ofSupply(0.55f * kMaxRail);
constexpr uint16_t kLeastLowZero = ofSupply(0.15f * kLeastRail);
constexpr uint16_t kMaxLowZero = ofSupply(0.25f * kMaxRail);
constexpr uint16_t kLowRail = 1311, kHighRail = 64225;  // 0.02 and 0.98
constexpr int32_t kLeast =
    static_cast<int32_t>(-39.0f / kPascalsPerStep);  // -8 m/s: the hoses
                                                     // are swapped or one is off

bool canBeZero(uint16_t share) {
    return (share >= kLeastZero && share <= kMaxZero) ||
           (share >= kLeastLowZero && share <= kMaxLowZero);
}

int32_t inSteps(uint16_t share) { return int32_t{share} << (kFraction - 16); }

// Of a difference that is taken over in this time, in 2^-15.
int16_t taken(uint32_t dt_us) {
    constexpr uint16_t kPerMicrosecond =
        static_cast<uint16_t>(32768.0f * 65536 / kFilter_us + 0.5f);
    return dt_us < kFilter_us ? static_cast<int16_t>(dt_us * kPerMicrosecond >> 16) : INT16_MAX;
}

}  // namespace

void Airspeed::setZero(float offset_v) {
    zero_ = static_cast<int32_t>(offset_v * (kSteps / kSupply_v));
    calibrated_ = true;
}

void Airspeed::calibrate(uint16_t share, uint16_t passed, const AirspeedSettings& settings) {
    if (settings.offset_known) return setZero(settings.offset_v);
    if (!canBeZero(share)) {  // nothing fitted, or wind
        means_ = 0;
        calibrating_ = 0;
        return;
    }
    if (means_ < 255) ++means_;
    zero_ += (inSteps(share) - zero_) / means_;
    calibrating_ += passed;
    calibrated_ = calibrating_ >= kSecond && means_ >= 10;
}

void Airspeed::check(int32_t above, uint16_t share, uint16_t passed, bool either_tube) {
    const bool bad = share < kLowRail || share > kHighRail || (!either_tube && above < kLeast);
    if (bad)
        bad_ = core::limit<uint16_t>(bad_ + passed, 0, 2 * kSecond);
    else
        bad_ = bad_ > passed ? bad_ - passed : 0;
}

void Airspeed::update(uint16_t share, uint32_t dt_us, const AirspeedSettings& settings) {
    const uint16_t passed = dt_us < 2000000 ? static_cast<uint16_t>(dt_us >> 10) : 2 * kSecond;
    if (!calibrated_) return calibrate(share, passed, settings);
    const int32_t above = inSteps(share) - zero_;
    check(above, share, passed, settings.either_tube);
    // The pressure is filtered, not its root: noise about zero then gives no speed.
    above_ += core::times16(above - above_, taken(dt_us)) * 2;
    ratio_ = settings.ratio;
    either_tube_ = settings.either_tube;
}

float Airspeed::speed_mps() const {
    const int32_t head = either_tube_ && above_ < 0 ? -above_ : above_;
    return head > 0 ? sqrtf(static_cast<float>(head) * (ratio_ * kUnitsPerStep)) : 0;
}

float Airspeed::pressure_pa() const { return static_cast<float>(above_) * kPascalsPerStep; }
float Airspeed::offset_v() const { return static_cast<float>(zero_) * (kSupply_v / kSteps); }

}  // namespace drivers

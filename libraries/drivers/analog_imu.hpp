// SPDX-License-Identifier: GPL-3.0-or-later
// The first board's gyros (IDG-500, ISZ-500) and accelerometer (ADXL335), analogue, behind its
// ADS7844: handed out in the
// steps of the firmware's fixed point, those of an MPU-6000, and in the airplane's axes.
#pragma once
#include <stdint.h>

#include "core/fixed.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "drivers/ads7844.hpp"
#include "drivers/imu_sample.hpp"
#include "hal/analog.hpp"

namespace drivers {

template <class Converter>
class AnalogImu {
public:
    static constexpr uint16_t kSet_us = 1000;     // of the converter
    static constexpr uint16_t kPeriod_us = 5000;  // of a sample, as everywhere
    static constexpr uint8_t kSetsPerSample = kPeriod_us / kSet_us;
    static constexpr uint8_t kUsual = 2 * kSetsPerSample;  // readings of a frame

    static constexpr float kRange_g = 3.6f;  // of the accelerometers, as they usually have it

    void start() { Converter::start(); }
    void resume() {}
    // Its converter stops when nobody takes what it has.
    uint8_t peek(int16_t (&)[3]) const { return 0; }
    static core::Vector3 peeked(const int16_t (&)[3]) { return {0, 0, 0}; }
    // Every frame.
    void step(uint32_t now_ms);
    void onDataReady() {}  // these sensors have no such line

    // The mean since the last take; false when nothing came that can be trusted.
    bool take(ImuSums& to);
    uint8_t waiting() const {
        uint8_t sets = static_cast<uint8_t>(Converter::waiting() + rest_);
        return wholeSamples(sets);
    }

    bool healthy() const { return healthy_; }
    uint16_t badReads() const { return bad_reads_; }
    uint16_t restarts() const { return 0; }

    // The pitot sensor's share, as the 10-bit readings of a converter with 5 V of range.
    static hal::AnalogSum takeAirspeed() {
        const hal::AnalogSum taken = {static_cast<uint16_t>((airspeed_ * kTenBits + 0x8000) >> 16),
                                      airspeed_count_};
        airspeed_ = 0;
        airspeed_count_ = 0;
        return taken;
    }

private:
    struct Axis {
        uint8_t at;  // in rate and force
        uint16_t zero;
        int16_t factor;
    };
    // Twice the steps of kRateStep_rads or kForceStep_mss in one of the converter's, for the two
    // samples of a frame, by the usual readings, in 2^-14.
    static constexpr int16_t factor(float steps) {
        return static_cast<int16_t>(2 * 16384.0f / kUsual * steps + 0.5f);
    }
    static constexpr int16_t rateFactor(float step_dps) {
        return factor(step_dps * core::kPi / 180.0f / kRateStep_rads);
    }
    static constexpr int16_t kForceFactor = factor(core::kGravity_mss / 424.0f / kForceStep_mss);
    static const Axis kAxes[];
    // 3.3 V in 4096 steps seen as 5 V in 1024, in 1/65536
    static constexpr uint32_t kTenBits = 10813;
    static constexpr uint8_t kMaxReadings = 16;  // of 12 bits in 16
    // No sensor of these swings to within 50 mV of the supply.
    static constexpr uint16_t kLowest = 60, kHighest = 4035;

    // Asked after every interrupt: two rounds as a rule, where a division takes 200 cycles.
    static uint8_t wholeSamples(uint8_t& sets) {
        uint8_t samples = 0;
        for (; sets >= kSetsPerSample; sets -= kSetsPerSample) ++samples;
        return samples;
    }
    static int32_t steps(const Axis& axis, uint16_t sum, uint8_t count);
    static bool plausible(const Ads7844Sums& sums);
    static void storeAirspeed(const Ads7844Sums& sums);

    // One converter, one pitot sensor: asked by those who know no object of this.
    static uint16_t airspeed_;
    static uint8_t airspeed_count_;

    uint32_t good_ms_ = 0;
    uint16_t bad_reads_ = 0;
    uint8_t rest_ = 0;    // sets that are no whole sample yet
    uint8_t lost_ = 0;    // samples that were refused
    bool fresh_ = false;  // since the last step
    bool healthy_ = false;
};

// As the board's makers measured them: 0.4 and 0.41 deg/s a step (0.806 mV at 2 mV per deg/s); the
// means of the accelerometer's two extremes, 1617 and 2465.
// clang-format off
template <class Converter>
const typename AnalogImu<Converter>::Axis AnalogImu<Converter>::kAxes[] ROM = {
    {/* force_y */ 4, 2041, -kForceFactor},
    {/* rate_z  */ 2, 1658, -rateFactor(0.41f)},
    {/* rate_y  */ 1, 1658, -rateFactor(0.41f)},
    {/* force_x */ 3, 2041,  kForceFactor},
    {/* force_z */ 5, 2041, -kForceFactor},
    {/* rate_x  */ 0, 1658,  rateFactor(0.40f)},
};
// clang-format on

template <class Converter>
uint16_t AnalogImu<Converter>::airspeed_;
template <class Converter>
uint8_t AnalogImu<Converter>::airspeed_count_;

template <class Converter>
void AnalogImu<Converter>::step(uint32_t now_ms) {
    if (fresh_) {
        good_ms_ = now_ms;
        healthy_ = true;
    } else if (now_ms - good_ms_ > 50) {
        healthy_ = false;
    }
    fresh_ = false;
}

template <class Converter>
bool AnalogImu<Converter>::plausible(const Ads7844Sums& sums) {
    if (sums.invalid) return false;
    uint8_t count = kUsual;
    uint16_t lowest = kUsual * kLowest, highest = kUsual * kHighest;
    for (uint8_t channel = 0; channel < Ads7844Sums::airspeed; ++channel) {
        if (sums.count[channel] != count) {
            count = sums.count[channel];
            lowest = count * kLowest;
            highest = count * kHighest;
        }
        const uint16_t sum = sums.sum[channel];
        if (count == 0 || sum < lowest || sum > highest) return false;
    }
    return true;
}

template <class Converter>
void AnalogImu<Converter>::storeAirspeed(const Ads7844Sums& sums) {
    const uint8_t count = sums.count[Ads7844Sums::airspeed];
    if (airspeed_count_ + count > kMaxReadings) airspeed_ = airspeed_count_ = 0;
    airspeed_ += sums.sum[Ads7844Sums::airspeed];
    airspeed_count_ = static_cast<uint8_t>(airspeed_count_ + count);
}

// Nearly always a frame's readings have come, which takes no division, and 16 bits are enough; the
// upper half of a product costs nothing, a shift by 14 bits 100 cycles.
template <class Converter>
int32_t AnalogImu<Converter>::steps(const Axis& axis, uint16_t sum, uint8_t count) {
    const uint16_t zero = core::romRead(axis.zero);
    const int16_t factor = core::romRead(axis.factor);
    int32_t steps = 0;
    if (count == kUsual) {
        steps = int32_t{static_cast<int16_t>(sum - kUsual * zero)} * factor;
    } else {
        const int32_t above = int32_t{sum} - int32_t{zero} * count;
        steps = above * kUsual / count * factor;
    }
    steps += 1 << 13;
    const uint8_t below = static_cast<uint8_t>(steps >> 8);
    const uint8_t rest = static_cast<uint8_t>((below & 0x80 ? 2 : 0) + (below & 0x40 ? 1 : 0));
    return int32_t{static_cast<int16_t>(steps >> 16)} * 4 + rest;
}

template <class Converter>
bool AnalogImu<Converter>::take(ImuSums& to) {
    Ads7844Sums sums = {};
    const bool taken = Converter::take(sums);
    const uint16_t sets = rest_ + sums.periods;
    rest_ = sets > 255 ? 255 : static_cast<uint8_t>(sets);
    const uint16_t periods = lost_ + wholeSamples(rest_);
    lost_ = periods > 255 ? 255 : static_cast<uint8_t>(periods);
    if (!taken) return false;
    if (!plausible(sums)) {
        if (bad_reads_ != UINT16_MAX) ++bad_reads_;
        return false;
    }
    for (uint8_t i = 0; i < Ads7844Sums::airspeed; ++i) {
        const int32_t value = steps(kAxes[i], sums.sum[i], sums.count[i]);
        const uint8_t at = core::romRead(kAxes[i].at);
        (at < 3 ? to.rate[at] : to.force[at - 3]) = value;
    }
    to.count = 2;
    to.periods = lost_;
    lost_ = 0;
    fresh_ = true;
    storeAirspeed(sums);
    return true;
}

}  // namespace drivers

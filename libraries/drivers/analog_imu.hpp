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
    uint32_t samples() const { return samples_; }
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
        uint8_t channel;
        uint16_t zero;
        int16_t factor;
    };
    static constexpr uint8_t kSetsPerSample = kPeriod_us / kSet_us;
    // Twice the steps of kRateStep_rads or kForceStep_mss in one of the converter's, for the two
    // samples of a frame, in 1/128.
    static constexpr int16_t rateFactor(float step_dps) {
        return static_cast<int16_t>(256 * step_dps * core::kPi / 180.0f / kRateStep_rads + 0.5f);
    }
    static constexpr int16_t kForceFactor =
        static_cast<int16_t>(256 * core::kGravity_mss / 424.0f / kForceStep_mss + 0.5f);
    static const Axis kAxes[];
    // 3.3 V in 4096 steps seen as 5 V in 1024, in 1/65536
    static constexpr uint32_t kTenBits = 10813;
    static constexpr uint8_t kMostReadings = 16;  // of 12 bits in 16
    // No sensor of these swings to within 50 mV of the supply.
    static constexpr uint16_t kLowest = 60, kHighest = 4035;

    // Asked after every interrupt: two rounds as a rule, where a division takes 200 cycles.
    static uint8_t wholeSamples(uint8_t& sets) {
        uint8_t samples = 0;
        for (; sets >= kSetsPerSample; sets -= kSetsPerSample) ++samples;
        return samples;
    }
    static int16_t reciprocal(uint8_t count);
    static bool plausible(const Ads7844Sums& sums);
    static void keepAirspeed(const Ads7844Sums& sums);

    // One converter, one pitot sensor: asked by those who know no object of this.
    static uint16_t airspeed_;
    static uint8_t airspeed_count_;

    uint32_t samples_ = 0;
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
    {Ads7844Sums::rate_x,  1658,  rateFactor(0.40f)},
    {Ads7844Sums::rate_y,  1658, -rateFactor(0.41f)},
    {Ads7844Sums::rate_z,  1658, -rateFactor(0.41f)},
    {Ads7844Sums::force_x, 2041,  kForceFactor},
    {Ads7844Sums::force_y, 2041, -kForceFactor},
    {Ads7844Sums::force_z, 2041, -kForceFactor},
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
    if (sums.spoiled) return false;
    for (uint8_t i = 0; i < 6; ++i) {
        const uint8_t channel = core::romRead(kAxes[i].channel);
        const uint8_t count = sums.count[channel];
        const uint16_t sum = sums.sum[channel];
        if (count == 0 || sum < count * kLowest || sum > count * kHighest) return false;
    }
    return true;
}

template <class Converter>
void AnalogImu<Converter>::keepAirspeed(const Ads7844Sums& sums) {
    const uint8_t count = sums.count[Ads7844Sums::airspeed];
    if (airspeed_count_ + count > kMostReadings) airspeed_ = airspeed_count_ = 0;
    airspeed_ += sums.sum[Ads7844Sums::airspeed];
    airspeed_count_ = static_cast<uint8_t>(airspeed_count_ + count);
}

// 2^15 / count; nearly always a frame's sets have come, which takes no division.
template <class Converter>
int16_t AnalogImu<Converter>::reciprocal(uint8_t count) {
    constexpr uint8_t kUsual = 2 * kSetsPerSample;
    if (count == kUsual) return 0x8000 / kUsual;
    return count == 1 ? 0x7FFF : static_cast<int16_t>(0x8000U / count);
}

// Six divisions would take a quarter of a millisecond: the reciprocal is worked out once.
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
    uint8_t count = 0;
    int16_t part = 0;
    for (uint8_t i = 0; i < 6; ++i) {
        const Axis& axis = kAxes[i];
        const uint8_t channel = core::romRead(axis.channel);
        const uint8_t n = sums.count[channel];
        if (n != count) part = reciprocal(n);
        count = n;  // the same for all, or one more for some
        const int32_t above =
            static_cast<int32_t>(sums.sum[channel]) -
            static_cast<int32_t>(static_cast<uint32_t>(core::romRead(axis.zero)) * n);
        const int32_t steps = (core::times16(above * core::romRead(axis.factor), part) + 32) >> 6;
        (i < 3 ? to.rate[i] : to.force[i - 3]) = steps;
    }
    to.count = 2;
    to.periods = lost_;
    lost_ = 0;
    samples_ += count;
    fresh_ = true;
    keepAirspeed(sums);
    return true;
}

}  // namespace drivers

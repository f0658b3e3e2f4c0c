// SPDX-License-Identifier: GPL-3.0-or-later
// What the accelerometers have summed up to, now and over the last 0.6 s, so that a fix can be
// compared with its own time. Millimetres a second in 16 bits that wrap: only differences
// below 32 m/s mean anything.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"
#include "estimation/motion.hpp"

namespace estimation {

class VelocityHistory {
public:
    struct Moment {
        uint16_t north, east;  // mm/s, wrapping
    };
    static Moment moment(float north_mps, float east_mps);
    static core::Vector3 difference_mps(const Moment& later, const Moment& earlier);

    // For so many sample periods.
    void add(FineAcceleration north, FineAcceleration east, uint8_t periods);
    Moment now() const {
        return {static_cast<uint16_t>(north_ >> kFraction),
                static_cast<uint16_t>(east_ >> kFraction)};
    }
    Moment ago(float age_s) const;  // 0 .. kLongest_s, between two entries by their share

    static constexpr uint8_t kStepPeriods = 8;
    static constexpr float kStep_s = kStepPeriods * kSamplePeriod_s;
    static constexpr uint8_t kEntries = 16;
    static constexpr float kLongest_s = kStep_s * (kEntries - 1);

private:
    Moment entries_[kEntries] = {};
    static constexpr uint8_t kFraction = 16;
    uint32_t north_ = 0, east_ = 0;  // mm/s and this many bits more, wrapping where a Moment does
    uint8_t since_entry_ = 0;        // periods
    uint8_t newest_ = 0;
};

}  // namespace estimation

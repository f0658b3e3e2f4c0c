// SPDX-License-Identifier: GPL-3.0-or-later
// What the accelerometers have summed up to, now and over the last third of a second, so that a fix
// can be compared with its own time. Millimetres a second in 16 bits that wrap: only differences
// below 32 m/s mean anything.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace estimation {

class VelocityHistory {
public:
    struct Moment {
        uint16_t north, east;  // mm/s, wrapping
    };
    static Moment moment(float north_mps, float east_mps);
    static core::Vector3 difference_mps(const Moment& later, const Moment& earlier);

    void add(float north_mps, float east_mps, float dt_s);
    Moment now() const { return moment(north_mps_, east_mps_); }
    Moment ago(float age_s) const;  // 0 .. kLongest_s, between two entries by their share

    static constexpr float kStep_s = 0.04f;
    static constexpr uint8_t kEntries = 9;
    static constexpr float kLongest_s = kStep_s * (kEntries - 1);

private:
    Moment entries_[kEntries] = {};
    float north_mps_ = 0, east_mps_ = 0;
    float since_entry_s_ = 0;
    uint8_t newest_ = 0;
};

}  // namespace estimation

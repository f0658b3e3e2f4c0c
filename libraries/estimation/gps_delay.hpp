// SPDX-License-Identifier: GPL-3.0-or-later
// Learns in turns how much older or younger fixes are than their receiver is known for. Where the
// acceleration changes by a vector j each second, fixes that are D seconds late miss D times j of
// it. A heading that is wrong by an angle misses a part across the acceleration; in a steady turn
// both look alike, but for the side it turns to. So both are fitted together, by least squares with
// forgetting.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace estimation {

// The last three intervals between fixes, over ground.
class FixComparison {
public:
    struct Level {
        float north, east;
    };

    constexpr FixComparison() {}

    // With each fix: the acceleration since the one before it as the accelerometers measured it,
    // what that misses of the fixes', and one over the time between them.
    void add(const core::Vector3& missing_mss, const core::Vector3& mean_mss, float inverse_time);

    bool whole() const { return intervals_ == kIntervals; }
    // Of the second of the three intervals; while they are whole.
    const Level& missing_mss() const { return missing_mss_[0]; }
    const Level& mean_mss() const { return mean_mss_[1]; }
    Level change_msss() const;  // of the acceleration, from the first to the third

private:
    static constexpr uint8_t kIntervals = 3;

    Level missing_mss_[2] = {};  // of the second and the third
    Level mean_mss_[kIntervals] = {};
    float inverse_time_ = 0;
    uint8_t intervals_ = 0;
};

class GpsDelay {
public:
    // After each fix, where the comparison is whole; `used_s`: the correction the accelerometers
    // were compared with.
    void learn(const FixComparison& seen, float used_s);
    // To be added to the age of a fix, -kMaxYounger_s .. kMaxOlder_s; 0 where it is small enough to
    // be noise.
    float correction_s() const { return correction_s_; }

    static constexpr float kMaxYounger_s = 0.2f, kMaxOlder_s = 0.25f;

private:
    float fitted_s() const;

    float changes_ = 0, headings_ = 0, both_ = 0;  // products of the two causes
    float by_change_ = 0, by_heading_ = 0;         // and of each with what is missing
    float correction_s_ = 0;
    uint8_t learnt_ = 0;  // comparisons, wrapping
};

}  // namespace estimation

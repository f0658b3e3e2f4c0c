// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/gps_delay.hpp"

#include "core/maths.hpp"

namespace estimation {
namespace {

// As if turns had shown before, within 0.1 s, that there is no delay, and no error of the heading.
constexpr float kPrior = 250;
// So much has been seen after half a minute of steep turns; from then on the oldest fades.
constexpr float kMaxKnown = 1900;
constexpr float kFade = 0.97f;
constexpr uint8_t kLearntPerFit = 8;  // a comparison changes little
// A receiver's jump or a collision is no turn.
constexpr float kMaxMissing_mss = 8, kMaxChange_msss = 30;
constexpr float kMinChange_msss = 0.7f;  // a turn of 10 degrees a second at 15 m/s changes by 0.5
// With receivers whose delay was known exactly gusts and noise fitted up to 0.025 s. Less is
// ignored, twice as much is taken whole.
constexpr float kNoise_s = 0.028f;

using Level = FixComparison::Level;

constexpr float square(float a) { return a * a; }
float product(const Level& a, const Level& b) { return a.north * b.north + a.east * b.east; }

float withoutNoise(float fitted_s) {
    const float size_s = fabsf(fitted_s);
    const float share = core::limit((size_s - kNoise_s) * (1 / kNoise_s), 0.0f, 1.0f);
    return fitted_s * share;
}

}  // namespace

void FixComparison::add(const core::Vector3& missing_mss, const core::Vector3& mean_mss,
                        float inverse_time) {
    missing_mss_[0] = missing_mss_[1];
    missing_mss_[1] = {missing_mss.x, missing_mss.y};
    mean_mss_[0] = mean_mss_[1];
    mean_mss_[1] = mean_mss_[2];
    mean_mss_[2] = {mean_mss.x, mean_mss.y};
    inverse_time_ = inverse_time;
    if (intervals_ < kIntervals) ++intervals_;
}

FixComparison::Level FixComparison::change_msss() const {
    const float inverse = core::half(inverse_time_);
    return {(mean_mss_[2].north - mean_mss_[0].north) * inverse,
            (mean_mss_[2].east - mean_mss_[0].east) * inverse};
}

void GpsDelay::learn(const FixComparison& seen, float used_s) {
    const Level later = seen.change_msss();
    const Level change = {-later.north, -later.east};
    const float squared = product(change, change);
    if (squared < square(kMinChange_msss) || squared > square(kMaxChange_msss)) return;
    Level missing = seen.missing_mss();
    if (product(missing, missing) > square(kMaxMissing_mss)) return;
    missing = {missing.north + change.north * used_s, missing.east + change.east * used_s};
    const Level heading = {-seen.mean_mss().east, seen.mean_mss().north};
    changes_ += squared;
    headings_ += product(heading, heading);
    both_ += product(change, heading);
    by_change_ += product(change, missing);
    by_heading_ += product(heading, missing);
    if (changes_ >= kMaxKnown) {
        changes_ *= kFade;
        headings_ *= kFade;
        both_ *= kFade;
        by_change_ *= kFade;
        by_heading_ *= kFade;
    }
    if (++learnt_ % kLearntPerFit != 0) return;
    correction_s_ = core::limit(withoutNoise(fitted_s()), -kMaxYounger_s, kMaxOlder_s);
}

// Never divides by zero: by Cauchy and Schwarz the determinant is kPrior squared or more.
float GpsDelay::fitted_s() const {
    const float changes = changes_ + kPrior, headings = headings_ + kPrior;
    return (by_change_ * headings - by_heading_ * both_) / (changes * headings - both_ * both_);
}

}  // namespace estimation

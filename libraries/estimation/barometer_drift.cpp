// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/barometer_drift.hpp"

#include "core/maths.hpp"

namespace estimation {
namespace {

// Near the optimum (Kalman's filter, settled) for a drift of 0.35 m within 300 s and velocities
// that err by 0.05 m/s five times a second.
constexpr float kShare = 0.4f;
constexpr float kForgotten_s = 400.0f;
constexpr float kMissed_s = 1.5f;   // between two fixes nobody knows how far it climbed
constexpr float kMaxStep_m = 0.3f;  // between two fixes; a larger one is no drift
constexpr float kMax_m = 2.0f;      // what a wrong velocity can do

// The scale is not learnt from a slower climb: there errors of the velocity would show as one.
constexpr float kClimbs_mps = 1.0f;
// A drift of 0.35 m in a climb of 70 m looks like this, and is not made a scale of; three times as
// much is the air.
constexpr float kDriftInClimb = 0.005f, kSteep = 1.5f;
constexpr float kMaxShare = 0.2f;  // of the climb: what a scale explains
// Rises err by some 0.14 m between two fixes, and the scale by 0.05 before anything is known.
constexpr float kPrior_m2 = 8.0f;
constexpr float kForgets_m2 = 400.0f;  // air changes: what was learnt long ago counts less
constexpr float kLeastScale = 0.87f, kMaxScale = 1.18f;  // the air -25 to 40 degrees off

}  // namespace

float BarometerDrift::useGps(float height_m, float climb_mps, float dt_s) {
    const float rise_m = height_m - last_m_;
    last_m_ = height_m;
    const float climbed_m = climb_mps * dt_s;
    const float apart_m = rise_m - climbed_m / (1 + scale_more_);
    if (dt_s > kMissed_s || fabsf(apart_m) > kMaxStep_m + kMaxShare * fabsf(climbed_m)) return 0;
    if (fabsf(climb_mps) > kClimbs_mps) {
        learnScale(rise_m, climbed_m);
        return 0;
    }
    const float step_m = kShare * apart_m - drift_m_ * (dt_s * (1.0f / kForgotten_s));
    if (fabsf(drift_m_ + step_m) > kMax_m) return 0;
    drift_m_ += step_m;
    return step_m;
}

float BarometerDrift::scale() const {
    const float more = fabsf(scale_more_);
    if (more <= kDriftInClimb) return 1;
    return 1 + copysignf(fminf(more, (more - kDriftInClimb) * kSteep), scale_more_);
}

void BarometerDrift::resumeScale(float scale) {
    const float more = core::limit(scale, kLeastScale, kMaxScale) - 1;
    const float steep = fabsf(more) * (1 / kSteep) + kDriftInClimb;
    scale_more_ = more == 0 ? 0 : copysignf(fmaxf(fabsf(more), steep), more);
}

// Least squares, one climb after the other.
void BarometerDrift::learnScale(float rise_m, float climbed_m) {
    known_m2_ = fminf(known_m2_ + climbed_m * climbed_m, kForgets_m2);
    const float missing_m = climbed_m - rise_m * (1 + scale_more_);
    const float step = missing_m * climbed_m / (known_m2_ + kPrior_m2);
    scale_more_ = core::limit(scale_more_ + step, kLeastScale - 1, kMaxScale - 1);
}

}  // namespace estimation

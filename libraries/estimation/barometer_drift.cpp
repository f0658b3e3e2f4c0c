// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/barometer_drift.hpp"

#include "core/maths.hpp"

namespace estimation {
namespace {

// Near the optimum (Kalman's filter, settled) for a drift of 0.35 m within 300 s and velocities
// that err by 0.05 m/s five times a second, where it is 0.4: what velocities err by adds up to the
// more, the seldomer they come.
constexpr float kHalfShare_s = 0.133f;
constexpr float kForgotten_s = 400.0f;
constexpr float kMissed_s = 1.5f;   // between two fixes nobody knows how far it climbed
constexpr float kMaxStep_m = 0.3f;  // between two fixes; a larger one is no drift
constexpr float kMax_m = 2.0f;      // what a wrong velocity can do

constexpr float kMaxShare = 0.2f;                      // of the climb: what a scale explains
constexpr float kMinScale = 0.87f, kMaxScale = 1.18f;  // the air -25 to 40 degrees off

// Variances are given by that of what a fix shows, (0.1 m)^2 with what the filter of the height
// leaves of the barometer's noise. The scale errs by 0.04 at first, 11 degrees, and by 0.01 where
// an earlier flight has learnt it. The air changes by a degree in ten minutes.
constexpr float kFix_m2 = 0.01f;
constexpr float kUnknown = 0.04f * 0.04f / kFix_m2, kResumed = 0.01f * 0.01f / kFix_m2;
constexpr float kChanges_hz = 4e-6f;
// In a climb of 100 m a barometer drifts by as much. Nothing is gained by using it.
constexpr float kMayBeDrift = 0.004f, kSteep = 2;

}  // namespace

void BarometerDrift::zero() { drift_m_ = covariance_ = 0; }

float BarometerDrift::scale() const {
    const float more = fabsf(scale_more_);
    if (more <= kMayBeDrift) return 1;
    return 1 + copysignf(fminf(more, (more - kMayBeDrift) * kSteep), scale_more_);
}

float BarometerDrift::useGps(float height_m, const Climb& climb, float dt_s) {
    const float rise_m = height_m - last_m_;
    last_m_ = height_m;
    // of the fix before: with this one's noise a receiver would seem to climb too much
    const float nearly_climbed_m = agree(last_mps_, climb.barometer_mps) ? last_mps_ * dt_s : 0;
    last_mps_ = climb.receiver_mps;
    const float climbed_m = climb.receiver_mps * dt_s;
    const float apart_m = rise_m - climbed_m / (1 + scale_more_);
    if (paused_ > 0) {
        --paused_;
        return 0;
    }
    if (dt_s > kMissed_s || fabsf(apart_m) > kMaxStep_m + kMaxShare * fabsf(climbed_m)) return 0;
    const float forgotten = dt_s * (1.0f / kForgotten_s);
    const float share = kHalfShare_s / (kHalfShare_s + dt_s);
    const float step_m = learn(apart_m, nearly_climbed_m, share) - drift_m_ * forgotten;
    covariance_ -= covariance_ * forgotten;
    variance_less_ = core::limit(variance_less_ - kChanges_hz * dt_s, 0.0f, kUnknown);
    if (fabsf(drift_m_ + step_m) > kMax_m) return 0;
    drift_m_ += step_m;
    return step_m;
}

// What of it is drift; the rest is the scale, or noise.
float BarometerDrift::learn(float apart_m, float climbed_m, float share) {
    const float variance = kUnknown - variance_less_;
    const float of_scale = -climbed_m * variance;
    const float of_drift = share - climbed_m * covariance_;
    const float of_fix = 1 + climbed_m * climbed_m * variance;
    const float by_scale = of_scale / of_fix;
    variance_less_ += by_scale * of_scale;
    covariance_ -= by_scale * of_drift;
    scale_more_ = core::limit(scale_more_ + by_scale * apart_m, kMinScale - 1, kMaxScale - 1);
    return of_drift / of_fix * apart_m;
}

// A wrong velocity is no climb.
bool BarometerDrift::agree(float climb_mps, float other_mps) {
    return 2 * fabsf(climb_mps - other_mps) < fabsf(climb_mps);
}

void BarometerDrift::resumeScale(float scale) {
    const float more = core::limit(scale, kMinScale, kMaxScale) - 1;
    if (more == 0) return;
    const float steep = fabsf(more) * (1 / kSteep) + kMayBeDrift;
    scale_more_ = copysignf(fmaxf(fabsf(more), steep), more);
    variance_less_ = kUnknown - kResumed;
    covariance_ = 0;
}

}  // namespace estimation

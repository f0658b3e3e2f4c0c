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

// Variances are given by that of the height that both are compared at, (0.3 m)^2: what the filter
// of the height leaves of the barometer's noise is not gone with the next fix. The scale errs by
// 0.04 at first, 11 degrees, and by 0.01 where an earlier flight has learnt it. The air changes by
// a degree in ten minutes.
constexpr float kHeight_m2 = 0.1f;
constexpr float kUnknown = 0.04f * 0.04f / kHeight_m2, kResumed = 0.01f * 0.01f / kHeight_m2;
constexpr float kChanges_hz = 4e-8f / kHeight_m2;
// The barometer drifts by 0.35 m within 300 s, velocities err by 0.05 m/s, and by what gusts do
// between two fixes, which is the more, the longer that takes: 0.1 m/s in a second.
constexpr float kDrifts_hz = 8e-4f / kHeight_m2;
constexpr float kVelocity_hz2 = 0.05f * 0.05f / kHeight_m2, kGusts_hz4 = 0.1f * 0.1f / kHeight_m2;
// Nobody saw when between two fixes the climb became another: at take-off from one to the next.
// What is even over an interval has a variance of its square / 12.
constexpr float kSteeper = 1 / (12 * kHeight_m2);
// Slower than this it flies level, and what is apart is drift.
constexpr float kClimb_mps = 0.5f;
// Farther apart than three times what is expected it is a velocity that is wrong for long.
constexpr float kWrong_m2 = 9 * kHeight_m2;
// In a climb of 100 m a barometer drifts by as much. Nothing is gained by using it.
constexpr float kMayBeDrift = 0.004f, kSteep = 2;

}  // namespace

void BarometerDrift::zero() {
    drift_m_ = risen_m_ = apart_m_ = 0;
    drift_variance_ = covariance_ = 0;
}

float BarometerDrift::scale() const {
    const float more = fabsf(scale_more_);
    if (more <= kMayBeDrift) return 1;
    return 1 + copysignf(fminf(more, (more - kMayBeDrift) * kSteep), scale_more_);
}

float BarometerDrift::useGps(float height_m, float climb_mps, float dt_s) {
    const float rise_m = height_m - last_m_;
    last_m_ = height_m;
    const float climbed_m = climb_mps * dt_s;
    const float steeper_m = climbed_m - last_climb_mps_ * dt_s;
    last_climb_mps_ = climb_mps;
    const float apart_m = rise_m - climbed_m / (1 + scale_more_);
    if (paused_ > 0) {
        --paused_;
        return 0;
    }
    if (dt_s > kMissed_s || fabsf(apart_m) > kMaxStep_m + kMaxShare * fabsf(climbed_m)) return 0;
    const float forgotten = dt_s * (1.0f / kForgotten_s);
    const float share = kHalfShare_s / (kHalfShare_s + dt_s);
    const bool climbs = fabsf(climb_mps) > kClimb_mps;
    const float step_m =
        share * learn(apart_m, rise_m, steeper_m, dt_s, climbs) - drift_m_ * forgotten;
    variance_less_ = core::limit(variance_less_ - kChanges_hz * dt_s, 0.0f, kUnknown);
    if (fabsf(drift_m_ + step_m) > kMax_m) return 0;
    drift_m_ += step_m;
    return step_m;
}

// What of all that both are apart since the zero is not the scale's: drift, and the sum of what the
// velocities err by. Heights are compared, not the climbs between two fixes: what the barometer's
// noise or a wrong age of fixes adds to one is taken back by the next.
float BarometerDrift::learn(float apart_m, float rise_m, float steeper_m, float dt_s, bool climbs) {
    const float risen_m = risen_m_ + rise_m, all_m = apart_m_ + apart_m;
    const float squared_s2 = dt_s * dt_s;
    const float drift = drift_variance_ + kDrifts_hz * dt_s +
                        (kVelocity_hz2 + kGusts_hz4 * squared_s2) * squared_s2 +
                        steeper_m * steeper_m * kSteeper;
    const float of_drift = drift - risen_m * covariance_;
    const float of_scale = covariance_ - risen_m * (kUnknown - variance_less_);
    const float expected = of_drift - risen_m * of_scale + 1;
    if (all_m * all_m > kWrong_m2 * expected) return 0;
    const float inverse = core::inverse(expected);
    const float by_drift = of_drift * inverse;
    const float by_scale = climbs ? of_scale * inverse : 0;
    drift_variance_ = drift - by_drift * of_drift;
    covariance_ -= by_drift * of_scale;
    variance_less_ += by_scale * of_scale;
    const float more = by_scale * all_m, of_it_m = more * risen_m;
    scale_more_ = core::limit(scale_more_ + more, kMinScale - 1, kMaxScale - 1);
    risen_m_ = risen_m;
    apart_m_ = all_m - by_drift * all_m + of_it_m;
    return apart_m + of_it_m;
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

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

}  // namespace

float BarometerDrift::useGps(float height_m, float climb_mps, float dt_s) {
    const float rise_m = height_m - last_m_;
    last_m_ = height_m;
    const float apart_m = rise_m - climb_mps * dt_s;
    if (dt_s > kMissed_s || fabsf(apart_m) > kMaxStep_m) return 0;
    const float step_m = kShare * apart_m - drift_m_ * (dt_s * (1.0f / kForgotten_s));
    if (fabsf(drift_m_ + step_m) > kMax_m) return 0;
    drift_m_ += step_m;
    return step_m;
}

}  // namespace estimation

// SPDX-License-Identifier: GPL-3.0-or-later
#include "navigation/takeoff.hpp"

#include <math.h>

#include "core/maths.hpp"

namespace navigation {
namespace {

constexpr float kLowPitch_rad = core::radians(5);
constexpr float kThrowPitchLow_rad = core::radians(-30), kThrowPitchHigh_rad = core::radians(45);
constexpr float kThrowRoll_rad = core::radians(30);
constexpr float kThrowTimeout_s = 0.1f;   // after the delay the speed must be there
constexpr float kCourseSpeed_mps = 5.0f;  // GPS courses below wander
constexpr float kCourseTime_s = 2.0f;
constexpr float kSlowShare = 0.8f;  // of flying speed: the nose begins to come up

bool upright(const LaunchState& now) {
    return now.pitch_rad > kThrowPitchLow_rad && now.pitch_rad < kThrowPitchHigh_rad &&
           now.roll_rad < kThrowRoll_rad && now.roll_rad > -kThrowRoll_rad;
}

}  // namespace

Launch::Result Launch::run(const LaunchSettings& settings, const LaunchState& now) {
    const bool push_asked = core::isPositive(settings.min_accel_mss);
    const bool pushed =
        !core::isNegative(waited_s_) || (push_asked && now.accel_mss >= settings.min_accel_mss);
    if (!upright(now)) {
        const bool new_push = pushed && waited_s_ != kTilted_s;  // a push is reported once
        waited_s_ = pushed ? kTilted_s : kUnpushed_s;
        return new_push ? tilted : waits;
    }
    if (core::isNegative(waited_s_)) {
        if (push_asked && !pushed) return waits;
        waited_s_ = 0;
    } else {
        waited_s_ += now.dt_s;
    }
    const float delay_s = core::real(settings.delay_ds) * 0.1f;
    if (waited_s_ < delay_s) return waits;
    if (now.ground_speed_mps >= settings.min_speed_mps) return flies;
    if (!push_asked || waited_s_ <= delay_s + kThrowTimeout_s) return waits;
    start();
    return slow;
}

void TakeoffCourse::run(const geo::Offset& velocity_mps, float ground_speed_mps, float yaw_rad,
                        float dt_s) {
    if (locked_) return;
    waiting_.fast_s = ground_speed_mps > kCourseSpeed_mps ? waiting_.fast_s + dt_s : 0;
    if (waiting_.fast_s < kCourseTime_s) return;
    const float turned_rad = core::wrapPi(yaw_rad - waiting_.yaw_rad);
    const float share = core::inverse(ground_speed_mps);
    const float north = velocity_mps.north_m * share, east = velocity_mps.east_m * share;
    const float c = cosf(turned_rad), s = sinf(turned_rad);
    course_ = {north * c + east * s, east * c - north * s};
    locked_ = true;
}

float takeoffPitch_rad(const TakeoffPitch& settings, float speed_mps, bool airspeed_known) {
    const float most_rad = settings.takeoff_rad;
    const float low_rad = most_rad < kLowPitch_rad ? most_rad : kLowPitch_rad;
    if (core::isPositive(settings.rotate_mps) && speed_mps < settings.rotate_mps) return low_rad;
    const float full_mps = airspeed_known ? settings.flying_mps : settings.cruise_mps;
    if (speed_mps >= full_mps) return most_rad;
    if (!airspeed_known) return core::limit(most_rad * speed_mps / full_mps, low_rad, most_rad);
    const float share = (speed_mps / full_mps - kSlowShare) * (1 / (1 - kSlowShare));
    return core::lerp(low_rad, most_rad, core::limit(share, 0.0f, 1.0f));
}

}  // namespace navigation

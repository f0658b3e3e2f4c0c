// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/height.hpp"

#include "core/maths.hpp"

namespace estimation {
namespace {

constexpr uint16_t kInsist_ms = 2000;  // ... unless they all are, this long
constexpr float kMaxBias_mss = 2.0f;
constexpr uint16_t kSinking_ms = 1000;  // without readings the climb rate dies away with this

void add(uint16_t& time_ms, float dt_s) {
    const uint16_t step_ms = static_cast<uint16_t>(dt_s * 1000.0f + 0.5f);
    time_ms = step_ms > UINT16_MAX - time_ms ? UINT16_MAX : time_ms + step_ms;
}

}  // namespace

void Height::start(float height_m) {
    *this = Height();
    height_m_ = height_m;
    unfed_ms_ = 0;
}

void Height::propagate(float up_mss, float dt_s) {
    add(unfed_ms_, dt_s);
    if (unfed_ms_ > kSinking_ms) {  // nothing holds the accelerations' errors any more
        climb_mps_ -= climb_mps_ * (dt_s * (1000.0f / kSinking_ms));
        return;
    }
    const float gain_mps = (up_mss + bias_mss_) * dt_s;
    height_m_ += (climb_mps_ + core::half(gain_mps)) * dt_s;
    climb_mps_ += gain_mps;
}

void Height::useBarometer(float height_m, float dt_s, const HeightSettings& settings) {
    const float error_m = height_m - height_m_;
    if (!healthy()) {
        start(height_m);
        return;
    }
    if (error_m > kGlitch_m || error_m < -kGlitch_m) {
        add(off_ms_, dt_s);
        if (off_ms_ > kInsist_ms) start(height_m);
        return;
    }
    off_ms_ = 0;
    unfed_ms_ = 0;
    // An observer with its three poles at omega: (s + omega)^3.
    const float omega = settings.omega_rads;
    const float step = error_m * omega * core::limit(dt_s, 0.0f, 0.1f);
    height_m_ += 3.0f * step;
    climb_mps_ += 3.0f * omega * step;
    bias_mss_ = core::limit(bias_mss_ + omega * omega * step, -kMaxBias_mss, kMaxBias_mss);
}

}  // namespace estimation

// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/still.hpp"

namespace estimation {
namespace {

constexpr float kTime_s = 1.0f;
// Means of a tenth of a second are compared: the sensors' noise is far below these, a hand's
// movement above.
constexpr float kRate_rads = 0.02f;  // about 1 deg/s
constexpr float kForce_mss = 0.5f;
constexpr float kMostZero_rads = 0.35f;  // 20 deg/s, MPU-6000 data sheet: zero-rate output

bool near(const core::Vector3& a, const core::Vector3& b, float limit) {
    return fabsf(a.x - b.x) < limit && fabsf(a.y - b.y) < limit && fabsf(a.z - b.z) < limit;
}

}  // namespace

bool Still::update(const core::Vector3& rate_rads, const core::Vector3& force_mss, float dt_s) {
    if (done_) return false;
    rate_sum_ = rate_sum_ + rate_rads * dt_s;
    force_sum_ = force_sum_ + force_mss * dt_s;
    part_s_ += dt_s;
    if (part_s_ < 0.1f) return false;
    return usePart();
}

bool Still::usePart() {
    const core::Vector3 rate = rate_sum_ * (1.0f / part_s_);
    const core::Vector3 force = force_sum_ * (1.0f / part_s_);
    const float part_s = part_s_;
    rate_sum_ = force_sum_ = {0, 0, 0};
    part_s_ = 0;
    if (time_s_ == 0) {
        force_ = force;
        zero_ = rate;
    }
    const bool still = near(rate, zero_, kRate_rads) && near(force, force_, kForce_mss) &&
                       near(rate, {0, 0, 0}, kMostZero_rads);
    if (!still) {
        time_s_ = 0;
        return false;
    }
    time_s_ += part_s;
    const float share = part_s / time_s_;
    zero_ = zero_ + (rate - zero_) * share;
    force_ = force_ + (force - force_) * share;
    done_ = time_s_ >= kTime_s;
    return done_;
}

}  // namespace estimation

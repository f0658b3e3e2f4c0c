// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/gyro_bias_init.hpp"
#include "core/seldom.hpp"

namespace estimation {
namespace {

// Means of a tenth of a second are compared: the sensors' noise is far below these, a hand's
// movement above.
constexpr float kRate_rads = 0.02f;  // about 1 deg/s
constexpr float kForce_mss = 0.5f;
// Gusts rock an airplane on its wheels to and fro; they do not turn it about.
constexpr float kSwayed_rads = 0.08f, kRocked_rads = 0.2f, kTurned_rads = 0.03f;
constexpr float kAgreed_rads = 0.005f;  // 0.3 deg/s
constexpr float kMaxZero_rads = 0.35f;  // 20 deg/s, MPU-6000 data sheet: zero-rate output

SELDOM void approach(core::Vector3& mean, const core::Vector3& value, float share) {
    mean = mean + (value - mean) * share;
}

bool near(const core::Vector3& a, const core::Vector3& b, float limit, float limit_z) {
    return fabsf(a.x - b.x) < limit && fabsf(a.y - b.y) < limit && fabsf(a.z - b.z) < limit_z;
}

}  // namespace

bool GyroBiasInit::update(const core::Vector3& rate_rads, const core::Vector3& force_mss,
                          float dt_s) {
    if (settled()) return false;
    rate_sum_ = rate_sum_ + rate_rads * dt_s;
    force_sum_ = force_sum_ + force_mss * dt_s;
    part_ms_ += static_cast<uint16_t>(dt_s * 1000 + 0.5f);
    if (part_ms_ <= 100) return false;
    return usePart();
}

// Neither tilted nor turned about since the first part. A gust tips it, a hand does more.
bool GyroBiasInit::isStill(const core::Vector3& rate_rads, const core::Vector3& force_mss) const {
    return near(rate_rads, mean_, done() ? kRocked_rads : kSwayed_rads, kTurned_rads) &&
           near(force_mss, force_, kForce_mss, kForce_mss) &&
           near(rate_rads, {0, 0, 0}, kMaxZero_rads, kMaxZero_rads);
}

bool GyroBiasInit::usePart() {
    const float inverse_s = 1000.0f / part_ms_;
    const core::Vector3 rate = rate_sum_ * inverse_s;
    const core::Vector3 force = force_sum_ * inverse_s;
    rate_sum_ = force_sum_ = {0, 0, 0};
    part_ms_ = 0;
    if (parts_ == 0) {
        if (!done()) force_ = force;
        mean_ = rate;
        rocked_ = false;
    }
    if (!isStill(rate, force)) {
        parts_ = 0;
        return false;
    }
    rocked_ = rocked_ || !near(rate, mean_, kRate_rads, kRate_rads);
    const float share = core::inverse(core::real(++parts_));
    approach(mean_, rate, share);
    if (done()) return useMean();
    approach(force_, force, share);
    return parts_ == (rocked_ ? kRocked : kSecond) && useFirst();
}

// Rocked, the mean of two seconds still holds a part of the last tilt to and fro; the next two
// must agree. A hand's movements do not.
bool GyroBiasInit::useFirst() {
    if (rocked_) {
        const bool agreed = compared_ && near(mean_, zero_, kAgreed_rads, kAgreed_rads);
        mean_ = agreed ? (mean_ + zero_) * 0.5f : mean_;
        compared_ = true;
        parts_ = agreed ? 2 * kRocked : 0;
    }
    zero_ = mean_;
    known_ = parts_;
    return done();
}

// What a hand begins to move is found out within a second: until then a better mean waits.
bool GyroBiasInit::useMean() {
    const uint8_t over = parts_ % kSecond;
    if (over == 1 && parts_ > known_) {
        zero_ = mean_;
        known_ = parts_;
    }
    return over == 0 && parts_ > known_;
}

}  // namespace estimation

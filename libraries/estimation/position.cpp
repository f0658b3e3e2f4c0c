// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/position.hpp"

namespace estimation {
namespace {

constexpr float kPositionShare = 0.25f;  // of the difference, taken over with each fix
constexpr float kVelocityShare = 0.4f;
constexpr float kFar_m = 30.0f;        // a fix this far off is refused ...
constexpr float kFarther_mps = 15.0f;  // ... and farther with the age of the last one used
constexpr float kBelieved_s = 18.0f;   // after so long a fix is believed wherever it is
constexpr float kCarries_s = 1.0f;     // without a fix the accelerations are carried on
constexpr float kFold_m = 200.0f;      // the offset is folded into the anchor beyond this

}  // namespace

void Position::propagate(const core::Vector3& acceleration_mss, float dt_s) {
    if (age_s_ < 1e6f) age_s_ += dt_s;
    // Without fixes the accelerations' errors grow with the square of time: only the velocity is
    // carried on.
    const float share = age_s_ < kCarries_s ? dt_s : 0.0f;
    const core::Vector3 gain = acceleration_mss * share;
    since_.north_m += (velocity_.x + 0.5f * gain.x) * dt_s;
    since_.east_m += (velocity_.y + 0.5f * gain.y) * dt_s;
    velocity_ = velocity_ + gain;
}

void Position::reckon(float north_mps, float east_mps) {
    if (age_s_ < kCarries_s) return;
    velocity_.x = north_mps;
    velocity_.y = east_mps;
}

void Position::useGps(const geo::Position& position, const core::Vector3& velocity_mps,
                      const core::Vector3& gained_mps, const PositionSettings& settings) {
    const core::Vector3 velocity = velocity_mps + gained_mps;  // now
    const core::Vector3 mean = velocity_mps + gained_mps * 0.5f;
    const geo::Offset carried = {mean.x * settings.gps_age_s, mean.y * settings.gps_age_s};
    if (age_s_ > kBelieved_s) {
        anchorAt(position, carried);
        velocity_ = velocity;
        age_s_ = 0;
        refuses_ = false;
        return;
    }
    const geo::Offset fix = geo::offset(anchor_, position);
    const float north_m = fix.north_m + carried.north_m - since_.north_m;
    const float east_m = fix.east_m + carried.east_m - since_.east_m;
    const float far_m = kFar_m + kFarther_mps * age_s_;
    refuses_ = north_m * north_m + east_m * east_m > far_m * far_m;
    if (refuses_) return;
    const bool late = reckoned();
    age_s_ = 0;
    since_.north_m += north_m * (late ? 1.0f : kPositionShare);
    since_.east_m += east_m * (late ? 1.0f : kPositionShare);
    velocity_ = late ? velocity : velocity_ + (velocity - velocity_) * kVelocityShare;
    if (since_.north_m * since_.north_m + since_.east_m * since_.east_m > kFold_m * kFold_m) {
        const geo::Position here = this->position();
        const geo::Offset whole = geo::offset(anchor_, here);  // the rest of a 1e-7 degree stays
        anchorAt(here, {since_.north_m - whole.north_m, since_.east_m - whole.east_m});
    }
}

// Within a few hundred metres of the anchor a metre is the same number of 1e-7 degrees.
void Position::anchorAt(const geo::Position& anchor, const geo::Offset& since) {
    constexpr float kSpan_m = 1000.0f;
    const geo::Position corner = geo::moved(anchor, {kSpan_m, 0});
    // A step away from the antimeridian, wherever the anchor is.
    const int32_t step_e7 = anchor.longitude_e7 > 0 ? -100000 : 100000;
    const geo::Position beside = {anchor.latitude_e7, anchor.longitude_e7 + step_e7};
    const float across_m = geo::offset(anchor, beside).east_m;
    anchor_ = anchor;
    since_ = since;
    north_e7_per_m_ =
        static_cast<float>(corner.latitude_e7 - anchor.latitude_e7) * (1.0f / kSpan_m);
    east_e7_per_m_ = static_cast<float>(step_e7) / across_m;
}

geo::Position Position::position() const {
    constexpr int32_t kHalfTurn_e7 = 1800000000;
    geo::Position here = {anchor_.latitude_e7 + core::rounded(since_.north_m * north_e7_per_m_),
                          anchor_.longitude_e7 + core::rounded(since_.east_m * east_e7_per_m_)};
    if (here.longitude_e7 > kHalfTurn_e7) {
        here.longitude_e7 = (here.longitude_e7 - kHalfTurn_e7) - kHalfTurn_e7;
    } else if (here.longitude_e7 < -kHalfTurn_e7) {
        here.longitude_e7 = (here.longitude_e7 + kHalfTurn_e7) + kHalfTurn_e7;
    }
    return here;
}

}  // namespace estimation

// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/position.hpp"

namespace estimation {
namespace {

constexpr float kPositionShare = 0.25f;  // of the difference, taken over with each fix
constexpr float kVelocityShare = 0.4f;
constexpr float kMean_hz = 0.005f;      // fixes are averaged over 200 s ...
constexpr float kMean_hzpm2 = 0.003f;   // ... and over less where they lie far off
constexpr float kFar_m = 30.0f;         // a fix this far off is refused ...
constexpr float kFarther_mps = 15.0f;   // ... and farther with the age of the last one used
constexpr float kFaster_mps = 10.0f;    // ... and so is one whose velocity is as far off ...
constexpr float kFasterYet_mss = 5.0f;  // ... as the accelerations alone may leave it
constexpr float kLost_s = 18.0f;        // after so long two fixes that agree are accepted anywhere
constexpr float kFold_m = 200.0f;       // the offset is folded into the anchor beyond this

float squared(const geo::Offset& off) { return core::squaredLength(off.north_m, off.east_m); }

}  // namespace

void Position::propagate(const core::Vector3& acceleration_mss, float dt_s) {
    if (age_s_ < kNever_s) age_s_ += dt_s;
    const float north_mps = acceleration_mss.x * dt_s, east_mps = acceleration_mss.y * dt_s;
    since_.north_m += (north_mps_ + core::half(north_mps)) * dt_s;
    since_.east_m += (east_mps_ + core::half(east_mps)) * dt_s;
    north_mps_ += north_mps;
    east_mps_ += east_mps;
}

void Position::reckon(float north_mps, float east_mps, float share) {
    north_mps_ = core::lerp(north_mps_, north_mps, share);
    east_mps_ = core::lerp(east_mps_, east_mps, share);
}

void Position::useGps(const geo::Position& position, const core::Vector3& velocity_mps,
                      const core::Vector3& gained_mps, const PositionSettings& settings) {
    if (age_s_ >= kNever_s) anchorAt(position, {0, 0});
    const bool lost = age_s_ > kLost_s;
    const geo::Offset fix = geo::offset(anchor_, position);
    const float age_s = settings.gps_age_s;
    const geo::Offset off = {
        fix.north_m + (velocity_mps.x + core::half(gained_mps.x)) * age_s - since_.north_m,
        fix.east_m + (velocity_mps.y + core::half(gained_mps.y)) * age_s - since_.east_m};
    const float far_m = kFar_m + (lost ? 0.0f : kFarther_mps * age_s_);
    off_m2_ = squared(off);
    limit_m2_ = far_m * far_m;
    const geo::Offset faster = {velocity_mps.x + gained_mps.x - north_mps_,
                                velocity_mps.y + gained_mps.y - east_mps_};
    const float limit_mps = kFaster_mps + kFasterYet_mss * age_s_;
    refuses_ = off_m2_ > limit_m2_ || squared(faster) > limit_mps * limit_mps;
    if (refuses_ && lost) anchorAt(position, {0, 0});  // the next one is compared with it
    if (refuses_) return;
    const bool late = reckoned();
    const float share = late ? 1.0f : kPositionShare;
    since_.north_m += (off.north_m - wander_m(mean_.north_m, fix.north_m, velocity_mps.x)) * share;
    since_.east_m += (off.east_m - wander_m(mean_.east_m, fix.east_m, velocity_mps.y)) * share;
    const float velocity_share = late ? 1.0f : kVelocityShare;
    north_mps_ += faster.north_m * velocity_share;
    east_mps_ += faster.east_m * velocity_share;
    age_s_ = 0;
    if (squared(since_) < kFold_m * kFold_m) return;
    const geo::Position here = this->position();
    const geo::Offset whole = geo::offset(anchor_, here);  // the rest of a 1e-7 degree stays
    mean_ = {mean_.north_m - whole.north_m, mean_.east_m - whole.east_m};
    anchorAt(here, {since_.north_m - whole.north_m, since_.east_m - whole.east_m});
}

// A receiver's place wanders by metres within minutes; its velocity, from the carriers' Doppler,
// does not. So the fixes are averaged along the way that the velocities make (R. Hatch, The
// Synergism of GPS Code and Carrier Measurements, 1982), which runs half an interval ahead of them.
float Position::wander_m(float& mean_m, float fix_m, float velocity_mps) const {
    constexpr float kUsual_s = 0.2f;
    const bool late = reckoned();
    const float step_m = velocity_mps * (late ? kUsual_s : age_s_);
    mean_m += step_m;
    const float off_m = fix_m + core::half(step_m) - mean_m;
    const float rate_hz = kMean_hz + kMean_hzpm2 * off_m * off_m;
    const float share = late ? 1.0f : core::limit(rate_hz * age_s_, 0.0f, 1.0f);
    mean_m += off_m * share;
    return off_m - off_m * share;
}

// Within a few hundred metres of the anchor a metre is the same number of 1e-7 degrees.
void Position::anchorAt(const geo::Position& anchor, const geo::Offset& since) {
    constexpr int32_t kStep_e7 = 10000;
    // Away from the antimeridian, wherever the anchor is.
    const int32_t step_e7 = anchor.longitude_e7 > 0 ? -kStep_e7 : kStep_e7;
    const geo::Offset step_m =
        geo::offset(anchor, {anchor.latitude_e7 + kStep_e7, anchor.longitude_e7 + step_e7});
    anchor_ = anchor;
    since_ = since;
    north_e7_per_m_ = kStep_e7 / step_m.north_m;
    east_e7_per_m_ = step_e7 / step_m.east_m;
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

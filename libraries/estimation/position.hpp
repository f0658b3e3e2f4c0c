// SPDX-License-Identifier: GPL-3.0-or-later
// Where the airplane is now: fixes that are 0.2 s old and come five times a second, carried on
// with velocity and acceleration. The place is in whole 1e-7 degrees throughout.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"
#include "geo/position.hpp"

namespace estimation {

struct PositionSettings {
    float gps_age_s = 0.243f;  // of a fix when it is given to useGps
};

class Position {
public:
    static constexpr float kReckoned_s = 20.0f;  // after so long without a fix nobody knows
    static constexpr float kMissed_s = 2.0f;
    static constexpr float kCarries_s = 1.0f;  // without a fix the accelerations alone will do

    // Every frame. When the accelerations cannot be trusted, give zeros.
    void propagate(const core::Vector3& acceleration_mss, float dt_s);
    // Without fixes for kCarries_s, with the velocity that air and wind give: this share of the way
    // to it, 0..1.
    void reckon(float north_mps, float east_mps, float share);
    // Every fix, with what was gained since its time (Attitude::gainedSinceFix_mps). One too far
    // off to have been flown to is refused; after 18 s without one that is not, position() moves to
    // each of them, and the next that lies where it leads is accepted.
    void useGps(const geo::Position& position, const core::Vector3& velocity_mps,
                const core::Vector3& gained_mps, const PositionSettings& settings);

    geo::Position position() const;
    core::Vector3 velocity_mps() const { return {north_mps_, east_mps_, 0}; }  // over the ground
    bool known() const { return age_s_ < kReckoned_s; }
    bool reckoned() const { return age_s_ > kMissed_s; }  // no fix was used for a while
    bool refuses() const { return refuses_; }             // the last fix lay too far off
    float age_s() const { return age_s_; }                // since the last fix was used
    // How far the last fix lay off, as a share of the limit; more than 1: it was refused.
    float fixTestRatio() const { return sqrtf(off_m2_ / limit_m2_); }

private:
    static constexpr float kNever_s = 1e6f;
    float wander_m(float& mean_m, float fix_m, float velocity_mps) const;
    void anchorAt(const geo::Position& anchor, const geo::Offset& since);

    geo::Position anchor_ = {0, 0};
    geo::Offset since_ = {0, 0};  // from the anchor to where the airplane is now
    geo::Offset mean_ = {0, 0};   // from the anchor to the fixes' mean, half an interval ahead
    float north_e7_per_m_ = 0, east_e7_per_m_ = 0;
    float north_mps_ = 0, east_mps_ = 0;
    float age_s_ = kNever_s;
    float off_m2_ = 0, limit_m2_ = 1;  // of the last fix
    bool refuses_ = false;
};

}  // namespace estimation

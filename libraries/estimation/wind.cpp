// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/wind.hpp"

namespace estimation {
namespace {

constexpr float kSlow_s = 15.0f;     // the mean wind, not its gusts
constexpr float kTurn = 1.0f;        // change of the nose's direction that shows enough
constexpr float kFirstShare = 0.6f;  // of what the first turn shows: it may be 5 m/s wrong
constexpr float kMaxWind_mps = 50.0f;
constexpr float kLeastAirspeed_mps = 4.0f;

}  // namespace

void Wind::start() { *this = Wind(); }

void Wind::resume(float north_mps, float east_mps) {
    start();
    north_mps_ = north_mps;
    east_mps_ = east_mps;
    heard_s_ = kSlow_s;
    known_ = true;
}

// With the airspeed the wind is ground less air; without it, the airspeed itself follows from two
// headings: in a steady wind the ground velocity changes as the air velocity does.
void Wind::update(const core::Vector3& ground_mps, const Pointing& nose, float airspeed_mps,
                  float dt_s) {
    const bool measured = airspeed_mps >= kLeastAirspeed_mps;
    float speed_mps = airspeed_mps, share = 0;
    if (!measured) {
        if (!fromTurn(ground_mps, nose, speed_mps)) return;
        share = known_ ? 0.3f : kFirstShare;  // at first it is all that is known
    }
    const float north_mps = ground_mps.x - speed_mps * nose.north;
    const float east_mps = ground_mps.y - speed_mps * nose.east;
    // Quick at first, so that the wind is known soon after takeoff.
    heard_s_ = heard_s_ < kSlow_s ? heard_s_ + dt_s : kSlow_s;
    if (measured) share = dt_s / heard_s_;
    north_mps_ = core::limit(core::lerp(north_mps_, north_mps, share), -kMaxWind_mps, kMaxWind_mps);
    east_mps_ = core::limit(core::lerp(east_mps_, east_mps, share), -kMaxWind_mps, kMaxWind_mps);
    known_ = known_ || !measured || heard_s_ > 2.0f;
}

// True when the nose has turned far enough since the last time to show the airspeed.
bool Wind::fromTurn(const core::Vector3& ground_mps, const Pointing& nose, float& airspeed_mps) {
    const float north = nose.north - old_nose_.north, east = nose.east - old_nose_.east;
    const float squared = core::squaredLength(north, east);
    if (seeded_ && squared < kTurn * kTurn) return false;
    bool found = false;
    if (seeded_) {
        airspeed_mps = (north * (ground_mps.x - old_ground_north_) +
                        east * (ground_mps.y - old_ground_east_)) /
                       squared;
        found = airspeed_mps > kLeastAirspeed_mps && airspeed_mps < kMaxWind_mps;
    }
    seeded_ = true;
    old_nose_ = nose;
    old_ground_north_ = ground_mps.x;
    old_ground_east_ = ground_mps.y;
    return found;
}

float Wind::airspeedMissing_mps(const core::Vector3& ground_mps, const Pointing& nose,
                                float airspeed_mps) const {
    if (heard_s_ < kSlow_s) return 0;
    return (ground_mps.x - north_mps_) * nose.north + (ground_mps.y - east_mps_) * nose.east -
           airspeed_mps;
}

float Wind::airspeed_mps(const core::Vector3& ground_mps) const {
    const float north = ground_mps.x - north_mps_, east = ground_mps.y - east_mps_;
    return sqrtf(north * north + east * east + ground_mps.z * ground_mps.z);
}

}  // namespace estimation

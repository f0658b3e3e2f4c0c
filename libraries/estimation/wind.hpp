// SPDX-License-Identifier: GPL-3.0-or-later
// The wind, and the airspeed where no sensor measures it. With a sensor and a heading wind is
// ground velocity less air velocity, low-passed; without one it is found from how the ground
// velocity changes when the airplane turns.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace estimation {

struct Pointing {  // the level part of the nose's direction
    float north, east;
};

class Wind {
public:
    void start();
    void resume(float north_mps, float east_mps);  // known before a restart
    // Every fix in flight. airspeed_mps: true, 0 when no sensor measures it.
    void update(const core::Vector3& ground_mps, const Pointing& nose, float airspeed_mps,
                float dt_s);

    core::Vector3 wind_mps() const { return {north_mps_, east_mps_, 0}; }  // where it blows to
    bool known() const { return known_; }

    // By how much an airspeed is lower than ground velocity and wind show along the nose. A wind
    // that was learnt with a wrong airspeed is wrong along the nose of then, so this shows after a
    // turn. 0 until the wind has been learnt for 15 s.
    float airspeedMissing_mps(const core::Vector3& ground_mps, const Pointing& nose,
                              float airspeed_mps) const;

    // True airspeed from ground velocity and the wind known so far.
    float airspeed_mps(const core::Vector3& ground_mps) const;

private:
    bool fromTurn(const core::Vector3& ground_mps, const Pointing& nose, float& airspeed_mps);

    float north_mps_ = 0, east_mps_ = 0;
    float old_ground_north_ = 0, old_ground_east_ = 0;
    Pointing old_nose_ = {0, 0};
    float heard_s_ = 0;  // of readings, up to the filter's time
    bool seeded_ = false, known_ = false;
};

}  // namespace estimation

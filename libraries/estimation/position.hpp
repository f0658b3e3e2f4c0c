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
    // Every frame. When the accelerations cannot be trusted, give zeros.
    void propagate(const core::Vector3& acceleration_mss, float dt_s);
    // Every fix, with what was gained since its time (Attitude::gainedSinceFix_mps).
    void useGps(const geo::Position& position, const core::Vector3& velocity_mps,
                const core::Vector3& gained_mps, const PositionSettings& settings);

    geo::Position position() const;
    const core::Vector3& velocity_mps() const { return velocity_; }  // north, east, down
    bool known() const { return age_s_ < 5.0f; }                     // a fix was used within 5 s
    float age_s() const { return age_s_; }                           // since the last fix was used

private:
    void anchorAt(const geo::Position& anchor, const geo::Offset& since);

    geo::Position anchor_ = {0, 0};
    geo::Offset since_ = {0, 0};  // from the anchor to where the airplane is now
    float north_e7_per_m_ = 0, east_e7_per_m_ = 0;
    core::Vector3 velocity_ = {0, 0, 0};
    float age_s_ = 1e6f;
    uint8_t refused_ = 0;  // fixes in a row that lay too far off
};

}  // namespace estimation

// SPDX-License-Identifier: GPL-3.0-or-later
// Attitude from gyros, held upright by comparing what the accelerometers say the airplane gained
// in speed with what the GPS says, and pointed north by the compass. Two rows of the direction
// cosine matrix are the state: north and down as the body sees them.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace estimation {

struct AttitudeSettings {
    float gps_age_s = 0.2f;     // of a fix when it is given to useGps
    float declination_rad = 0;  // east positive
    bool use_compass = true;
};

struct Angles {
    float roll_rad, pitch_rad, yaw_rad;
    float sin_roll, cos_roll, sin_pitch, cos_pitch;
};

class Attitude {
public:
    void start();

    // Every frame: the mean rate and specific force over the last dt_s, body axes.
    void propagate(const core::Vector3& rate_rads, const core::Vector3& force_mss, float dt_s);

    // A compass reading in body axes with its offsets removed; only directions count.
    void useCompass(const core::Vector3& field_mg, const AttitudeSettings& settings);

    // Once for every fix: north, east, down. Without a compass its course gives the heading.
    void useGps(const core::Vector3& velocity_mps, const AttitudeSettings& settings);

    // While there is no GPS, five times a second: with the true airspeed (0: unknown) the
    // turn's centripetal acceleration is known well enough to stay upright.
    void useAirspeed(float true_airspeed_mps);

    bool aligned() const { return aligned_; }  // upright and, with a compass, pointed

    // To be asked once a frame; works them out. Yaw clockwise from true north, -pi..pi.
    Angles angles() const;
    core::Vector3 rate_rads() const;  // the last frame's, the estimated bias removed
    core::Vector3 bias_rads() const { return bias_; }

    // Acceleration over ground of the last frame, gravity removed: north, east, down.
    const core::Vector3& acceleration_mss() const { return acceleration_; }
    // Velocity gained since the time of the last fix given to useGps, as the accelerometers have
    // it.
    core::Vector3 gainedSinceFix_mps() const;

private:
    core::Vector3 north_, down_;  // unit vectors in body axes
    core::Vector3 bias_;
    core::Vector3 acceleration_;
    bool aligned_ = false;
};

}  // namespace estimation

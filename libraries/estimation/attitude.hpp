// SPDX-License-Identifier: GPL-3.0-or-later
// Attitude from gyros, held upright by comparing what the accelerometers say the airplane gained
// in speed with what the GPS says, and pointed north by the compass. Two rows of the direction
// cosine matrix are the state: north and down as the body sees them. The matrix is turned every
// second frame, by the turns of both; in between the angles are carried on by their rates.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"
#include "estimation/compass_field.hpp"
#include "estimation/velocity_history.hpp"

namespace estimation {

struct AttitudeSettings {
    // Of a fix when it is given to useGps: 0.2 s in the receiver and 43 ms on the line.
    float gps_age_s = 0.243f;
    float declination_rad = 0;  // east positive
    bool use_compass = true;
};

struct Angles {
    float roll_rad, pitch_rad, yaw_rad;
    float sin_roll, cos_roll, sin_pitch, cos_pitch;
};

class Attitude {
public:
    void start() { *this = Attitude(); }

    // Every frame: the mean rate and specific force over the last dt_s, body axes.
    void propagate(const core::Vector3& rate_rads, const core::Vector3& force_mss, float dt_s);

    // Every compass reading: body axes, offsets removed; only its direction counts.
    void useCompass(const core::Vector3& reading_mg, const AttitudeSettings& settings);

    // Once for every fix: north, east, down. Without a compass its course gives the first heading.
    void useGps(const core::Vector3& velocity_mps, const AttitudeSettings& settings);

    // While there is no GPS, five times a second: with the true airspeed, or in flight a guess of
    // it (0: standing), the turn's centripetal acceleration is known well enough to stay upright.
    void useAirspeed(float true_airspeed_mps);

    bool aligned() const { return phase_ == Phase::pointed; }  // upright and pointed

    // Counts the frames, 0..7. propagate() costs least in the even ones: corrections belong there.
    uint8_t frame() const { return frame_; }

    // Yaw clockwise from true north, -pi..pi. Roll and pitch are new in every frame, the rest in
    // the even ones.
    const Angles& angles() const { return angles_; }
    // Where the nose points, for the wind: the first column of the matrix.
    float noseNorth() const { return north_.x; }
    float noseEast() const { return down_.y * north_.z - down_.z * north_.y; }

    const core::Vector3& rate_rads() const { return rate_; }  // the last, the bias removed
    const core::Vector3& bias_rads() const { return bias_; }

    // What the compass reads of the airplane itself, learnt in turns; body axes.
    const core::Vector3& compassOffset_mg() const { return field_.own_mg(); }

    // Acceleration over ground of the last frames, gravity removed: north, east, down.
    const core::Vector3& acceleration_mss() const { return acceleration_; }
    // Gained by the accelerometers since the time of the last fix given to useGps.
    core::Vector3 gainedSinceFix_mps() const;

private:
    enum class Phase : uint8_t { falling, upright, pointed };

    void alignUpright();
    void turnTo(float sine, float cosine);
    void turnMatrix();
    void catchUp() {
        if (frame_ & 1) turnMatrix();
    }
    void workOutAngles();
    void carryAnglesOn(const core::Vector3& turned_rad);
    void keepUpright();
    void pointYaw();
    void pointAlong(const core::Vector3& velocity_mps);
    void accelerate();
    void forgetForces();
    void correct(const core::Vector3& missing_mss, const core::Vector3& felt_mss, float time_s,
                 float yaw_share);
    void learn(const core::Vector3& turn_rad, const core::Vector3& missing_mss,
               const core::Vector3& east, float time_s);

    core::Vector3 north_ = {1, 0, 0}, down_ = {0, 0, 1};  // unit vectors in body axes
    core::Vector3 bias_ = {0, 0, 0};                      // of the gyros
    float force_bias_x_ = 0, force_bias_y_ = 0;           // of the accelerometers
    core::Vector3 rate_ = {0, 0, 0};
    core::Vector3 turned_ = {0, 0, 0};     // since the matrix was last turned
    core::Vector3 force_sum_ = {0, 0, 0};  // of forces_ frames that took time_s_
    core::Vector3 acceleration_ = {0, 0, 0};
    Angles angles_ = {0, 0, 0, 0, 1, 0, 1};
    float tan_pitch_ = 0;
    CompassField field_;
    VelocityHistory history_;
    VelocityHistory::Moment fix_ = {};         // the accelerometers' velocity at the last fix
    VelocityHistory::Moment fix_ground_ = {};  // and the GPS's
    float since_fix_s_ = 1e6f;
    float time_s_ = 0;
    float yaw_rad_ = 0, yaw_rate_ = 0;
    float settling_ = 1;  // 1 at start, 0 when settled: how much quicker corrections are taken over
    Phase phase_ = Phase::falling;
    uint8_t frame_ = 0, forces_ = 0;
    uint8_t compass_reading_ = 0;
};

}  // namespace estimation

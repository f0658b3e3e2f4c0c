// SPDX-License-Identifier: GPL-3.0-or-later
// Taking off: when the motor may turn, which course is held, and how far the nose comes up.
#pragma once
#include <stdint.h>

#include "geo/position.hpp"

namespace navigation {

struct LaunchSettings {
    float min_speed_mps;  // TKOFF_THR_MINSPD over ground; 0: none needed
    float min_accel_mss;  // TKOFF_THR_MINACC forward; 0: none needed
    int8_t delay_ds;      // TKOFF_THR_DELAY, 0.1 s between the push and the motor
};

struct LaunchState {
    float accel_mss, ground_speed_mps;
    float roll_rad, pitch_rad;
    float dt_s;
};

// Holds the motor until the airplane has been thrown, or at once when no push is asked for.
class Launch {
public:
    enum Result : uint8_t {
        waits,
        flies,   // the motor may turn
        tilted,  // pushed, but not the right way up
        slow,    // pushed, but the speed did not come: waits for the next push
    };
    void start() { waited_s_ = kUnpushed_s; }
    Result run(const LaunchSettings& settings, const LaunchState& now);

private:
    static constexpr float kUnpushed_s = -1, kTilted_s = -2;
    float waited_s_ = kUnpushed_s;  // since the push
};

// Wings level until the course over ground can be trusted; then the course the run began with,
// which is the present one less what the airplane has turned since.
class TakeoffCourse {
public:
    constexpr TakeoffCourse() : waiting_{0, 0} {}
    void start(float yaw_rad) { waiting_ = {yaw_rad, 0}, locked_ = false; }
    void run(const geo::Offset& velocity_mps, float ground_speed_mps, float yaw_rad, float dt_s);
    bool locked() const { return locked_; }
    const geo::Offset& course() const { return course_; }

private:
    union {
        struct {
            float yaw_rad, fast_s;
        } waiting_;           // until locked ...
        geo::Offset course_;  // ... and then
    };
    bool locked_ = false;
};

struct TakeoffPitch {
    float takeoff_rad;  // of the command
    float rotate_mps;   // TKOFF_ROTATE_SPD; 0: none
    float flying_mps;   // ARSPD_FBW_MIN: slower, the nose stays low
    float cruise_mps;
};
// Lowest pitch while an airspeed sensor lets the speed be flown; the pitch itself without one,
// from the ground speed.
float takeoffPitch_rad(const TakeoffPitch& settings, float speed_mps, bool airspeed_known);

}  // namespace navigation

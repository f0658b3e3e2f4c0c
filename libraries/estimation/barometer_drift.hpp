// SPDX-License-Identifier: GPL-3.0-or-later
// How far the barometer has drifted since it was zeroed, as far as a receiver's vertical velocity
// shows: over some minutes its sum errs about as much as the barometer drifts, so a part of what
// lies between the two is taken for drift, and forgotten slowly.
//
// In a climb it also shows how many metres of air a metre of the pressure's height is: that goes
// with the temperature of the air, which a sensor on a warm board does not know. 10 degrees are 3.5
// %. What is missing in a climb is drift or scale: a Kalman filter of both divides it.
#pragma once
#include <stdint.h>

namespace estimation {

class BarometerDrift {
public:
    void zero();                        // the barometer's zero is known
    void pause() { paused_ = kPause; }  // the heights begin anew: for so many fixes they settle

    // Metres for each metre of the barometer's, 0.87 .. 1.18; 1 until it has climbed with fixes.
    float scale() const;
    void resumeScale(float scale);  // what is outside its range is brought back into it

    // Every fix, with the climb that the receiver measures: the barometer's height half an interval
    // after the fix was taken, as its climb is taken for the time around it. By how much the
    // barometer's zero rises.
    float useGps(float height_m, float climb_mps, float dt_s);

private:
    float learn(float apart_m, float rise_m, float steeper_m, float dt_s, bool climbs);
    static constexpr uint8_t kPause = 10;

    float last_m_ = 0, last_climb_mps_ = 0, drift_m_ = 0;
    float risen_m_ = 0;     // the barometer's height, since the zero
    float apart_m_ = 0;     // from the velocities' sum since then, as far as nothing explains it
    float scale_more_ = 0;  // than 1, as the filter has it; 0 takes no flash
    // By the variance of a height: of the scale less than that of the start, which is no zero; of
    // drift and velocities' sum; and the covariance of both.
    float variance_less_ = 0, drift_variance_ = 0, covariance_ = 0;
    uint8_t paused_ = 0;
};

}  // namespace estimation

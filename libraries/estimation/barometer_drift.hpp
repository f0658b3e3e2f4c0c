// SPDX-License-Identifier: GPL-3.0-or-later
// How far the barometer has drifted since it was zeroed, as far as a receiver's vertical velocity
// shows: over some minutes its sum errs about as much as the barometer drifts, so a part of what
// lies between the two is taken for drift, and forgotten slowly.
//
// In a climb it also shows how many metres of air a metre of the pressure's height is: that goes
// with the temperature of the air, which a sensor on a warm board does not know. 10 degrees are 3.5
// %.
#pragma once

namespace estimation {

class BarometerDrift {
public:
    void zero() { drift_m_ = 0; }  // the barometer's zero is known

    // Metres for each metre of the barometer's, 0.87 .. 1.18; 1 until it has climbed with fixes.
    float scale() const;
    void resumeScale(float scale);  // what is outside its range is brought back into it

    // Every fix: the barometer's height half an interval before the fix was taken, as its climb is
    // taken for the whole of it. By how much the barometer's zero rises.
    float useGps(float height_m, float climb_mps, float dt_s);

private:
    void learnScale(float rise_m, float climbed_m);

    float last_m_ = 0, drift_m_ = 0;
    float scale_more_ = 0;  // than 1, as the climbs alone have it; 0 takes no flash
    float known_m2_ = 0;    // how much climbing has shown of it, squared
};

}  // namespace estimation

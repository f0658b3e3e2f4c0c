// SPDX-License-Identifier: GPL-3.0-or-later
// How far the barometer has drifted since it was zeroed, as far as a receiver's vertical velocity
// shows: over some minutes its sum errs about as much as the barometer drifts, so a part of what
// lies between the two is taken for drift, and forgotten slowly.
#pragma once

namespace estimation {

class BarometerDrift {
public:
    void zero() { drift_m_ = 0; }  // the barometer's zero is known

    // Every fix: the barometer's height half an interval before the fix was taken, as its climb is
    // taken for the whole of it. By how much the barometer's zero rises.
    float useGps(float height_m, float climb_mps, float dt_s);

private:
    float last_m_ = 0, drift_m_ = 0;
};

}  // namespace estimation

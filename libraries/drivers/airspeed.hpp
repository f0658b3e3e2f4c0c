// SPDX-License-Identifier: GPL-3.0-or-later
// MPXV7002DP pitot sensor on an analogue input: readings in, dynamic pressure and equivalent
// airspeed out. The zero is measured at start-up, in still air.
#pragma once
#include <stdint.h>

namespace drivers {

struct AirspeedSettings {
    float ratio = 1.9936f;     // ARSPD_RATIO: speed^2 = ratio * pressure in units of 1/819 V
    float offset_v = 0;        // used when `keep_offset`
    bool keep_offset = false;  // do not measure the zero, it is known
    bool either_tube = false;  // the hoses may be swapped: the sign of the pressure is ignored
};

class Airspeed {
public:
    void startCalibration() { *this = Airspeed(); }
    void resume(float offset_v) {  // the zero is known already
        startCalibration();
        offset_ = offset_v / kSupply_v;
        calibrated_ = true;
    }
    // `sum` of `count` 10-bit readings, ratiometric to the sensor's supply; count 0 changes
    // nothing.
    void update(uint16_t sum, uint8_t count, float dt_s, const AirspeedSettings& settings);

    bool calibrated() const { return calibrated_; }
    bool healthy() const { return calibrated_ && bad_s_ < 1.0f; }
    float pressure_pa() const { return pressure_pa_; }  // low-passed, zero removed
    float speed_mps() const { return speed_mps_; }      // equivalent
    float offset_v() const { return offset_ * kSupply_v; }

private:
    static constexpr float kSupply_v = 5.0f;

    void calibrate(float ratio_of_supply, float dt_s, const AirspeedSettings& settings);
    void judge(float raw_pa, float ratio_of_supply, float dt_s, bool either_tube);

    float offset_ = 0.5f;  // share of the supply
    float pressure_pa_ = 0;
    float speed_mps_ = 0;
    float bad_s_ = 0;
    float calibrating_s_ = 0;
    uint8_t means_ = 0;
    bool calibrated_ = false;
};

}  // namespace drivers

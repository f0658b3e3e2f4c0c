// SPDX-License-Identifier: GPL-3.0-or-later
// MPXV7002DP or MPXV5004DP pitot sensor on an analogue input: readings in, dynamic pressure and
// equivalent airspeed out. The zero is measured at start-up, in still air; the two have the same
// span, and differ in where it may lie.
#pragma once
#include <stdint.h>

namespace drivers {

struct AirspeedSettings {
    float ratio = 1.9936f;      // ARSPD_RATIO: speed^2 = ratio * pressure in units of 1/819 V
    float offset_v = 0;         // used when `offset_known`
    bool offset_known = false;  // do not measure the zero, it is known
    bool either_tube = false;   // the hoses may be swapped: the sign of the pressure is ignored
};

class Airspeed {
public:
    void startCalibration() { *this = Airspeed(); }
    void resume(float offset_v) {  // the zero is known already
        startCalibration();
        setZero(offset_v);
    }
    // The mean of `count` 10-bit readings, as a share of the sensor's supply in 2^-16.
    static uint16_t share(uint16_t sum, uint8_t count) {
        return count == 4 ? static_cast<uint16_t>(sum * 16U)
                          : static_cast<uint16_t>(uint32_t{sum} * 64 / count);
    }
    void update(uint16_t share, uint32_t dt_us, const AirspeedSettings& settings);

    bool calibrated() const { return calibrated_; }
    bool healthy() const { return calibrated_ && bad_ < kSecond; }
    float pressure_pa() const;  // low-passed, zero removed
    float speed_mps() const;    // equivalent; a square root at each call
    float offset_v() const;

private:
    static constexpr uint16_t kSecond = 977;  // of 1024 us

    void setZero(float offset_v);
    void calibrate(uint16_t share, uint16_t passed, const AirspeedSettings& settings);
    void check(int32_t above, uint16_t share, uint16_t passed, bool either_tube);

    int32_t zero_ = 1L << 28;             // share of the supply in 2^-29
    int32_t above_ = 0;                   // the zero, low-passed; the same
    float ratio_ = 0;                     // of the last update
    uint16_t bad_ = 0, calibrating_ = 0;  // 1024 us
    uint8_t means_ = 0;
    bool calibrated_ = false;
    bool either_tube_ = false;
};

}  // namespace drivers

// SPDX-License-Identifier: GPL-3.0-or-later
// Height and climb rate: the accelerometers for what is quick, the barometer for what is slow; a
// third-order complementary filter, so that an accelerometer's bias leaves no trace in either.
#pragma once
#include <stdint.h>

namespace estimation {

struct HeightSettings {
    float omega_rads = 1.5f;  // where barometer and accelerometer meet; TECS_HGT_OMEGA
};

class Height {
public:
    static constexpr float kGlitch_m = 15.0f;  // a reading farther off than this is left out ...

    void start(float height_m);
    void resume(float height_m, float climb_mps) {
        start(height_m);
        climb_mps_ = climb_mps;
    }
    // Every frame: acceleration over ground, up positive, gravity removed.
    void propagate(float up_mss, float dt_s);
    // Every good reading, dt_s since the one before. A single reading far off is left out; when
    // they insist for half a second the filter follows.
    void useBarometer(float height_m, float dt_s, const HeightSettings& settings);

    float height_m() const { return height_m_; }
    float climb_mps() const { return climb_mps_; }
    bool healthy() const { return unfed_ms_ < 2000; }  // a reading was used within 2 s
    bool lastReadingFarOff() const { return off_ms_ > 0; }

private:
    float height_m_ = 0;
    float climb_mps_ = 0;
    float bias_mss_ = 0;
    uint16_t unfed_ms_ = UINT16_MAX;
    uint16_t off_ms_ = 0;  // readings have been far off for this long
};

}  // namespace estimation

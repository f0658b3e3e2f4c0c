// SPDX-License-Identifier: GPL-3.0-or-later
// What a pilot sets about guidance, each value in the unit of its parameter.
#pragma once
#include <stdint.h>

namespace navigation {

struct LateralSettings {  // NAVL1
    float period_s;       // _PERIOD
    float damping;        // _DAMPING
};

struct TakeoffSettings {           // TKOFF
    float throttle_min_speed_mps;  // _THR_MINSPD
    float throttle_min_accel_mss;  // _THR_MINACC
    float rotate_speed_mps;        // _ROTATE_SPD  0: rotate at once
    int8_t throttle_delay_ds;      // _THR_DELAY   0.1 s
    int8_t throttle_slew_pct;      // _THR_SLEW    percent a second, 0: as THR_SLEWRATE
    int8_t throttle_max_pct;       // _THR_MAX     0: as THR_MAX
};

struct LandingSettings {    // LAND
    float flare_height_m;   // _FLARE_ALT
    float flare_time_s;     // _FLARE_SEC
    int16_t pitch_cd;       // _PITCH_CD    lowest pitch in the flare
    int8_t disarm_delay_s;  // _DISARMDELAY
};

}  // namespace navigation

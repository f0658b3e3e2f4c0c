// SPDX-License-Identifier: GPL-3.0-or-later
// What a pilot sets about the control loops, each value in the unit of its parameter. The comment
// names the parameter; no default stands here.
#pragma once
#include <stdint.h>

namespace control {

// A loop from an angle to a surface: angle error over the time constant is the demanded rate.
struct AxisSettings {
    float time_constant_s;      // _TCONST
    float p;                    // _P     degrees of surface for a degree of angle
    float i;                    // _I
    float d;                    // _D
    int16_t integrator_max_cd;  // _IMAX  of surface, 4500 being all of it
};

struct RollSettings {  // RLL2SRV
    AxisSettings axis;
    int16_t rate_max_dps;  // _RMAX  0: no limit
};

struct PitchSettings {  // PTCH2SRV
    AxisSettings axis;
    int16_t rate_max_up_dps;    // _RMAX_UP  0: no limit
    int16_t rate_max_down_dps;  // _RMAX_DN  0: no limit
    float turn_compensation;    // _RLL
};

struct YawSettings {            // YAW2SRV
    float slip;                 // _SLIP
    float integral;             // _INT
    float damping;              // _DAMP
    float coordination;         // _RLL
    int16_t integrator_max_cd;  // _IMAX
};

struct SpeedHeightSettings {     // TECS
    float climb_max_mps;         // _CLMB_MAX    best climb at full throttle and cruise speed
    float sink_min_mps;          // _SINK_MIN    sink without throttle at cruise speed
    float sink_max_mps;          // _SINK_MAX    fastest descent ever asked for
    float time_constant_s;       // _TIME_CONST
    float land_time_constant_s;  // _LAND_TCONST
    float throttle_damping;      // _THR_DAMP
    float integral_gain;         // _INTEG_GAIN
    float vertical_accel_mss;    // _VERT_ACC
    float speed_omega_rads;      // _SPD_OMEGA
    float roll_to_throttle;      // _RLL2THR     m2/s3 for a unit of 1/cos2(bank) - 1
    float speed_weight;          // _SPDWEIGHT   0 height only .. 2 speed only
    float pitch_damping;         // _PTCH_DAMP
    float land_sink_mps;         // _LAND_SINK
};

}  // namespace control

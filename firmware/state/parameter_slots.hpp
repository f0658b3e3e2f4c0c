// SPDX-License-Identifier: GPL-3.0-or-later
// Eternal numbers of the parameters that other code names by them: stored missions do so. The table
// in parameters.cpp has its numbers from here.
#pragma once
#include <stdint.h>

namespace firmware {
namespace state {

namespace slot {

// clang-format off
enum : uint8_t {
    serial_force   = 5,
    rc1_min        = 30,  // then _TRIM, _MAX, _REV and _DZ, then RC2_MIN and so on
    rcmap_roll     = 70,  // then _PITCH, _THROTTLE and _YAW
    fltmode_ch     = 74,
    thr_fs_value   = 83,
    kff_rddrmix    = 86,
    rll2srv_p      = 102,
    rll2srv_i      = 103,
    rll2srv_d      = 104,
    rll2srv_imax   = 105,
    ptch2srv_p     = 108,
    ptch2srv_i     = 109,
    ptch2srv_d     = 110,
    ptch2srv_imax  = 111,
    ptch2srv_rll   = 114,
    yaw2srv_slip   = 115,
    yaw2srv_int    = 116,
    yaw2srv_damp   = 117,
    yaw2srv_imax   = 119,
    tecs_thr_damp  = 124,
    tecs_integ_gain = 125,
    tecs_spdweight = 129,
    tecs_ptch_damp = 130,
    navl1_damping  = 133,
    arspd_ratio    = 156,
    compass_ofs_x  = 158,
    ins_accoffs_x  = 162,
    ins_accscal_z  = 167,
    ahrs_trim_x    = 168,
    sign_policy    = 174,
    compass_mot_x  = 180,
    afs_term_action = 183,
    rudder_only    = 184,
    elevon_output  = 200,
    vtail_output   = 201,
    rc5_function   = 216,  // then RC6_, RC7_ and RC8_FUNCTION
    rc8_function   = 219,
};
// clang-format on

enum ChannelPart : uint8_t { min, trim, max, reverse, dead_zone, kChannelParts };

constexpr uint8_t ofChannel(uint8_t channel, ChannelPart part) {  // 1 to 8
    return static_cast<uint8_t>(rc1_min + (channel - 1) * kChannelParts + part);
}

// What a stranger on the radio could do the most harm with; nor does a mission set it.
constexpr bool isForUsbAlone(uint8_t number) {
    return number == serial_force || number == sign_policy || number == afs_term_action;
}

}  // namespace slot
}  // namespace state
}  // namespace firmware

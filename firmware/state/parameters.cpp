// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/parameters.hpp"

#include <math.h>

#include "board.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/name_pairs.hpp"
#include "firmware/state/parameter_file.hpp"
#include "firmware/state/parameter_host.hpp"
#include "firmware/state/parameter_slots.hpp"
#include "firmware/state/vehicle.hpp"
#include "parameters/store.hpp"
#include "storage/owner.hpp"

namespace firmware {
namespace state {

using namespace notify;

core::FileState<Parameters> parameters{};
core::FileState<ParameterChanges> parameter_changes{};

namespace {

#define P(slot, name, field, initial, lowest, highest) \
    PARAMETER(slot, name, Parameters, field, initial, lowest, highest)

// These two say how long a list is, and are not stored themselves.
constexpr uint8_t kFenceTotal = 231, kRallyTotal = 237;

// Five rows for channel n; flight channels have a dead zone.
#define CHANNEL(n, initial_dead_zone)                                                             \
    P(slot::ofChannel(n, slot::min), "RC" #n "_MIN", channel[n - 1].min_us, 1100, 800, 2200),     \
        P(slot::ofChannel(n, slot::trim), "RC" #n "_TRIM", channel[n - 1].trim_us, 1500, 800,     \
          2200),                                                                                  \
        P(slot::ofChannel(n, slot::max), "RC" #n "_MAX", channel[n - 1].max_us, 1900, 800, 2200), \
        P(slot::ofChannel(n, slot::reverse), "RC" #n "_REV", channel[n - 1].reverse, 1, -1, 1),   \
        P(slot::ofChannel(n, slot::dead_zone), "RC" #n "_DZ", channel[n - 1].dead_zone_us,        \
          initial_dead_zone, 0, 200)

// Seven rows for link n, slots 10 + 9 n onwards.
#define STREAMS(n)                                                                \
    P(10 + 9 * n, "SR" #n "_RAW_SENS", streams[n].raw_sensors, 1, 0, 50),         \
        P(11 + 9 * n, "SR" #n "_EXT_STAT", streams[n].extended_status, 1, 0, 50), \
        P(12 + 9 * n, "SR" #n "_RC_CHAN", streams[n].rc_channels, 1, 0, 50),      \
        P(14 + 9 * n, "SR" #n "_POSITION", streams[n].position, 1, 0, 50),        \
        P(15 + 9 * n, "SR" #n "_EXTRA1", streams[n].extra1, 1, 0, 50),            \
        P(16 + 9 * n, "SR" #n "_EXTRA2", streams[n].extra2, 1, 0, 50),            \
        P(17 + 9 * n, "SR" #n "_EXTRA3", streams[n].extra3, 1, 0, 50)

// clang-format off
constexpr parameters::Row kRows[] = {
    // slot  name                field                         initial   lowest   highest
    P(178, "FORMAT_VERSION",    format_version,                    1,       0,        1),
    P(  0, "SYSID_THISMAV",     system_id,                         1,       1,      255),
    P(  1, "SYSID_MYGCS",       ground_system_id,                255,       1,      255),
    P(  2, "SERIAL0_BAUD",      serial0_baud,                    115,       1,      115),
    P(  3, "SERIAL1_BAUD",      serial1_baud,                     57,       1,      115),
    P(  4, "SERIAL2_BAUD",      serial2_baud,                     57,       1,      115),
    STREAMS(0),
    STREAMS(1),
    CHANNEL(1, 30),
    CHANNEL(2, 30),
    CHANNEL(3, 30),
    CHANNEL(4, 30),
    CHANNEL(5, 0),
    CHANNEL(6, 0),
    CHANNEL(7, 0),
    CHANNEL(8, 0),
    P(slot::rc5_function, "RC5_FUNCTION",      output_function[0],                0,       0,       25),
    P(217, "RC6_FUNCTION",      output_function[1],                0,       0,       25),
    P(218, "RC7_FUNCTION",      output_function[2],                0,       0,       25),
    P(slot::rc8_function, "RC8_FUNCTION",      output_function[3],                0,       0,       25),
    P(193, "RC5_OPTION",        switch_option[0],                  0,       0,      255),
    P(194, "RC6_OPTION",        switch_option[1],                  0,       0,      255),
    P(195, "RC7_OPTION",        switch_option[2],                  0,       0,      255),
    P(196, "RC8_OPTION",        switch_option[3],                  0,       0,      255),
    P(227, "FLAP_IN_CHANNEL",   flap_channel,                      0,       0,        8),
    P(228, "FLAP_1_PERCNT",     flap[0].percent,                   0,       0,      100),
    P(229, "FLAP_1_SPEED",      flap[0].speed_mps,                 0,       0,      100),
    P(239, "FLAP_2_PERCNT",     flap[1].percent,                   0,       0,      100),
    P(241, "FLAP_2_SPEED",      flap[1].speed_mps,                 0,       0,      100),
    P(243, "LAND_FLAP_PERCNT",  land_flap_pct,                     0,       0,      100),
    P(242, "FLAP_SLEWRATE",     flap_slew_pct,                    75,       0,      100),
    P(slot::rcmap_roll, "RCMAP_ROLL",        map_roll,                          1,       1,        8),
    P( 71, "RCMAP_PITCH",       map_pitch,                         2,       1,        8),
    P( 72, "RCMAP_THROTTLE",    map_throttle,                      3,       1,        8),
    P( 73, "RCMAP_YAW",         map_yaw,                           4,       1,        8),
    P(slot::fltmode_ch, "FLTMODE_CH",        mode_channel,                      8,       1,        8),
    P( 75, "FLTMODE1",          switch_mode[0],                   11,       0,       16),
    P( 76, "FLTMODE2",          switch_mode[1],                   11,       0,       16),
    P( 77, "FLTMODE3",          switch_mode[2],                    5,       0,       16),
    P( 78, "FLTMODE4",          switch_mode[3],                    5,       0,       16),
    P( 79, "FLTMODE5",          switch_mode[4],                    0,       0,       16),
    P( 80, "FLTMODE6",          switch_mode[5],                    0,       0,       16),
    P( 81, "INITIAL_MODE",      initial_mode,                      0,       0,       16),
    P( 82, "THR_FAILSAFE",      throttle_failsafe,                 1,       0,        1),
    P(slot::thr_fs_value, "THR_FS_VALUE", throttle_failsafe_us,  950,     925,     1100),
    P( 84, "STICK_MIXING",      stick_mixing,                      1,       0,        2),
    P( 85, "THROTTLE_NUDGE",    throttle_nudge,                    1,       0,        1),
    P(slot::kff_rddrmix, "KFF_RDDRMIX", rudder_mix,             0.5f,       0,        1),
    P(slot::rudder_only, "RUDDER_ONLY", rudder_only,               0,       0,        1),
    P(slot::elevon_output, "ELEVON_OUTPUT",     elevon_output,                     0,       0,        4),
    P(slot::vtail_output, "VTAIL_OUTPUT",      vtail_output,                      0,       0,        4),
    P(202, "MIXING_GAIN",       mixing_gain,                    0.5f,    0.5f,     1.2f),
    P( 87, "LIM_ROLL_CD",       roll_limit_cd,                  4500,     500,     7500),
    P( 88, "LIM_PITCH_MAX",     pitch_max_cd,                   2000,     500,     4500),
    P( 89, "LIM_PITCH_MIN",     pitch_min_cd,                  -2500,   -4500,     -500),
    P( 90, "LEVEL_ROLL_LIMIT",  level_roll_limit_deg,              5,       0,       45),
    P( 91, "STAB_PITCH_DOWN",   pitch_down_deg,                    2,       0,       15),
    P( 92, "TRIM_PITCH_CD",     trim_pitch_cd,                     0,   -1500,     1500),
    P(177, "STALL_PREVENTION",  stall_prevention,                  1,       0,        1),
    P(221, "INVERTEDFLT_CH",    inverted_channel,                  0,       0,        8),
    P(244, "RST_SWITCH_CH",     reset_switch_channel,              0,       0,        8),
    P(245, "RST_MISSION_CH",    reset_mission_channel,             0,       0,        8),
    P(203, "ACRO_ROLL_RATE",    acro_roll_rate_dps,              180,      10,      500),
    P(204, "ACRO_PITCH_RATE",   acro_pitch_rate_dps,             180,      10,      500),
    P(205, "ACRO_LOCKING",      acro_locking,                      0,       0,        1),
    P(240, "AUTOTUNE_LEVEL",    autotune_level,                    6,       0,       10),
    P(206, "FBWB_CLIMB_RATE",   fbwb_climb_mps,                    2,       1,       10),
    P(207, "FBWB_ELEV_REV",     fbwb_elevator_reverse,             0,       0,        1),
    P(208, "ALT_HOLD_FBWCM",    fbwb_lowest_cm,                    0,       0,    32767),
    P( 93, "TRIM_ARSPD_CM",     cruise_speed_cms,               1300,     500,     5000),
    P( 94, "ARSPD_FBW_MIN",     speed_min_mps,                     9,       5,      100),
    P( 95, "ARSPD_FBW_MAX",     speed_max_mps,                    22,       5,      100),
    P(179, "MIN_GNDSPD_CM",     min_ground_speed_cms,            300,       0,     3000),
    P( 96, "SCALING_SPEED",     scaling_speed_mps,                15,       5,       50),
    P( 97, "TRIM_THROTTLE",     cruise_throttle_pct,              45,       0,      100),
    P( 98, "THR_MIN",           throttle_min_pct,                  0,       0,      100),
    P( 99, "THR_MAX",           throttle_max_pct,                100,      10,      100),
    P(100, "THR_SLEWRATE",      throttle_slew_pct,               100,       0,      127),
    P(101, "RLL2SRV_TCONST",    roll.axis.time_constant_s,      0.4f,    0.2f,        2),
    P(slot::rll2srv_p, "RLL2SRV_P", roll.axis.p,               0.75f,       0,        4),
    P(slot::rll2srv_i, "RLL2SRV_I", roll.axis.i,               0.04f,       0,        1),
    P(slot::rll2srv_d, "RLL2SRV_D", roll.axis.d,               0.03f,       0,     0.2f),
    P(slot::rll2srv_imax, "RLL2SRV_IMAX", roll.axis.integrator_max_cd, 3000,       0,     4500),
    P(106, "RLL2SRV_RMAX",      roll.rate_max_dps,                 0,       0,      180),
    P(107, "PTCH2SRV_TCONST",   pitch.axis.time_constant_s,     0.4f,    0.2f,        2),
    P(slot::ptch2srv_p, "PTCH2SRV_P", pitch.axis.p,                1,       0,        4),
    P(slot::ptch2srv_i, "PTCH2SRV_I", pitch.axis.i,             0.3f,       0,        1),
    P(slot::ptch2srv_d, "PTCH2SRV_D", pitch.axis.d,            0.05f,       0,     0.2f),
    P(slot::ptch2srv_imax, "PTCH2SRV_IMAX", pitch.axis.integrator_max_cd, 3000,       0,     4500),
    P(112, "PTCH2SRV_RMAX_UP",  pitch.rate_max_up_dps,             0,       0,      100),
    P(113, "PTCH2SRV_RMAX_DN",  pitch.rate_max_down_dps,           0,       0,      100),
    P(slot::ptch2srv_rll, "PTCH2SRV_RLL", pitch.turn_compensation, 1,    0.5f,     1.5f),
    P(slot::yaw2srv_slip, "YAW2SRV_SLIP", yaw.slip,                          0,       0,        4),
    P(slot::yaw2srv_int, "YAW2SRV_INT", yaw.integral,              0,       0,        2),
    P(slot::yaw2srv_damp, "YAW2SRV_DAMP", yaw.damping,          0.2f,       0,        2),
    P(118, "YAW2SRV_RLL",       yaw.coordination,                  1,    0.5f,     1.5f),
    P(slot::yaw2srv_imax, "YAW2SRV_IMAX", yaw.integrator_max_cd, 1500,       0,     4500),
    P(120, "TECS_CLMB_MAX",     speed_height.climb_max_mps,        4,    0.1f,       20),
    P(121, "TECS_SINK_MIN",     speed_height.sink_min_mps,      1.3f,    0.1f,       10),
    P(122, "TECS_SINK_MAX",     speed_height.sink_max_mps,         3,    0.1f,       20),
    P(123, "TECS_TIME_CONST",   speed_height.time_constant_s,   1.2f,       1,       10),
    P(197, "TECS_LAND_TCONST",  speed_height.land_time_constant_s, 1.8f,    1,       10),
    P(slot::tecs_thr_damp, "TECS_THR_DAMP", speed_height.throttle_damping, 0.7f,       0,        2),
    P(slot::tecs_integ_gain, "TECS_INTEG_GAIN", speed_height.integral_gain, 0.3f,       0,     0.5f),
    P(126, "TECS_VERT_ACC",     speed_height.vertical_accel_mss,   7,       1,       10),
    P(127, "TECS_SPD_OMEGA",    speed_height.speed_omega_rads,     3,    0.5f,        5),
    P(128, "TECS_RLL2THR",      speed_height.roll_to_throttle,    10,       0,       40),
    P(slot::tecs_spdweight, "TECS_SPDWEIGHT", speed_height.speed_weight,      0.5f,       0,        2),
    P(slot::tecs_ptch_damp, "TECS_PTCH_DAMP", speed_height.pitch_damping, 0.5f,       0,        2),
    P(131, "TECS_LAND_SINK",    speed_height.land_sink_mps,    0.6f,        0,        2),
    P(132, "NAVL1_PERIOD",      lateral.period_s,                  5,       1,       60),
    P(slot::navl1_damping, "NAVL1_DAMPING", lateral.damping,   0.75f,    0.6f,        1),
    P(134, "WP_RADIUS",         waypoint_radius_m,                30,       1,    32767),
    P(135, "WP_LOITER_RAD",     loiter_radius_m,                  60,  -32767,    32767),
    P(136, "ALT_HOLD_RTL",      rtl_height_cm,                 10000,      -1,   100000),
    P(211, "RTL_AUTOLAND",      rtl_landing,                       0,       0,        2),
    P(209, "GLIDE_SLOPE_MIN",   glide_slope_min_m,                 0,       0,     1000),
    P(226, "GLIDE_SLOPE_THR",   glide_slope_threshold_m,          15,       0,      100),
    P(  9, "TKOFF_ALT",         takeoff_height_m,                 50,      10,      200),
    P( 28, "TKOFF_LVL_PITCH",   takeoff_level_pitch_deg,          15,       0,       30),
    P(137, "TKOFF_THR_MAX",     takeoff_throttle_max_pct,        100,       0,      100),
    P(138, "TKOFF_THR_MINSPD",  takeoff_min_speed_mps,             0,       0,       30),
    P(139, "TKOFF_THR_MINACC",  takeoff_min_accel_mss,             0,       0,       30),
    P(140, "TKOFF_THR_DELAY",   takeoff_delay_ds,                  2,       0,      127),
    P(141, "TKOFF_ROTATE_SPD",  takeoff_rotate_mps,                0,       0,       30),
    P(210, "THR_SUPP_MAN",      suppressed_manual,                 0,       0,        1),
    P(142, "LAND_PITCH_CD",     land_pitch_cd,                     0,   -1500,     2000),
    P(143, "LAND_FLARE_ALT",    flare_height_m,                 1.5f,       0,       30),
    P(144, "LAND_FLARE_SEC",    flare_s,                        1.5f,       0,       10),
    P(145, "LAND_DISARMDELAY",  land_disarm_delay_s,              10,       0,      127),
    P(slot::afs_term_action, "AFS_TERM_ACTION", termination_action, 0,      0,       42),
    P(146, "FS_SHORT_ACTN",     short_action,                      0,       0,        2),
    P(147, "FS_LONG_ACTN",      long_action,                       0,       0,        2),
    P(148, "FS_LONG_TIMEOUT",   long_timeout_s,                    5,       1,      300),
    P(190, "FS_GCS_ENABL",      ground_failsafe,                   0,       0,        1),
    P(191, "FS_BATT_VOLTAGE",   battery_low_v,                     0,       0,       60),
    P(192, "FS_BATT_MAH",       battery_low_mah,                   0,       0,    32000),
    P(149, "ARMING_CHECK",      arming_check,                      1,       0,    32767),
    P(185, "ARMING_RUDDER",     arming_rudder,                     1,       0,        2),
    P(slot::serial_force, "SERIAL_FORCE", force_everywhere,        0,       0,        1),
    P(slot::sign_policy, "SIGN_POLICY", sign_policy,               1,       0,        2),
    P(212, "CAM_TRIGG_TYPE",    camera_on_relay,                   0,       0,        1),
    P(213, "CAM_DURATION",      camera_duration_ds,               10,       0,       50),
    P(214, "CAM_SERVO_ON",      camera_on_us,                   1300,    1000,     2000),
    P(215, "CAM_SERVO_OFF",     camera_off_us,                  1100,    1000,     2000),
    P(230, "FENCE_ACTION",      fence_action,                      0,       0,        3),
    P(kFenceTotal, "FENCE_TOTAL", fence_total,                     0,       0,       20),
    P(232, "FENCE_CHANNEL",     fence_channel,                     0,       0,        8),
    P(233, "FENCE_MINALT",      fence_min_m,                       0,       0,    32767),
    P(234, "FENCE_MAXALT",      fence_max_m,                       0,       0,    32767),
    P(235, "FENCE_RETALT",      fence_return_m,                    0,       0,    32767),
    P(236, "FENCE_AUTOENABLE",  fence_auto_enable,                 0,       0,        1),
    P(kRallyTotal, "RALLY_TOTAL", rally_total,                     0,       0,       10),
    P(238, "RALLY_LIMIT_KM",    rally_limit_km,                 0.3f,       0,      100),
    P(150, "MIS_RESTART",       mission_restart,                   0,       0,        1),
    P(151, "MIS_TRAILING",      mission_trailing,                  0,       0,        1),
    P(152, "MIS_SET",           mission_set,                       2,       1,        2),
    P(153, "ALT_ABS",           altitude_absolute,                 0,       0,        1),
    P(154, "ARSPD_ENABLE",      airspeed_enable,                   1,       0,        1),
    P(155, "ARSPD_USE",         airspeed_use,                      1,       0,        1),
    P(187, "ARSPD_AUTOCAL",     airspeed_autocal,                  1,       0,        1),
    P(slot::arspd_ratio, "ARSPD_RATIO", airspeed_ratio,          1.9936f,       1,        4),
    P(225, "GPS_TYPE",          gps_type,                          1,       0,        5),
    P(  8, "GPS_DELAY_MS",      gps_delay_ms,                      0,       0,      500),
    P(157, "COMPASS_USE",       compass_use,                       1,       0,        1),
    P(slot::compass_ofs_x, "COMPASS_OFS_X", compass.offset_mg[0],  0,    -400,      400),
    P(159, "COMPASS_OFS_Y",     compass.offset_mg[1],              0,    -400,      400),
    P(160, "COMPASS_OFS_Z",     compass.offset_mg[2],              0,    -400,      400),
    P(slot::compass_mot_x, "COMPASS_MOT_X", compass.motor_mg[0],   0,    -200,      200),
    P(181, "COMPASS_MOT_Y",     compass.motor_mg[1],               0,    -200,      200),
    P(182, "COMPASS_MOT_Z",     compass.motor_mg[2],               0,    -200,      200),
    P(161, "COMPASS_DEC",       compass_declination_rad,           0, -3.142f,   3.142f),
    P(175, "COMPASS_AUTODEC",   compass_auto_declination,          1,       0,        1),
    P(186, "COMPASS_LEARN",     compass_learn,                     1,       0,        1),
    P(  6, "COMPASS_EXTERNAL",  compass_external,                  0,       0,        1),
    P(  7, "COMPASS_ORIENT",    compass_orientation,               0,       0,       37),
    P(slot::ins_accoffs_x, "INS_ACCOFFS_X", accel_offset_mss[0],   0,    -3.5f,    3.5f),
    P(163, "INS_ACCOFFS_Y",     accel_offset_mss[1],               0,    -3.5f,    3.5f),
    P(164, "INS_ACCOFFS_Z",     accel_offset_mss[2],               0,    -3.5f,    3.5f),
    P(165, "INS_ACCSCAL_X",     accel_scale[0],                    1,    0.8f,     1.2f),
    P(166, "INS_ACCSCAL_Y",     accel_scale[1],                    1,    0.8f,     1.2f),
    P(slot::ins_accscal_z, "INS_ACCSCAL_Z", accel_scale[2],        1,    0.8f,     1.2f),
    P(slot::ahrs_trim_x, "AHRS_TRIM_X", level_trim_rad[0],         0, -0.1745f,  0.1745f),
    P(169, "AHRS_TRIM_Y",       level_trim_rad[1],                 0, -0.1745f,  0.1745f),
    P(170, "BATT_MONITOR",      battery_monitor,                   4,       0,        4),
    P(171, "BATT_VOLT_MULT",    battery_volt_multiplier,       10.1f,       0,      100),
    P(172, "BATT_AMP_PERVOLT",  battery_amps_per_volt,            17,       0,      200),
    P(176, "BATT_AMP_OFFSET",   battery_amps_offset_v,             0,       0,        5),
    P(173, "BATT_CAPACITY",     battery_capacity_mah,           3300,       0,    60000),
    P( 29, "BRD_LOADER_MS",     loader_ms,         board::kLoader_ms,       0,     2900),
    P(220, "LOG_BITMASK",       log_bitmask,                   16382,       0,  1048575),
};
// clang-format on

// Slots of parameters that are gone. Boards have stored values there: never to be used again.
constexpr uint8_t kRetired[] = {
    13, 22,  // SR0_RAW_CTRL, SR1_RAW_CTRL
    18, 27,  // SR0_PARAMS, SR1_PARAMS
};
constexpr uint16_t kNextSlot = 188;  // the lowest free one, for the next parameter

#undef P
#undef CHANNEL
#undef STREAMS

static_assert(core::count(kRows) <= parameters::kMaxRows, "more rows than the store knows");
static_assert(parameters::slotsAreUnique(kRows), "a slot is used twice");
static_assert(parameters::slotsAvoid(kRows, kRetired), "a slot was another parameter's once");
static_assert(parameters::lowestFreeSlot(kRows, kRetired) == kNextSlot, "kNextSlot: try the next");
static_assert(parameters::initialsAreInRange(kRows), "a default lies outside its range");

static_assert(sizeof(Parameters) <= 1 << parameters::kOffsetBits, "an offset has too few bits");

static_assert(core::pairsDeep(kNamePairs) <= core::kPairsDeep, "an Unpacker has no room");

constexpr parameters::Packed<core::count(kRows), parameters::distinctNumbers(kRows),
                             parameters::nameCodes(kRows, kNamePairs), core::count(kNamePairs)>
    kPacked ROM(kRows, kNamePairs);
constexpr parameters::Table table ROM(kPacked, &firmware::state::parameters);

constexpr uint8_t kFormatRow = 0;
static_assert(parameters::same(kRows[kFormatRow].name, "FORMAT_VERSION"), "the row of the format");

enum class Store : uint8_t {
    ours,
    foreign,  // another firmware's: neither read nor written
    forgetting,
    erasing,
    trusting,  // as they are
};
struct Background {
    Store store;
    uint16_t done;  // so far, of forgetting or erasing
};
core::FileState<Background> background{};

// The format goes last, through the journal: after a cut on the way the next start goes on.
core::Status forget() {
    for (; background.done + 1 < table.count(); ++background.done) {
        const core::Status status =
            parameters::forget(table, static_cast<uint8_t>(background.done + 1));
        if (status != core::Status::ok) return status;
    }
    if (background.done < table.count()) {
        const core::Status trusted = parameters::trust();
        if (trusted != core::Status::ok) return trusted;
        ++background.done;
    }
    return parameters::save(table, kFormatRow, NAN);
}

void runForgetting() {
    if (forget() != core::Status::ok) return;
    background.store = Store::ours;
    sendStatusText(Severity::notice, STATUS_TEXT("All parameters are the defaults"));
}

void runErasing() {
    if (storage::erase(background.done) != core::Status::ok) return;
    parameters::erased();
    background.store = Store::ours;
    sendStatusText(Severity::notice, STATUS_TEXT("Erased: restart the board"));
}

void runTrusting() {
    if (parameters::trust() == core::Status::ok) background.store = Store::ours;
}

void reportFound() {
    if (parameters::found() == parameters::Found::mended)
        sendStatusText(Severity::error, STATUS_TEXT("Memory fault: parameters mended"));
    if (parameters::found() == parameters::Found::damaged)
        sendStatusText(Severity::critical, STATUS_TEXT("Memory fault: check all parameters"));
}

// What is counted of a list that is stored is not set.
bool isListLength(uint8_t row) {
    const uint8_t number = table.slot(row);
    return number == kFenceTotal || number == kRallyTotal;
}

void assignInitials() {
    for (uint8_t row = 0; row < table.count(); ++row) table.assignInitial(row);
}

void assign(uint8_t row, float value) {
    table.assign(row, value);
    ++parameter_changes.count;
}

bool isOfChannel(uint8_t number) {
    return number >= slot::rc1_min && number <= slot::ofChannel(8, slot::dead_zone);
}
uint8_t channelPart(uint8_t number) {
    return static_cast<uint8_t>(number - slot::rc1_min) % slot::kChannelParts;
}
bool isReverse(uint8_t number) {  // RCn_REV
    return isOfChannel(number) && channelPart(number) == slot::reverse;
}

// A stick has both of its ways. The throttle's centre is its closed end for many ground stations.
bool hasBothWays(uint8_t number, float value) {
    if (!isOfChannel(number)) return true;
    const uint8_t part = channelPart(number);
    if (part > slot::max) return true;
    const uint8_t channel = static_cast<uint8_t>(number - slot::rc1_min) / slot::kChannelParts;
    Channel to_be = firmware::state::parameters.channel[channel];
    int16_t* const parts[] = {&to_be.min_us, &to_be.trim_us, &to_be.max_us};
    *parts[part] = static_cast<int16_t>(core::rounded(value));
    const bool throttle = channel + 1 == firmware::state::parameters.map_throttle;
    return to_be.min_us < to_be.trim_us + throttle && to_be.trim_us < to_be.max_us;
}

// In range, and not without a meaning or a danger.
bool takes(uint8_t row, float value) {
    constexpr uint8_t kFirstMode = 75, kLastMode = 81;  // slots of FLTMODE1 .. INITIAL_MODE
    if (!table.fits(row, value)) return false;
    // a restart in the air must find the values it had
    if (row == kFormatRow) return !vehicle.armed;
    const uint8_t number = table.slot(row);
    // rounded where it is needed: a mission may set a dozen in one step
    const auto whole = [value] { return core::rounded(value); };
    if (number >= kFirstMode && number <= kLastMode) return isMode(static_cast<uint8_t>(whole()));
    if (number >= slot::rc5_function && number <= slot::rc8_function)
        return parameter_host.isOutputFunction(static_cast<int8_t>(whole()));
    return !isReverse(number) || whole() != 0;
}

// An output that nothing drives but a mission and its pilot, and no stick: what its pulses are is
// what the mission commands CHANNEL_TRIM, CHANNEL_MAX and CHANNEL_MIN are for.
bool isEndOfFreeChannel(uint8_t number) {
    if (!isOfChannel(number) || channelPart(number) > slot::max) return false;
    const auto& in_use = firmware::state::parameters;
    const uint8_t channel = static_cast<uint8_t>(number - slot::rc1_min) / slot::kChannelParts;
    if (channel < 4 || in_use.output_function[channel - 4] != 0) return false;
    for (uint8_t stick = 0; stick < 4; ++stick)
        if ((&in_use.map_roll)[stick] == channel + 1) return false;
    return true;
}

// What a stick, a servo or an accelerometer means: another value turns the airplane over within
// seconds.
bool isRigging(uint8_t number) {
    struct Range {
        uint8_t first, last;
    };
    static constexpr Range kRigging[] ROM = {
        {slot::rc1_min, slot::ofChannel(8, slot::dead_zone)},
        {slot::rcmap_roll, slot::fltmode_ch},
        {slot::elevon_output, slot::vtail_output},
        {slot::rc5_function, slot::rc8_function},
        {slot::rudder_only, slot::rudder_only},
        {slot::ins_accoffs_x, slot::ins_accscal_z},
    };
    for (const Range& range : kRigging)
        if (number >= core::romRead(range.first) && number <= core::romRead(range.last))
            return true;
    return false;
}

core::Status maySet(uint8_t number, float value) {
    if (vehicle.armed && isRigging(number) && !isEndOfFreeChannel(number))
        return core::Status::denied;
    return hasBothWays(number, value) ? core::Status::ok : core::Status::bad_argument;
}

}  // namespace

float speedMin_mps() { return core::real(parameters.speed_min_mps); }
float speedMax_mps() { return core::real(parameters.speed_max_mps); }

uint16_t parameterCount() { return table.count(); }

bool parameterAt(uint16_t index, char (&name)[16], float& value, uint8_t& mav_type) {
    if (index >= table.count()) return false;
    const uint8_t row = static_cast<uint8_t>(index);
    table.name(row, name);
    value = table.value(row);
    mav_type = static_cast<uint8_t>(table.type(row));
    return true;
}

bool parameterFind(const char (&name)[16], uint16_t& index) {
    uint8_t row;
    if (!table.findName(name, row)) return false;
    index = row;
    return true;
}

bool parameterLimits(uint16_t index, ParameterLimits& limits) {
    if (index >= table.count()) return false;
    const uint8_t row = static_cast<uint8_t>(index);
    limits = {table.initial(row), table.lowest(row), table.highest(row), !isListLength(row)};
    return true;
}

core::Status parameterSetAt(uint16_t index, float value) {
    if (index >= table.count()) return core::Status::bad_argument;
    const uint8_t row = static_cast<uint8_t>(index);
    if (!takes(row, value)) return core::Status::bad_argument;
    const core::Status status = maySet(table.slot(row), value);
    if (status != core::Status::ok) return status;
    if (isListLength(row)) return core::Status::unsupported;
    if (background.store == Store::foreign) {
        sendStatusText(Severity::warning, STATUS_TEXT("Not stored: another firmware's EEPROM"));
    } else {
        if (background.store != Store::ours) return core::Status::busy;
        const core::Status saved = parameters::save(table, row, value);
        if (saved != core::Status::ok) return saved;
    }
    assign(row, value);
    return core::Status::ok;
}

uint16_t parameterFileSize() {
    constexpr uint16_t kSize = parameters::fileSize(kRows);
    return kSize;
}

core::Status parameterFileRead(parameters::FileCursor& cursor, uint16_t offset, uint8_t* to,
                               uint8_t& size) {
    return parameters::readFile(table, cursor, offset, to, size);
}

uint8_t parameterSlot(uint16_t index) { return table.slot(static_cast<uint8_t>(index)); }

bool parameterOfSlot(uint8_t slot, uint16_t& index) {
    uint8_t row;
    if (!table.findSlot(slot, row)) return false;
    index = row;
    return true;
}

bool parameterGet(uint8_t slot, float& value) {
    uint8_t row;
    if (!table.findSlot(slot, row)) return false;
    value = table.value(row);
    return true;
}

// One search, as a mission sets a dozen in a row. Whoever uploads a mission may not grant himself
// what only USB may.
static bool findTaker(uint8_t slot, float value, uint8_t& row) {
    return !slot::isForUsbAlone(slot) && table.findSlot(slot, row) && !isListLength(row) &&
           takes(row, value);
}

bool parameterSlotTakes(uint8_t slot, float value) {
    uint8_t row;
    return findTaker(slot, value, row);
}

bool parameterSet(uint8_t slot, float value) {
    uint8_t row;
    if (!findTaker(slot, value, row) || maySet(slot, value) != core::Status::ok) return false;
    assign(row, value);
    parameters::saveLater(row);
    return true;
}

core::Status parametersLoad() {
    ++parameter_changes.count;
    storage::Owner owner;
    core::Status status = storage::findOwner(owner);
    if (status != core::Status::ok) return status;
    // what another firmware left is not read as ours, and not written over unless asked for
    if (owner == storage::Owner::foreign || owner == storage::Owner::other_version) {
        background.store = Store::foreign;
        assignInitials();
        return core::Status::ok;
    }
    status = parameters::load(table);
    if (status != core::Status::ok) return status;
    background.store = Store::ours;
    if (firmware::state::parameters.format_version != 0) {
        reportFound();
        return core::Status::ok;
    }
    background.store = Store::forgetting;
    background.done = 0;
    assignInitials();
    return core::Status::ok;
}

void parametersRun() {
    switch (background.store) {
        case Store::ours:
            if (parameters::takeWorn())
                sendStatusText(Severity::error,
                               STATUS_TEXT("EEPROM is worn: a parameter is at risk"));
            return parameters::saveWaiting(table);
        case Store::forgetting:
            return runForgetting();
        case Store::erasing:
            return runErasing();
        case Store::trusting:
            return runTrusting();
        case Store::foreign:
            return;
    }
}

bool parametersForeign() { return background.store == Store::foreign; }
bool parametersDamaged() { return parameters::found() == parameters::Found::damaged; }

bool parametersAccept() {
    if (!parametersDamaged()) return true;
    if (vehicle.armed) return false;
    background.store = Store::trusting;
    return true;
}

bool parametersReset() {
    if (vehicle.armed) return false;
    if (background.store == Store::foreign) return parametersErase();
    if (background.store != Store::ours) return false;
    assign(kFormatRow, 0);
    if (parameters::save(table, kFormatRow, 0) != core::Status::ok)
        parameters::saveLater(kFormatRow);
    sendStatusText(Severity::notice, STATUS_TEXT("Parameters: the defaults after a restart"));
    return true;
}

bool parametersErase() {
    if (vehicle.armed) return false;
    background.store = Store::erasing;
    background.done = 0;
    return true;
}

bool parametersSetFrom(uint8_t slot, const float* values, uint8_t count) {
    for (uint8_t i = 0; i < count; ++i)
        if (!parameterSlotTakes(static_cast<uint8_t>(slot + i), values[i])) return false;
    for (uint8_t i = 0; i < count; ++i) parameterSet(static_cast<uint8_t>(slot + i), values[i]);
    return true;
}

}  // namespace state
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters in RAM: one field each, named as the ground station names it. The rows that join
// field, name, range and stored slot are in parameters.cpp.
#pragma once
#include <stdint.h>

#include "control/settings.hpp"
#include "core/file_state.hpp"
#include "core/status.hpp"
#include "navigation/settings.hpp"

namespace firmware {
namespace state {

struct Channel {  // RCn_: one number for the stick that comes in and the servo that goes out
    int16_t min_us, trim_us, max_us;
    int8_t reverse;  // 1 or -1
    int16_t dead_zone_us;
};

struct StreamRates {  // SRn_, hertz
    int8_t raw_sensors, extended_status, rc_channels, position, extra1, extra2, extra3;
};
constexpr uint8_t kLinks = 2;

// Added to what the compass reads; body axes.
struct CompassCorrection {
    float offset_mg[3];
    float motor_mg[3];  // at full throttle
};

struct Parameters {
    int8_t format_version;  // 0: forget every stored value at the next start
    // ground link
    int16_t system_id, ground_system_id;
    int16_t serial0_baud, serial1_baud, serial2_baud;  // thousands
    StreamRates streams[kLinks];
    // radio and servos
    Channel channel[8];
    int8_t output_function[4];  // RC5_FUNCTION to RC8_FUNCTION: a k...Function of outputs.hpp
    int16_t switch_option[4];   // RC5_OPTION to RC8_OPTION: a function of gcs/commands_aux.cpp
    int8_t flap_channel;        // FLAP_IN_CHANNEL
    int8_t flap_slew_pct;
    struct {
        int8_t percent, speed_mps;
    } flap[2];  // FLAP_1_, FLAP_2_
    int8_t land_flap_pct;
    int8_t map_roll, map_pitch, map_throttle, map_yaw;  // RCMAP_: 1..8
    int8_t mode_channel;
    int8_t switch_mode[6];
    int8_t initial_mode;
    int8_t throttle_failsafe;
    int16_t throttle_failsafe_us;
    int8_t stick_mixing, throttle_nudge;
    float rudder_mix;
    int8_t rudder_only;                  // it has no ailerons
    int8_t elevon_output, vtail_output;  // ::control::Pair
    float mixing_gain;
    // limits
    int16_t roll_limit_cd, pitch_max_cd, pitch_min_cd;
    float level_roll_limit_deg;
    float pitch_down_deg;  // STAB_PITCH_DOWN
    int16_t trim_pitch_cd;
    int8_t stall_prevention;
    // modes
    int8_t inverted_channel;  // INVERTEDFLT_CH
    int8_t reset_switch_channel, reset_mission_channel;
    int16_t acro_roll_rate_dps, acro_pitch_rate_dps;
    int8_t acro_locking;
    int8_t autotune_level;
    float fbwb_climb_mps;
    int8_t fbwb_elevator_reverse;
    int16_t fbwb_lowest_cm;  // ALT_HOLD_FBWCM
    // speed and throttle
    int16_t cruise_speed_cms;             // TRIM_ARSPD_CM
    int8_t speed_min_mps, speed_max_mps;  // ARSPD_FBW_
    int16_t min_ground_speed_cms;         // MIN_GNDSPD_CM
    float scaling_speed_mps;
    int8_t cruise_throttle_pct, throttle_min_pct, throttle_max_pct, throttle_slew_pct;
    // control loops
    ::control::RollSettings roll;                 // RLL2SRV_
    ::control::PitchSettings pitch;               // PTCH2SRV_
    ::control::YawSettings yaw;                   // YAW2SRV_
    ::control::SpeedHeightSettings speed_height;  // TECS_
    // navigation
    navigation::LateralSettings lateral;  // NAVL1_
    int16_t waypoint_radius_m, loiter_radius_m;
    int32_t rtl_height_cm;
    int8_t rtl_landing;  // RTL_AUTOLAND
    int16_t glide_slope_min_m;
    int8_t glide_slope_threshold_m;  // GLIDE_SLOPE_THR
    // take-off and landing
    int16_t takeoff_height_m;        // TKOFF_ALT: of the mode TAKEOFF
    int8_t takeoff_level_pitch_deg;  // TKOFF_LVL_PITCH
    int8_t takeoff_throttle_max_pct;
    int8_t suppressed_manual;  // THR_SUPP_MAN
    float takeoff_min_speed_mps, takeoff_min_accel_mss;
    int8_t takeoff_delay_ds;  // 0.1 s
    float takeoff_rotate_mps;
    int16_t land_pitch_cd;
    float flare_height_m, flare_s;
    int8_t land_disarm_delay_s;
    int8_t termination_action;  // 42: MAV_CMD_DO_FLIGHTTERMINATION is carried out
    // failsafes and arming
    int8_t short_action, long_action;
    float long_timeout_s;
    int8_t ground_failsafe;  // FS_GCS_ENABL
    float battery_low_v;
    int16_t battery_low_mah;  // left in the pack
    int16_t arming_check;
    int8_t arming_rudder;
    int8_t force_everywhere;  // SERIAL_FORCE
    int8_t sign_policy;       // SIGN_POLICY
    // mission
    int8_t mission_restart, mission_trailing, mission_set, altitude_absolute;
    // log
    int32_t log_bitmask;
    // sensors
    int8_t airspeed_enable, airspeed_use, airspeed_autocal;
    float airspeed_ratio;
    int8_t gps_type;
    int16_t gps_delay_ms;  // 0: by the receiver, and learnt in turns
    int8_t compass_use, compass_auto_declination, compass_learn;
    int8_t compass_external, compass_orientation;  // orientation: drivers/orientation.hpp
    CompassCorrection compass;
    float compass_declination_rad;  // the table's while compass_auto_declination is 1
    float accel_offset_mss[3], accel_scale[3];
    float level_trim_rad[2];  // AHRS_TRIM_X, _Y
    int8_t battery_monitor;
    float battery_volt_multiplier, battery_amps_per_volt, battery_amps_offset_v;
    int32_t battery_capacity_mah;

    int16_t loader_ms;  // from a reset to the first instruction, unless the watchdog made it
    // camera
    int8_t camera_on_relay, camera_duration_ds;
    int16_t camera_on_us, camera_off_us;
    // fence and rally points
    int8_t fence_action, fence_channel, fence_auto_enable;
    int16_t fence_min_m, fence_max_m, fence_return_m;  // above home
    float rally_limit_km;
    int8_t fence_total, rally_total;  // points that are stored
};
extern core::FileState<Parameters> parameters;

// As floats, in the many places that compare or calculate with them; ARSPD_FBW_MIN and _MAX.
float speedMin_mps();
float speedMax_mps();

struct ParameterChanges {
    uint8_t count;  // of what was set since the start, wraps
};
extern core::FileState<ParameterChanges> parameter_changes;

// For what is worked out of parameters again when one has changed: true then, and at first.
class ParameterWatch {
public:
    bool changed() {
        const uint16_t now = static_cast<uint16_t>(parameter_changes.count + 1);
        if (seen_ == now) return false;
        seen_ = now;
        return true;
    }

private:
    uint16_t seen_ = 0;  // 0: nothing yet
};

constexpr uint16_t kNoParameter = 0xFFFF;

// The table, by index 0 .. parameterCount() - 1 in a fixed order.
uint16_t parameterCount();
// MAV_PARAM_TYPE 2 int8, 4 int16, 6 int32, 9 real32; the name is padded with zeros.
bool parameterAt(uint16_t index, char (&name)[16], float& value, uint8_t& mav_type);
bool parameterFind(const char (&name)[16], uint16_t& index);
struct ParameterLimits {
    float initial, lowest, highest;
    bool stored;  // false: the length of a list, which is stored with the list
};
bool parameterLimits(uint16_t index, ParameterLimits& limits);

// Sets, rounds to the field's type and stores. bad_argument: no such index, not finite, out of
// range, without a meaning, or RCn_MIN, _TRIM and _MAX would not ascend (but RCn_TRIM of the
// throttle, which may be RCn_MIN), nothing changed. denied: while armed not for what sticks, servos
// and accelerometers mean (RCn_, RCMAP_, FLTMODE_CH, ELEVON_OUTPUT, VTAIL_OUTPUT, INS_ACC), nothing
// changed. busy: the store has no room yet, nothing changed: ask again later.
MUST_USE core::Status parameterSetAt(uint16_t index, float value);

// The same by the eternal slot number, as stored missions name a parameter.
uint8_t parameterSlot(uint16_t index);  // below parameterCount()
bool parameterOfSlot(uint8_t slot, uint16_t& index);
bool parameterGet(uint8_t slot, float& value);
// Exists, is not SERIAL_FORCE or SIGN_POLICY, and the value is in its range.
bool parameterSlotTakes(uint8_t slot, float value);
// For missions and what the firmware finds out by itself; stored in the background. False: refused,
// as parameterSetAt and parameterSlotTakes do.
bool parameterSet(uint8_t slot, float value);
// From this slot on. False: a value is none for its parameter, nothing was stored.
bool parametersSetFrom(uint8_t slot, const float* values, uint8_t count);

MUST_USE core::Status parametersLoad();  // at boot, a part each call: busy until all are read
void parametersRun();                    // 10 Hz: background stores

bool parametersForeign();  // the EEPROM is another firmware's: all of them are the defaults
bool parametersDamaged();  // more of them has changed by itself than could be mended
// Takes damaged ones for right as they are. False: armed.
bool parametersAccept();

// Lets the next start forget every stored value; the mission stays. False: armed, or the last such
// work is not done yet.
bool parametersReset();
// Begins to erase the whole EEPROM, parameters and mission, ours or another firmware's; reported
// when done, in force after a restart. False: armed.
bool parametersErase();

}  // namespace state
}  // namespace firmware

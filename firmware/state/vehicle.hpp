// SPDX-License-Identifier: GPL-3.0-or-later
// What the rooms of the flight program share. A section is written by the file named above it and
// read by everyone; docs/architecture.md lists what has a second writer.
#pragma once
#include <stdint.h>

#include "core/fixed.hpp"
#include "core/maths.hpp"
#include "estimation/motion.hpp"
#include "geo/position.hpp"
#include "hal/rc_input.hpp"
#include "hal/servo_output.hpp"

namespace firmware {
namespace state {

// MAVLink custom_mode numbers of ArduPlane.
enum class Mode : uint8_t {
    manual = 0,
    circle = 1,
    stabilize = 2,
    training = 3,
    acro = 4,
    fbwa = 5,
    fbwb = 6,
    cruise = 7,
    autotune = 8,
    automatic = 10,  // AUTO
    rtl = 11,
    loiter = 12,
    guided = 15,
    initialising = 16,
};

enum class GpsFix : uint8_t { no_gps = 0, none = 1, two_d = 2, three_d = 3 };

// Calibrations that take their time.
enum class Calibrating : uint8_t {
    nothing,
    rest,     // gyros, pressures: it stands still
    level,    // the accelerometers' offsets, standing level
    sides,    // their offsets and scales, on six sides one after the other
    compass,  // turned about
};

// What is to be flown. A mode or a NAV command writes the demand; guidance.cpp flies it.
enum class Path : uint8_t { none, leg, circle, takeoff, land };

// What the roll and pitch sticks do to the surfaces. The yaw stick is always added to the rudder.
enum class Sticks : uint8_t {
    nothing,  // the demands below are flown alone (plus pilot_roll_rad, pilot_pitch_rad)
    on_top,   // STABILIZE: added to what stabilisation makes
    direct,   // MANUAL: they are the surfaces, throttle_demand the throttle
    bounded,  // TRAINING: they are the surfaces, up to the limits of bank and pitch
    rates,    // ACRO: roll_demand_rad and pitch_demand_rad are what is left to turn
};

struct Vehicle {
    // ---- sensors.cpp, every frame
    struct {
        estimation::Turn turned;        // body axes: x forward, y right, z down; bias removed
        core::BodyRates rate_rads;      // the same, by the time
        core::Accelerations accel_mss;  // specific force: (0, 0, -g) at rest and level
        uint8_t periods;                // of estimation::kSamplePeriod_s in this frame's samples
        bool healthy;
        bool calibrated;  // gyro bias known
    } imu;
    struct {
        int32_t pressure_pa;
        int16_t temperature_cc;      // 0.01 C
        float ground_pressure_pa;    // zero of the height
        float ground_temperature_c;  // held from then on
        float height_m;              // above where it was zeroed
        bool fresh;                  // a new reading in this frame
        bool healthy;
    } baro;
    struct {
        core::Vector3 field_mg;  // body axes, offsets added
        bool fresh;
        bool healthy;
    } compass;
    struct {
        GpsFix fix;
        uint8_t satellites;
        uint16_t hdop_c;  // 0.01
        geo::Position position;
        int32_t altitude_cm;         // above sea level
        core::Vector3 velocity_mps;  // north, east, down
        float ground_speed_mps;
        uint16_t course_cd;
        uint32_t received_ms;
        uint16_t age_ms;  // when it was received
        bool fresh;
        bool healthy;
    } gps;
    struct {
        float speed_mps;  // indicated
        bool healthy;     // fitted, used and sane
    } airspeed;
    struct {
        uint16_t voltage_mv;
        int16_t current_ca;  // 10 mA; -1 unknown
        float consumed_mah;
        uint16_t board_mv;  // Vcc
    } battery;

    // ---- estimator.cpp, every frame
    struct {
        core::Angle roll_rad, pitch_rad, yaw_rad;
        core::Ratio sin_roll, cos_roll, sin_pitch, cos_pitch;
        core::BodyRates rate_rads;
        bool aligned;
    } attitude;
    struct {
        geo::Position position;  // between fixes carried on with the velocity
        bool flying : 1;
        bool known : 1;              // a fix has been seen and is not too old
        bool reckoned : 1;           // without fixes for a while: by air and wind
        bool fix_refused : 1;        // the last one lay too far off
        core::Vector3 velocity_mps;  // north, east, down
        float ground_speed_mps;
        uint16_t course_cd;
        float height_m;  // above home
        float climb_mps;
        float airspeed_mps;  // true, measured or estimated from wind
        float equivalent_airspeed_mps;
        core::Vector3 wind_mps;  // where it blows to: north, east, 0
    } estimate;

    // ---- home.cpp: set at arming or by command
    struct {
        geo::Position position;
        int32_t altitude_cm;  // above sea level
        bool set;
    } home;

    // ---- radio.cpp, when a frame came
    struct {
        uint16_t pulse_us[hal::kRcChannels];
        int16_t roll_cd, pitch_cd, yaw_cd;  // -4500..4500
        int8_t throttle_pct;                // 0..100
        bool lost;                          // no frames, or throttle below THR_FS_VALUE
        uint32_t good_ms;                   // when the sticks were last good
    } radio;

    // ---- modes.cpp / arming.cpp / failsafe.cpp
    Mode mode;
    bool mode_changed;  // in this frame: controllers start afresh; tasks.cpp clears it
    bool armed;
    uint16_t failing;  // a bit for each Cause of causes.hpp
    bool failsafe_short : 1, failsafe_long : 1;
    bool failsafe_glides;      // failsafe.cpp: FBWA is flown by nobody: wings level, motor off
    bool failsafe_gives_back;  // failsafe.cpp: a mode is being entered that was only interrupted
    bool fence_holds;     // fence.cpp: it flies the airplane, the pilot's sticks have no say ...
    bool fence_throttle;  // ... but for the throttle
    bool prearm_ok;       // arming.cpp: all of its checks passed when last gone through
    bool log_usable;      // logger: its chip is there
    Calibrating calibrating;  // gcs/calibration.cpp

    // ---- gcs/housekeeping.cpp
    uint32_t ground_heard_ms;  // when the ground station (SYSID_MYGCS) was last heard; 0: never

    // ---- what is demanded: modes/ and the NAV commands write, guidance.cpp flies and reports
    struct {
        Path path;
        geo::Position from;   // start of the leg
        geo::Position to;     // end of the leg, centre of the circle, landing point
        float from_height_m;  // above home: the slope of a leg begins here ...
        float height_m;       // ... and ends here; of a circle the height throughout
        bool sloped;          // false: the height changes at once
        float radius_m;       // of a circle
        bool counter_clockwise;
        float takeoff_pitch_rad;
        float climb_rate_mps;  // CONDITION_CHANGE_ALT moves the height at this rate; 0: no
        float airspeed_mps;    // demanded cruise speed, set at mission start from TRIM_ARSPD_CM
        int8_t throttle_pct;   // cruise throttle
        bool new_path;         // set by the writer, cleared by guidance.cpp: begin afresh
    } demand;
    struct {
        float distance_m;  // to the end of the leg or the centre
        uint16_t target_bearing_cd;
        uint16_t nav_bearing_cd;
        float crosstrack_m;
        float height_error_m;
        float airspeed_error_mps;
        float turned_rad;   // along the circle since capture, always growing
        bool passed : 1;    // the line through `to` across the leg is behind
        bool captured : 1;  // on the circle
        bool flaring : 1;
        bool throttle_suppressed : 1;
    } progress;

    // ---- guidance.cpp or a mode, for attitude_control.cpp
    core::Angle roll_demand_rad, pitch_demand_rad;
    core::Ratio throttle_demand;  // 0..1
    core::Ratio rudder_demand;    // -1..1, added by what stabilises: steers on the runway
    // ---- modes/, every frame
    Sticks sticks;
    core::Angle pilot_roll_rad,
        pilot_pitch_rad;  // stick mixing: added to the demands, within the limits

    // ---- inverted.cpp
    bool inverted;  // bank is counted from upside down

    // ---- outputs.cpp
    uint16_t servo_us[hal::kServos];
};

extern Vehicle vehicle;

}  // namespace state
}  // namespace firmware

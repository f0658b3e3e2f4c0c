// SPDX-License-Identifier: GPL-3.0-or-later
// What the rooms of the flight program share: a struct a section, each written by the one file that
// defines its Publisher (firmware/state/published.hpp) and read by everyone through `vehicle`.
#pragma once
#include <stdint.h>

#include "core/file_state.hpp"
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
    takeoff = 13,
    guided = 15,
    initialising = 16,
};

// Who asked for the mode, in the order of the rows in firmware/modes/mode_requests.cpp.
enum class ModeReason : uint8_t { restart, failsafe, boot, pilot, ground, mission };

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

// ---- sensors

struct ImuState {
    estimation::DeltaAngle turned;  // body axes: x forward, y right, z down; bias removed
    core::BodyRates rate_rads;      // the same, by the time
    core::Accelerations accel_mss;  // specific force: (0, 0, -g) at rest and level
    uint8_t periods;                // of estimation::kSamplePeriod_s in this frame's samples
    bool healthy;
    bool calibrated;  // gyro bias known
};

struct BarometerState {
    int32_t pressure_pa;
    int16_t temperature_cc;      // 0.01 C
    float ground_pressure_pa;    // zero of the height; 0: not measured yet
    float ground_temperature_c;  // held from then on
    uint8_t readings;            // accepted so far; wraps
    bool healthy;
};

struct CompassState {
    core::Vector3 field_mg;  // body axes, offsets added
    uint8_t readings;        // so far; wraps
    int8_t points_down;      // as the field does at this place: 1, upwards: -1, hardly: 0
    bool accepted;           // the last of them was plausible
    bool healthy;
};

struct GpsState {
    GpsFix fix;
    uint8_t satellites;
    uint16_t hdop_c;  // 0.01
    geo::Position position;
    int32_t altitude_cm;         // above sea level
    core::Vector3 velocity_mps;  // north, east, down
    bool measures_climb;         // else velocity_mps.z repeats the estimate
    float ground_speed_mps;
    uint16_t course_cd;
    uint32_t received_ms;
    uint16_t age_ms;  // when it was received
    uint8_t fixes;    // with a place so far; wraps
    bool healthy;
};

struct AirspeedState {
    float speed_mps;  // indicated
    bool healthy;     // fitted, used and sane
};

struct BatteryState {
    uint16_t voltage_mv;
    int16_t current_ca;  // 10 mA; -1 unknown
    float consumed_mah;
    uint16_t board_mv;  // Vcc
};

struct RadioState {
    uint16_t pulse_us[hal::kRcChannels];
    int16_t roll_cd, pitch_cd, yaw_cd;  // -4500..4500
    int8_t throttle_pct;                // 0..100
    bool lost;                          // no frames, or throttle below THR_FS_VALUE
    bool heard;                         // good sticks have come since the start
};

// ---- where and how it flies

struct AttitudeState {
    core::Angle roll_rad, pitch_rad, yaw_rad;
    core::Ratio sin_roll, cos_roll, sin_pitch, cos_pitch;
    core::BodyRates rate_rads;
    bool aligned;
};

struct EstimateState {
    geo::Position position;  // between fixes carried on with the velocity
    bool flying;
    bool known;                  // a fix has been seen and is not too old
    bool reckoned;               // without fixes for a while: by air and wind
    bool fix_refused;            // the last one lay too far off
    bool height_known;           // a barometer's or a receiver's was used within 2 s
    core::Vector3 velocity_mps;  // north, east, down
    float ground_speed_mps;
    uint16_t course_cd;
    float baro_height_m;  // above where the barometer was zeroed
    float height_m;       // above home
    float climb_mps;
    float airspeed_mps;  // true, measured or estimated from wind
    float equivalent_airspeed_mps;
    core::Vector3 wind_mps;  // where it blows to: north, east, 0
};

// Set by the first good fix, refined until arming, or set by command.
struct HomeState {
    geo::Position position;
    int32_t altitude_cm;  // above sea level
    bool set;
    bool ordered;     // or of the flight before a restart: arming alone changes it by itself
    uint8_t changes;  // so far; wraps
};

// ---- what is in force

struct ModeState {
    Mode mode;
    ModeReason mode_reason;  // who asked for it
    uint8_t mode_entries;    // so far; wraps. Controllers start afresh when it has changed
};

struct ArmingState {
    bool armed;
    bool prearm_ok;   // all checks passed when last gone through
    bool terminated;  // until the board is restarted
};

struct RestartState {
    bool resuming;  // the flight from before a restart goes on, in a mode not decided yet
};

struct FailsafeState {
    uint16_t failing;  // a bit for each Cause of causes.hpp
    bool failsafe_short : 1, failsafe_long : 1;
    bool failsafe_glides;      // FBWA is flown by nobody: wings level, motor off
    bool failsafe_gives_back;  // a mode is being entered that was only interrupted
};

struct FenceState {
    bool fence_holds;     // it flies the airplane, the pilot's sticks have no say ...
    bool fence_throttle;  // ... but for the throttle
};

struct LoggerState {
    bool log_usable;  // its chip is there
};

struct CalibrationState {
    Calibrating calibrating;
};

struct GroundState {
    uint32_t ground_heard_ms;  // when SYSID_MYGCS was last heard; 0: never
};

// ---- what is demanded

// Of guidance, which modes and NAV commands ask for it: firmware/guidance/demand.hpp.
struct PathDemand {
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
    bool new_path;         // guidance has not begun it yet
};

struct PathProgress {
    float distance_m;  // to the end of the leg or the centre
    uint16_t target_bearing_cd;
    uint16_t nav_bearing_cd;
    float crosstrack_m;
    float height_error_m;
    float airspeed_error_mps;
    float turned_rad;  // along the circle since capture, always growing
    bool passed;       // the line through `to` across the leg is behind
    bool captured;     // on the circle
    bool flaring;
    bool steering;  // the rudder is the runway's, which damps the yaw too
    bool throttle_suppressed;
    bool blown_back;  // over ground, by a headwind
};

// Of attitude control, which modes and guidance ask for it: firmware/control/attitude_demand.hpp.
struct AttitudeDemand {
    core::Angle roll_demand_rad, pitch_demand_rad;
    core::Ratio throttle_demand;  // 0..1
    core::Ratio rudder_demand;    // -1..1, added by what stabilises: steers on the runway
};

struct StickState {
    Sticks sticks;
    core::Angle pilot_roll_rad, pilot_pitch_rad;  // stick mixing: added to the demands, in limits
};

struct InvertedState {
    bool inverted;  // bank is counted from upside down
};

struct ServoState {
    uint16_t servo_us[hal::kServos];  // 0: no pulse
};

struct Vehicle : ModeState,
                 ArmingState,
                 RestartState,
                 FailsafeState,
                 FenceState,
                 LoggerState,
                 CalibrationState,
                 GroundState,
                 AttitudeDemand,
                 StickState,
                 InvertedState,
                 ServoState {
    ImuState imu;
    BarometerState baro;
    CompassState compass;
    GpsState gps;
    AirspeedState airspeed;
    BatteryState battery;
    RadioState radio;
    AttitudeState attitude;
    EstimateState estimate;
    HomeState home;
    PathDemand demand;
    PathProgress progress;
};

template <class Section>
struct Publisher;  // see published.hpp
template <class Section>
class Writable;

class VehicleStorage {
    template <class Section>
    friend class Writable;

    static core::FileState<Vehicle> vehicle_;

    static constexpr Vehicle& section(Vehicle*) { return vehicle_; }  // of the tests
    static constexpr ImuState& section(ImuState*) { return vehicle_.imu; }
    static constexpr BarometerState& section(BarometerState*) { return vehicle_.baro; }
    static constexpr CompassState& section(CompassState*) { return vehicle_.compass; }
    static constexpr GpsState& section(GpsState*) { return vehicle_.gps; }
    static constexpr AirspeedState& section(AirspeedState*) { return vehicle_.airspeed; }
    static constexpr BatteryState& section(BatteryState*) { return vehicle_.battery; }
    static constexpr RadioState& section(RadioState*) { return vehicle_.radio; }
    static constexpr AttitudeState& section(AttitudeState*) { return vehicle_.attitude; }
    static constexpr EstimateState& section(EstimateState*) { return vehicle_.estimate; }
    static constexpr HomeState& section(HomeState*) { return vehicle_.home; }
    static constexpr ModeState& section(ModeState*) { return vehicle_; }
    static constexpr ArmingState& section(ArmingState*) { return vehicle_; }
    static constexpr RestartState& section(RestartState*) { return vehicle_; }
    static constexpr FailsafeState& section(FailsafeState*) { return vehicle_; }
    static constexpr FenceState& section(FenceState*) { return vehicle_; }
    static constexpr LoggerState& section(LoggerState*) { return vehicle_; }
    static constexpr CalibrationState& section(CalibrationState*) { return vehicle_; }
    static constexpr GroundState& section(GroundState*) { return vehicle_; }
    static constexpr PathDemand& section(PathDemand*) { return vehicle_.demand; }
    static constexpr PathProgress& section(PathProgress*) { return vehicle_.progress; }
    static constexpr AttitudeDemand& section(AttitudeDemand*) { return vehicle_; }
    static constexpr StickState& section(StickState*) { return vehicle_; }
    static constexpr InvertedState& section(InvertedState*) { return vehicle_; }
    static constexpr ServoState& section(ServoState*) { return vehicle_; }

public:
    static constexpr const Vehicle& read() { return vehicle_; }
};

static constexpr const Vehicle& vehicle = VehicleStorage::read();

}  // namespace state
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// The records of the flight log: each a packed struct and a row of records.cpp, which says the same
// to whoever reads the log. Names and fields as ArduPlane's logs have them where they mean the
// same; TimeUS is microseconds since start. docs/log.md says what each holds.
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "control/speed_height.hpp"
#include "firmware/mission/mission.hpp"
#include "geo/position.hpp"
#include "hal/rc_input.hpp"
#include "hal/servo_output.hpp"
#include "logging/format.hpp"

namespace firmware {
namespace logger {

#define RECORD(Name) struct __attribute__((packed)) Name##Record : TimedRecord

struct __attribute__((packed)) TimedRecord {
    logging::RecordHead head;
    uint32_t time_us, time_upper;  // one number of 64 bits
};

RECORD(Parameter) {
    char name[16];
    float value;
};
RECORD(Mode) { uint8_t mode, number; };
RECORD(Command) {
    uint16_t count, index, command;
    uint8_t params_and_place[offsetof(mission::MissionItem, z) + sizeof(float) -
                             offsetof(mission::MissionItem, param1)];
    uint8_t frame;
};
RECORD(Message) { char text[64]; };
struct __attribute__((packed)) Tilt {
    int16_t roll_demand_cd, roll_cd, pitch_demand_cd, pitch_cd;
};
RECORD(Attitude) {
    Tilt tilt;
    uint16_t bearing_cd, yaw_cd;
};
// One of several that might be fitted: as a field of unit "#" it makes IMU[0] of an IMU record.
struct __attribute__((packed)) InstanceRecord : TimedRecord {
    uint8_t instance;
};
#define INSTANCE_RECORD(Name) struct __attribute__((packed)) Name##Record : InstanceRecord

INSTANCE_RECORD(Gps) {
    uint8_t status;
    uint32_t time_ms;
    uint16_t week;
    uint8_t satellites;
    int16_t hdop_c;
    geo::Position position;
    int32_t altitude_cm;
    uint16_t speed_cmps, course_cd;
    int16_t down_cmps;
    uint8_t used;
};
RECORD(ControlTuning) {
    Tilt tilt;
    uint8_t throttle_pct, throttle_demand_pct;
    int16_t rudder_cpct, airspeed_cmps;
    uint16_t true_from_equivalent_c;  // 0.01
};
RECORD(NavigationTuning) {
    uint16_t distance_m, target_bearing_cd, bearing_cd;
    float height_error_m, crosstrack_m;
    int16_t airspeed_error_cmps;
};
struct __attribute__((packed)) Place {
    geo::Position position;
    int32_t altitude_cm;
};
struct __attribute__((packed)) Pose {
    Place place;
    int16_t roll_cd, pitch_cd;
    uint16_t yaw_cd;
};
RECORD(Place) {
    Place place;
    int32_t height_cm;
};
RECORD(Attitude2) { Pose pose; };
RECORD(SpeedHeight) {
    float height_m, climb_mps;
    float flown[sizeof(::control::SpeedHeightFlown) / sizeof(float)];
};
RECORD(Loop) {
    int16_t figures[6];  // of control::LoopFigures
};
INSTANCE_RECORD(Airspeed) {
    uint16_t speed_cmps;
    uint8_t healthy;
};
INSTANCE_RECORD(Vibration) { uint16_t vibration_cmss[3], clips; };
INSTANCE_RECORD(Inertial) { float rate_rads[3], accel_mss[3]; };
INSTANCE_RECORD(Compass) { int16_t field_mg[3], offset_mg[3]; };
INSTANCE_RECORD(Barometer) {
    float height_m, pressure_pa;
    int16_t temperature_cdeg, climb_cmps;
};
INSTANCE_RECORD(Battery) {
    uint16_t voltage_cv;
    int16_t current_ca;
    float consumed_mah;
};
RECORD(Power) { uint16_t board_cv; };
RECORD(RadioIn) { uint16_t pulse_us[hal::kRcChannels]; };
RECORD(ServoOut) { uint16_t pulse_us[hal::kServos]; };
RECORD(Performance) { uint16_t late_frames, longest_frame_us, free_bytes, load_permille, dropped; };
RECORD(Camera) {
    uint32_t time_ms;
    uint16_t week;
    Pose pose;
};
RECORD(Event) { uint8_t id; };
RECORD(Error) { uint8_t subsystem, code; };
RECORD(Lists) { uint32_t mission_id, fence_id, rally_points_id; };
RECORD(Unit) { char id, label[64]; };
RECORD(Multiplier) {
    char id;
    uint32_t value_lower, value_upper;  // a double of 64 bits, which this compiler does not have
};
RECORD(Units) {
    uint8_t of_type;
    char units[16], multipliers[16];
};

#undef RECORD
#undef INSTANCE_RECORD

// The type byte of each; by name is how a log is read, so none of them is a promise. In the order
// of the rows, of which FMT is the first.
enum class RecordType : uint8_t {
    format = logging::kFormatType,
    parameter,
    gps,
    inertial,
    message,
    radio_in,
    servo_out,
    barometer,
    command,
    attitude,
    battery,
    compass,
    mode,
    control,
    navigation,
    performance,
    event,
    error,
    camera,
    lists,
    unit,
    multiplier,
    units,
    place,
    power,
    attitude2,
    speed_height,
    roll_loop,
    pitch_loop,
    airspeed,
    vibration,
    yaw_loop,
    end,
};

constexpr uint8_t kFormats = static_cast<uint8_t>(RecordType::end) - logging::kFormatType;
constexpr uint8_t kUnits = 22, kMultipliers = 7;

// They are spelt out of flash. The first is the format of FMT itself.
void spellFormat(uint8_t index, logging::Format& to);
void spellUnits(uint8_t index, UnitsRecord& to);  // of the fields of a format
void spellUnit(uint8_t index, UnitRecord& to);
void spellMultiplier(uint8_t index, MultiplierRecord& to);

uint8_t lengthOfRecord(uint8_t type);  // 0: there is no such type

}  // namespace logger
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/logger/sources.hpp"

#include <string.h>

#include "core/based.hpp"
#include "core/maths.hpp"
#include "core/seldom.hpp"
#include "drivers/ublox.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware/guidance/height.hpp"
#include "firmware/logger/log.hpp"
#include "firmware/logger/records.hpp"
#include "firmware/mission/lists.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/processor_figures.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"
#include "hal/memory.hpp"

namespace firmware {
namespace logger {

using namespace notify;
using namespace state;
using namespace sensors;
using namespace mission;

namespace {

// now_us is the lower half; the upper one follows from the frame's time, which is no later and
// wraps after 49 days.
void stamp(TimedRecord& record) {
    const uint32_t frame_ms = hal::frame_ms();
    const uint32_t low = (frame_ms & 0xFFFF) * 1000;
    const uint32_t high = (frame_ms >> 16) * 1000 + (low >> 16);
    const uint32_t whole_ms_us = high << 16 | (low & 0xFFFF);
    record.time_us = hal::now_us();
    record.time_upper = (high >> 16) + (record.time_us < whole_ms_us);
}

template <class Record>
bool log(RecordType type, Record& record) {
    return logRecord(&record, static_cast<uint8_t>(type), sizeof record);
}

template <class Record>
bool logFirst(RecordType type, Record& record) {
    record.instance = 0;
    return log(type, record);
}

SELDOM int16_t centidegrees(core::Angle angle) { return core::upper(angle.raw * 36000L); }
uint16_t heading_cd() {
    return static_cast<uint16_t>(
        core::wrap360_cd(core::rounded(core::centidegrees(vehicle.attitude.yaw_rad.toFloat()))));
}
SELDOM uint8_t percent(core::Ratio of_all) {
    return static_cast<uint8_t>(
        core::times14(core::limit<int16_t>(of_all.raw, 0, core::Ratio::kOne), 100));
}
SELDOM int16_t hundredths(float value) { return core::narrowed(core::inHundredths(value)); }
SELDOM int32_t height_cm() { return core::inHundredths(vehicle.estimate.height_m); }

}  // namespace

bool logRecord(void* record, uint8_t type, uint8_t size) {
    TimedRecord& timed = *static_cast<TimedRecord*>(record);
    timed.head = {logging::kHead1, logging::kHead2, type};
    stamp(timed);
    return flight_logs.put(record, size) == core::Status::ok;
}

bool putFormat(uint8_t index) {
    logging::FormatRecord record;
    record.head = {logging::kHead1, logging::kHead2, logging::kFormatType};
    spellFormat(index, record.format);
    return flight_logs.put(&record, sizeof record) == core::Status::ok;
}

bool putUnit(uint8_t index) {
    UnitRecord record;
    spellUnit(index, record);
    return log(RecordType::unit, record);
}

bool putMultiplier(uint8_t index) {
    MultiplierRecord record;
    spellMultiplier(index, record);
    return log(RecordType::multiplier, record);
}

bool putUnits(uint8_t index) {
    UnitsRecord record;
    spellUnits(index, record);
    return log(RecordType::units, record);
}

bool putParameter(uint8_t index) {
    ParameterRecord record;
    char name[16];
    float value;
    uint8_t type;
    if (!parameterAt(index, name, value, type)) return true;
    memcpy(record.name, name, sizeof name);
    record.value = value;
    return log(RecordType::parameter, record);
}

namespace {

bool logItem(uint8_t index, const MissionItem& item) {
    CommandRecord record;
    record.count = missionCount();
    record.index = index;
    record.command = item.command;
    memcpy(record.params_and_place,
           reinterpret_cast<const uint8_t*>(&item) + offsetof(MissionItem, param1),
           sizeof record.params_and_place);
    record.frame = item.frame;
    return log(RecordType::command, record);
}

}  // namespace

bool putCommand(uint8_t index) {
    MissionItem item;
    const core::Status status = missionItem(index, item);
    return status == core::Status::ok ? logItem(index, item) : status != core::Status::busy;
}

bool putMode() {
    ModeRecord record;
    record.mode = record.number = static_cast<uint8_t>(vehicle.mode);
    return log(RecordType::mode, record);
}

static bool logText() {
    MessageRecord record = {};
    Severity severity;
    if (!readText(kLogReader, severity, record.text) || !log(RecordType::message, record))
        return false;
    textTaken(kLogReader);
    return true;
}

bool putText() { return textWaits(kLogReader) && logText(); }

// Readers look for "Plane".
bool putBanner() {
    MessageRecord record;
    core::unpack(STATUS_TEXT("ArduPilotMega autopilot V0.1 (Plane)").letters(), record.text,
                 sizeof record.text);
    return log(RecordType::message, record);
}

bool putLists() {
    ListsRecord record;
    record.mission_id = listId(ListKind::mission);
    record.fence_id = listId(ListKind::fence);
    record.rally_points_id = listId(ListKind::rally);
    return log(RecordType::lists, record);
}

bool putEvent(uint8_t id) {
    EventRecord record;
    record.id = id;
    return log(RecordType::event, record);
}

bool putError(uint8_t subsystem, uint8_t code) {
    ErrorRecord record;
    record.subsystem = subsystem;
    record.code = code;
    return log(RecordType::error, record);
}

namespace {

SELDOM void fill(Tilt& tilt) {
    tilt.roll_demand_cd = centidegrees(vehicle.roll_demand_rad);
    tilt.roll_cd = centidegrees(vehicle.attitude.roll_rad);
    tilt.pitch_demand_cd = centidegrees(vehicle.pitch_demand_rad);
    tilt.pitch_cd = centidegrees(vehicle.attitude.pitch_rad);
}

}  // namespace

bool putAttitude() {
    AttitudeRecord record;
    fill(record.tilt);
    record.bearing_cd = static_cast<uint16_t>(core::wrap360_cd(vehicle.progress.nav_bearing_cd));
    record.yaw_cd = heading_cd();
    return log(RecordType::attitude, record);
}

bool putGps() {
    const auto& gps = core::based(vehicle.gps);
    GpsRecord record;
    record.status = static_cast<uint8_t>(gps.fix);
    record.time_ms = gpsFix().time_ms;
    record.week = gpsFix().week;
    record.satellites = gps.satellites;
    record.hdop_c = static_cast<int16_t>(gps.hdop_c);
    record.position = gps.position;
    record.altitude_cm = gps.altitude_cm;
    record.speed_cmps = static_cast<uint16_t>(hundredths(gps.ground_speed_mps));
    record.course_cd = gps.course_cd;
    record.down_cmps = hundredths(gps.velocity_mps.z);
    record.used = 1;
    return logFirst(RecordType::gps, record);
}

namespace {

void fill(Place& place, int32_t height_cm) {
    place.position = vehicle.estimate.position;
    place.altitude_cm = vehicle.home.altitude_cm + height_cm;
}

void fill(Pose& pose) {
    fill(pose.place, height_cm());
    pose.roll_cd = centidegrees(vehicle.attitude.roll_rad);
    pose.pitch_cd = centidegrees(vehicle.attitude.pitch_rad);
    pose.yaw_cd = heading_cd();
}

}  // namespace

bool putCameraFeedback() {
    CameraRecord record;
    record.time_ms = gpsFix().time_ms;
    record.week = gpsFix().week;
    fill(record.pose);
    return log(RecordType::camera, record);
}

bool putPlace() {
    PlaceRecord record;
    record.height_cm = height_cm();
    fill(record.place, record.height_cm);
    return log(RecordType::place, record);
}

bool putAttitude2() {
    Attitude2Record record;
    fill(record.pose);
    return log(RecordType::attitude2, record);
}

bool putSpeedHeight() {
    if (!guidesItself()) return true;
    SpeedHeightRecord record;
    record.height_m = vehicle.estimate.height_m;
    record.climb_mps = vehicle.estimate.climb_mps;
    memcpy(record.flown, &guidance::heightFlown(), sizeof record.flown);
    return log(RecordType::speed_height, record);
}

bool putLoop(control::Loop loop) {
    static constexpr RecordType kTypes[] ROM = {RecordType::roll_loop, RecordType::pitch_loop,
                                                RecordType::yaw_loop};
    control::LoopFigures figures;
    control::loopFigures(loop, figures);
    const float* figure = &figures.demand_cdps;
    LoopRecord record;
    for (uint8_t i = 0; i < core::count(record.figures); ++i)
        record.figures[i] = core::toFixed(*figure++, 0);
    return log(core::romRead(kTypes[static_cast<uint8_t>(loop)]), record);
}

bool putAirspeed() {
    if (parameters.airspeed_enable == 0) return true;
    AirspeedRecord record;
    record.speed_cmps = static_cast<uint16_t>(hundredths(vehicle.airspeed.speed_mps));
    record.healthy = vehicle.airspeed.healthy;
    return logFirst(RecordType::airspeed, record);
}

bool putVibration() {
    VibrationRecord record;
    for (uint8_t axis = 0; axis < 3; ++axis) record.vibration_cmss[axis] = vibration_cmss(axis);
    record.clips = accelerometerClips();
    return logFirst(RecordType::vibration, record);
}

bool putControl() {
    ControlTuningRecord record;
    fill(record.tilt);
    record.throttle_pct = percent(control::surfaces.throttle);
    record.throttle_demand_pct = percent(vehicle.throttle_demand);
    record.rudder_cpct = core::times14(control::surfaces.rudder.raw, 10000);
    const float equivalent_mps = vehicle.estimate.equivalent_airspeed_mps;
    record.airspeed_cmps = hundredths(equivalent_mps);
    constexpr float kFlying_mps = 5;
    record.true_from_equivalent_c = 100;
    if (equivalent_mps > kFlying_mps)
        record.true_from_equivalent_c =
            static_cast<uint16_t>(hundredths(vehicle.estimate.airspeed_mps / equivalent_mps));
    return log(RecordType::control, record);
}

bool putNavigation() {
    const auto& progress = core::based(vehicle.progress);
    NavigationTuningRecord record;
    record.distance_m = static_cast<uint16_t>(core::limit(progress.distance_m, 0.0f, 65535.0f));
    record.target_bearing_cd = progress.target_bearing_cd;
    record.bearing_cd = progress.nav_bearing_cd;
    record.height_error_m = progress.height_error_m;
    record.crosstrack_m = progress.crosstrack_m;
    record.airspeed_error_cmps = hundredths(progress.airspeed_error_mps);
    return log(RecordType::navigation, record);
}

bool putInertial() {
    const core::BodyRate* rate = &vehicle.imu.rate_rads.x;
    const core::Acceleration* accel = &vehicle.imu.accel_mss.x;
    InertialRecord record;
    for (uint8_t i = 0; i < 3; ++i) {
        record.rate_rads[i] = (rate++)->toFloat();
        record.accel_mss[i] = (accel++)->toFloat();
    }
    return logFirst(RecordType::inertial, record);
}

bool putCompass() {
    const float* field_mg = &vehicle.compass.field_mg.x;
    CompassRecord record;
    for (uint8_t i = 0; i < 3; ++i) {
        record.field_mg[i] = static_cast<int16_t>(*field_mg++);
        record.offset_mg[i] = static_cast<int16_t>(parameters.compass.offset_mg[i]);
    }
    return logFirst(RecordType::compass, record);
}

bool putBarometer() {
    BarometerRecord record;
    record.height_m = vehicle.estimate.baro_height_m;
    record.pressure_pa = static_cast<float>(vehicle.baro.pressure_pa);
    record.temperature_cdeg = vehicle.baro.temperature_cc;
    record.climb_cmps = hundredths(vehicle.estimate.climb_mps);
    return logFirst(RecordType::barometer, record);
}

bool putBattery() {
    BatteryRecord record;
    record.voltage_cv = vehicle.battery.voltage_mv / 10;
    record.current_ca = vehicle.battery.current_ca;
    record.consumed_mah = vehicle.battery.consumed_mah;
    return logFirst(RecordType::battery, record);
}

bool putPower() {
    PowerRecord record;
    record.board_cv = vehicle.battery.board_mv / 10;
    return log(RecordType::power, record);
}

bool putRadioIn() {
    RadioInRecord record;
    memcpy(record.pulse_us, vehicle.radio.pulse_us, sizeof record.pulse_us);
    return log(RecordType::radio_in, record);
}

bool putServoOut() {
    ServoOutRecord record;
    memcpy(record.pulse_us, vehicle.servo_us, sizeof record.pulse_us);
    return log(RecordType::servo_out, record);
}

bool putPerformance() {
    PerformanceRecord record;
    record.load_permille = processor_figures.load_permille;
    record.late_frames = processor_figures.late_frames;
    record.longest_frame_us = processor_figures.longest_frame_us;
    record.free_bytes = hal::freeMemory();
    record.dropped = logDropped();
    return log(RecordType::performance, record);
}

}  // namespace logger
}  // namespace firmware

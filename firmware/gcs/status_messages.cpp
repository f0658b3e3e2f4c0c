// SPDX-License-Identifier: GPL-3.0-or-later
// How the vehicle is and what it is.
#include <string.h>

#include "board.hpp"
#include "core/maths.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/gcs/gps_time.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/messages.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/safety/arming.hpp"
#include "firmware/safety/failsafe.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/processor_figures.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"
#include "hal/memory.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;
using namespace safety;

namespace {

using mavlink::MavModeFlag;
using mavlink::MavState;
using Sensor = mavlink::MavSysStatusSensor;

constexpr uint32_t kVersion = 0UL << 24 | 1UL << 16 | mavlink::FirmwareVersionType::dev;

uint8_t baseMode() {
    uint8_t flags = MavModeFlag::custom_mode_enabled;
    const bool manual = vehicle.mode == Mode::manual;
    if (vehicle.armed) flags |= MavModeFlag::safety_armed;
    if (manual || parameters.stick_mixing != 0) flags |= MavModeFlag::manual_input_enabled;
    if (!manual && vehicle.mode != Mode::initialising) flags |= MavModeFlag::stabilize_enabled;
    if (guidesItself() && !stickSetsSpeed()) flags |= MavModeFlag::guided_enabled;
    return flags;
}

uint8_t systemState() {
    if (vehicle.terminated) return MavState::flight_termination;
    if (vehicle.failsafe_short || vehicle.failsafe_long) return MavState::critical;
    if (vehicle.mode == Mode::initialising || !vehicle.imu.calibrated) return MavState::calibrating;
    return vehicle.estimate.flying ? MavState::active : MavState::standby;
}

// A path that was demanded before the pilot took over is flown no more.
uint8_t landedState() {
    using Landed = mavlink::MavLandedState;
    if (!vehicle.estimate.flying) return Landed::on_ground;
    const Path path = guidesItself() ? vehicle.demand.path : Path::none;
    if (path == Path::takeoff) return Landed::takeoff;
    return path == Path::land ? Landed::landing : Landed::in_air;
}

constexpr uint32_t kFitted =
    Sensor::sensor_3d_gyro | Sensor::sensor_3d_accel | Sensor::sensor_absolute_pressure |
    Sensor::sensor_gps | Sensor::sensor_angular_rate_control |
    Sensor::sensor_attitude_stabilization | Sensor::sensor_yaw_position |
    Sensor::sensor_z_altitude_control | Sensor::sensor_xy_position_control |
    Sensor::sensor_motor_outputs | Sensor::sensor_rc_receiver | Sensor::ahrs | Sensor::prearm_check;

uint32_t fittedSensors() {
    uint32_t bits = kFitted;
    if (parameters.compass_use != 0) bits |= Sensor::sensor_3d_mag;
    if (parameters.airspeed_enable != 0) bits |= Sensor::sensor_differential_pressure;
    if (parameters.battery_monitor != 0) bits |= Sensor::sensor_battery;
    if (fenceThere()) bits |= Sensor::geofence;
    return bits;
}

uint32_t unusedSensors() {
    uint32_t bits = 0;
    if (vehicle.mode == Mode::manual || vehicle.mode == Mode::initialising)
        bits |= Sensor::sensor_angular_rate_control | Sensor::sensor_attitude_stabilization;
    if (!guidesItself())
        bits |= Sensor::sensor_yaw_position | Sensor::sensor_z_altitude_control |
                Sensor::sensor_xy_position_control;
    if (!vehicle.armed) bits |= Sensor::sensor_motor_outputs;
    if (!fenceOn()) bits |= Sensor::geofence;
    return bits;
}

uint32_t ailingSensors() {
    uint32_t bits = 0;
    if (!vehicle.imu.healthy || !vehicle.imu.calibrated)
        bits |= Sensor::sensor_3d_gyro | Sensor::sensor_3d_accel;
    if (!vehicle.attitude.aligned) bits |= Sensor::ahrs;
    if (!vehicle.compass.healthy) bits |= Sensor::sensor_3d_mag;
    if (!vehicle.baro.healthy) bits |= Sensor::sensor_absolute_pressure;
    if (!vehicle.airspeed.healthy) bits |= Sensor::sensor_differential_pressure;
    if (!vehicle.gps.healthy || failing(Cause::gps)) bits |= Sensor::sensor_gps;
    if (failing(Cause::battery)) bits |= Sensor::sensor_battery;
    if (vehicle.radio.lost) bits |= Sensor::sensor_rc_receiver;
    if (fenceReport().breach != Breach::none || fenceBad()) bits |= Sensor::geofence;
    if (!vehicle.armed && !vehicle.prearm_ok) bits |= Sensor::prearm_check;
    return bits;
}

// As ArduPilot's filters set them: a place that is reckoned is a relative one, and one that nobody
// knows counts as standing.
uint16_t estimateFlags() {
    using Flag = mavlink::EkfStatusFlags;
    constexpr uint16_t kPlace =
        Flag::pos_horiz_abs | Flag::pred_pos_horiz_abs | Flag::pred_pos_horiz_rel;
    const auto& estimate = vehicle.estimate;
    const bool aligned = vehicle.attitude.aligned;
    uint16_t flags = aligned ? Flag::attitude : Flag::uninitialized;
    if (estimate.height_known) flags |= Flag::velocity_vert | Flag::pos_vert_abs;
    if (estimate.known) flags |= Flag::velocity_horiz | Flag::pos_horiz_rel;
    if (estimate.known && !estimate.reckoned) flags |= kPlace;
    if (aligned && !estimate.known) flags |= Flag::const_pos_mode;
    if (estimate.fix_refused) flags |= Flag::gps_glitching;
    return flags;
}

int8_t batteryLeft_pct() {
    if (parameters.battery_monitor == 0 || vehicle.battery.current_ca < 0 ||
        parameters.battery_capacity_mah <= 0)
        return -1;
    const float used =
        vehicle.battery.consumed_mah / static_cast<float>(parameters.battery_capacity_mah);
    return static_cast<int8_t>(core::limit(100 - 100 * used, 0.0f, 100.0f));
}

}  // namespace

bool fillIn(const Link&, mavlink::Heartbeat& to) {
    to.custom_mode = static_cast<uint8_t>(vehicle.mode);
    to.type = mavlink::MavType::fixed_wing;
    to.autopilot = mavlink::MavAutopilot::ardupilotmega;
    to.base_mode = baseMode();
    to.system_status = systemState();
    to.mavlink_version = 3;
    return true;
}

bool fillIn(const Link& link, mavlink::SysStatus& to) {
    const uint32_t fitted = fittedSensors();
    to.onboard_control_sensors_present = fitted;
    to.onboard_control_sensors_enabled = fitted & ~unusedSensors();
    // a fence that is not there is not broken: MAVProxy announces a breach when it is not healthy
    to.onboard_control_sensors_health = (fitted | Sensor::geofence) & ~ailingSensors();
    to.load = processor_figures.load_permille;
    to.voltage_battery = vehicle.battery.voltage_mv;
    to.current_battery = vehicle.battery.current_ca;
    to.battery_remaining = batteryLeft_pct();
    to.errors_comm = link.parser.rejected();
    // free for the autopilot's use:
    to.errors_count1 = hal::serialLost(portOf(link));
    to.errors_count2 = processor_figures.late_frames;
    to.errors_count3 = processor_figures.longest_frame_us;
    to.errors_count4 = textsLost();
    return true;
}

// Only the pack's voltage is measured, no cell's.
bool fillIn(const Link&, mavlink::BatteryStatus& to) {
    const auto& battery = vehicle.battery;
    memset(to.voltages, 0xFF, sizeof to.voltages);  // UINT16_MAX: not known
    to.voltages[0] = battery.voltage_mv;
    to.current_battery = battery.current_ca;
    to.current_consumed = battery.current_ca < 0 ? -1 : core::rounded(battery.consumed_mah);
    to.energy_consumed = -1;
    to.temperature = INT16_MAX;
    to.battery_remaining = batteryLeft_pct();
    return parameters.battery_monitor != 0;
}

// A velocity is refused with its fix's place, not by itself; and nothing looks at the ground.
bool fillIn(const Link&, mavlink::EkfStatusReport& to) {
    const estimator::TestRatios ratios = estimator::testRatios();
    to.flags = estimateFlags();
    to.pos_horiz_variance = ratios.position;
    to.pos_vert_variance = ratios.height;
    to.compass_variance = ratios.compass;
    to.airspeed_variance = ratios.airspeed;
    return true;
}

bool fillIn(const Link&, mavlink::FenceStatus& to) {
    const FenceReport report = fenceReport();
    to.breach_time = report.breach_ms;
    to.breach_count = report.breaches;
    to.breach_status = report.breach != Breach::none;
    to.breach_type = report.breach;
    return fenceThere();
}

bool fillIn(const Link&, mavlink::ExtendedSysState& to) {
    to.vtol_state = mavlink::MavVtolState::undefined;
    to.landed_state = landedState();
    return true;
}

bool fillIn(const Link&, mavlink::PowerStatus& to) {
    to.Vcc = vehicle.battery.board_mv;
    if (hal::usbConnected()) to.flags = mavlink::MavPowerStatus::usb_connected;
    return true;
}

bool fillIn(const Link&, mavlink::Hwstatus& to) {
    to.Vcc = vehicle.battery.board_mv;
    return true;
}

bool fillIn(const Link&, mavlink::Meminfo& to) {
    to.freemem = hal::freeMemory();
    return to.freemem != 0;
}

// UTC once there has been a fix, and by our own clock while the receiver is silent.
bool fillIn(const Link&, mavlink::SystemTime& to) {
    to.time_boot_ms = hal::frame_ms();
    const UtcTime utc = utcTime();
    if (utc.week_s != 0)
        to.time_unix_usec = uint64_t{utc.week_s} * 1000000UL + micros(utc.since_ms);
    return true;
}

namespace {

struct Commit {
    char digits[sizeof mavlink::AutopilotVersion::flight_custom_version + 1];
};
constexpr Commit kCommit ROM = {FIRMWARE_COMMIT};  // by the build; empty: not known

}  // namespace

bool fillIn(const Link&, mavlink::AutopilotVersion& to) {
    using Can = mavlink::MavProtocolCapability;
    to.capabilities = Can::mission_float | Can::mission_int | Can::param_float |
                      Can::set_position_target_global_int | Can::compass_calibration |
                      Can::mission_fence | Can::mission_rally | Can::param_encode_c_cast |
                      Can::command_int | Can::mavlink2 | Can::ftp;
    to.flight_sw_version = kVersion;
    const Commit commit = core::romRead(kCommit);
    memcpy(to.flight_custom_version, commit.digits, sizeof to.flight_custom_version);
    to.board_version = board::kModel;
    to.vendor_id = 0x1E;  // the chip's signature: Atmel, ATmega2560; it has no number of its own
    to.product_id = 0x9801;
    return true;
}

bool fillIn(const Link&, mavlink::ProtocolVersion& to) {
    to.version = to.max_version = 200;  // 100 times the version
    to.min_version = 100;
    return true;
}

}  // namespace gcs
}  // namespace firmware

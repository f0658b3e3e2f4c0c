// SPDX-License-Identifier: GPL-3.0-or-later
// Every message as a struct that is its payload: fields in wire order, little-endian.
// Written by toolchain/mavlink/generate.mjs from mavlink-mappings 1.0.22-20260311. Do not edit.
#pragma once

#include <stdint.h>

#include "mavlink/wire.hpp"

// clang-format off
namespace mavlink {

struct MavType {
    enum : uint8_t {
        fixed_wing = 1,
        gcs = 6,
    };
};

struct MavAutopilot {
    enum : uint8_t {
        ardupilotmega = 3,
        invalid = 8,
    };
};

struct MavComponent {
    enum : uint8_t {
        all = 0,
        autopilot1 = 1,
    };
};

struct MavModeFlag {
    enum : uint8_t {
        safety_armed = 128,
        manual_input_enabled = 64,
        hil_enabled = 32,
        stabilize_enabled = 16,
        guided_enabled = 8,
        auto_enabled = 4,
        test_enabled = 2,
        custom_mode_enabled = 1,
    };
};

struct MavState {
    enum : uint8_t {
        uninit = 0,
        boot = 1,
        calibrating = 2,
        standby = 3,
        active = 4,
        critical = 5,
        emergency = 6,
        poweroff = 7,
        flight_termination = 8,
    };
};

struct MavStandardMode {
    enum : uint8_t {
        non_standard = 0,
        cruise = 3,
        altitude_hold = 4,
        safe_recovery = 5,
        mission = 6,
        takeoff = 8,
    };
};

struct MavModeProperty {
    enum : uint8_t {
        not_user_selectable = 2,
        auto_mode = 4,
    };
};

struct EkfStatusFlags {
    enum : uint16_t {
        attitude = 1,
        velocity_horiz = 2,
        velocity_vert = 4,
        pos_horiz_rel = 8,
        pos_horiz_abs = 16,
        pos_vert_abs = 32,
        const_pos_mode = 128,
        pred_pos_horiz_rel = 256,
        pred_pos_horiz_abs = 512,
        uninitialized = 1024,
        gps_glitching = 32768,
    };
};

struct MavLandedState {
    enum : uint8_t {
        undefined = 0,
        on_ground = 1,
        in_air = 2,
        takeoff = 3,
        landing = 4,
    };
};

struct MavVtolState {
    enum : uint8_t {
        undefined = 0,
    };
};

struct MavFrame {
    enum : uint8_t {
        global = 0,
        mission = 2,
        global_relative_alt = 3,
        global_int = 5,
        global_relative_alt_int = 6,
        global_terrain_alt = 10,
        global_terrain_alt_int = 11,
        local_offset_ned = 7,
    };
};

struct MavDataStream {
    enum : uint8_t {
        all = 0,
        raw_sensors = 1,
        extended_status = 2,
        rc_channels = 3,
        raw_controller = 4,
        position = 6,
        extra1 = 10,
        extra2 = 11,
        extra3 = 12,
    };
};

struct MavResult {
    enum : uint8_t {
        accepted = 0,
        temporarily_rejected = 1,
        denied = 2,
        unsupported = 3,
        failed = 4,
        in_progress = 5,
        cancelled = 6,
        command_long_only = 7,
        command_int_only = 8,
        command_unsupported_mav_frame = 9,
    };
};

struct MavMissionResult {
    enum : uint8_t {
        accepted = 0,
        error = 1,
        unsupported_frame = 2,
        unsupported = 3,
        no_space = 4,
        invalid = 5,
        invalid_param1 = 6,
        invalid_param2 = 7,
        invalid_param3 = 8,
        invalid_param4 = 9,
        invalid_param5_x = 10,
        invalid_param6_y = 11,
        invalid_param7 = 12,
        invalid_sequence = 13,
        denied = 14,
        operation_cancelled = 15,
    };
};

struct MavMissionType {
    enum : uint8_t {
        mission = 0,
        fence = 1,
        rally = 2,
        all = 255,
    };
};

struct MissionState {
    enum : uint8_t {
        unknown = 0,
        no_mission = 1,
        not_started = 2,
        active = 3,
        paused = 4,
        complete = 5,
    };
};

struct MavSeverity {
    enum : uint8_t {
        emergency = 0,
        alert = 1,
        critical = 2,
        error = 3,
        warning = 4,
        notice = 5,
        info = 6,
        debug = 7,
    };
};

struct MavSysStatusSensor {
    enum : uint32_t {
        sensor_3d_gyro = 1UL,
        sensor_3d_accel = 2UL,
        sensor_3d_mag = 4UL,
        sensor_absolute_pressure = 8UL,
        sensor_differential_pressure = 16UL,
        sensor_gps = 32UL,
        sensor_angular_rate_control = 1024UL,
        sensor_attitude_stabilization = 2048UL,
        sensor_yaw_position = 4096UL,
        sensor_z_altitude_control = 8192UL,
        sensor_xy_position_control = 16384UL,
        sensor_motor_outputs = 32768UL,
        sensor_rc_receiver = 65536UL,
        geofence = 1048576UL,
        ahrs = 2097152UL,
        terrain = 4194304UL,
        logging = 16777216UL,
        sensor_battery = 33554432UL,
        prearm_check = 268435456UL,
    };
};

struct MavParamType {
    enum : uint8_t {
        int8 = 2,
        int16 = 4,
        int32 = 6,
        real32 = 9,
    };
};

struct MavProtocolCapability {
    enum : uint32_t {
        mission_float = 1UL,
        param_float = 2UL,
        mission_int = 4UL,
        command_int = 8UL,
        set_position_target_global_int = 256UL,
        compass_calibration = 4096UL,
        mavlink2 = 8192UL,
        ftp = 32UL,
        mission_fence = 16384UL,
        mission_rally = 32768UL,
        param_encode_c_cast = 131072UL,
    };
};

struct MavFtpOpcode {
    enum : uint8_t {
        none = 0,
        terminatesession = 1,
        resetsession = 2,
        listdirectory = 3,
        openfilero = 4,
        readfile = 5,
        createfile = 6,
        writefile = 7,
        removefile = 8,
        createdirectory = 9,
        removedirectory = 10,
        openfilewo = 11,
        truncatefile = 12,
        rename = 13,
        calcfilecrc = 14,
        burstreadfile = 15,
        ack = 128,
        nak = 129,
    };
};

struct MavFtpErr {
    enum : uint8_t {
        none = 0,
        fail = 1,
        failerrno = 2,
        invaliddatasize = 3,
        invalidsession = 4,
        nosessionsavailable = 5,
        eof = 6,
        unknowncommand = 7,
        fileexists = 8,
        fileprotected = 9,
        filenotfound = 10,
    };
};

struct MavPowerStatus {
    enum : uint8_t {
        brick_valid = 1,
        servo_valid = 2,
        usb_connected = 4,
        periph_overcurrent = 8,
        periph_hipower_overcurrent = 16,
        changed = 32,
    };
};

struct FenceBreach {
    enum : uint8_t {
        none = 0,
        minalt = 1,
        maxalt = 2,
        boundary = 3,
    };
};

struct MagCalStatus {
    enum : uint8_t {
        not_started = 0,
        waiting_to_start = 1,
        running_step_one = 2,
        running_step_two = 3,
        success = 4,
        failed = 5,
        bad_orientation = 6,
        bad_radius = 7,
    };
};

struct AccelcalVehiclePos {
    enum : uint32_t {
        level = 1UL,
        left = 2UL,
        right = 3UL,
        nosedown = 4UL,
        noseup = 5UL,
        back = 6UL,
        success = 16777215UL,
        failed = 16777216UL,
    };
};

struct FirmwareVersionType {
    enum : uint8_t {
        dev = 0,
        alpha = 64,
        beta = 128,
        rc = 192,
        official = 255,
    };
};

struct GpsFixType {
    enum : uint8_t {
        no_gps = 0,
        no_fix = 1,
        gps_fix_type_2d_fix = 2,
        gps_fix_type_3d_fix = 3,
    };
};

struct MavCmd {
    enum : uint16_t {
        nav_waypoint = 16,
        nav_loiter_unlim = 17,
        nav_loiter_turns = 18,
        nav_loiter_time = 19,
        nav_return_to_launch = 20,
        nav_land = 21,
        nav_takeoff = 22,
        nav_fence_return_point = 5000,
        nav_fence_polygon_vertex_inclusion = 5001,
        nav_fence_polygon_vertex_exclusion = 5002,
        nav_fence_circle_inclusion = 5003,
        nav_fence_circle_exclusion = 5004,
        nav_rally_point = 5100,
        do_fence_enable = 207,
        condition_delay = 112,
        condition_change_alt = 113,
        condition_distance = 114,
        condition_yaw = 115,
        do_set_mode = 176,
        do_jump = 177,
        do_change_speed = 178,
        do_set_home = 179,
        do_set_parameter = 180,
        do_set_relay = 181,
        do_repeat_relay = 182,
        do_set_servo = 183,
        do_repeat_servo = 184,
        do_change_altitude = 186,
        do_reposition = 192,
        do_set_mission_current = 224,
        do_land_start = 189,
        do_go_around = 191,
        do_digicam_control = 203,
        do_set_cam_trigg_dist = 206,
        do_inverted_flight = 210,
        preflight_calibration = 241,
        preflight_set_sensor_offsets = 242,
        preflight_storage = 245,
        preflight_reboot_shutdown = 246,
        mission_start = 300,
        component_arm_disarm = 400,
        run_prearm_checks = 401,
        get_home_position = 410,
        get_message_interval = 510,
        set_message_interval = 511,
        request_message = 512,
        request_protocol_version = 519,
        request_autopilot_capabilities = 520,
        do_flighttermination = 185,
        do_aux_function = 218,
        do_autotune_enable = 212,
        do_set_standard_mode = 262,
        do_send_banner = 42428,
        guided_change_speed = 43000,
        guided_change_altitude = 43001,
        guided_change_heading = 43002,
        do_start_mag_cal = 42424,
        do_accept_mag_cal = 42425,
        do_cancel_mag_cal = 42426,
        accelcal_vehicle_pos = 42429,
    };
};

struct __attribute__((packed)) Heartbeat {
    uint32_t custom_mode;
    uint8_t type;
    uint8_t autopilot;
    uint8_t base_mode;
    uint8_t system_status;
    uint8_t mavlink_version;
};
template <>
struct Wire<Heartbeat> : Shape<0, 9, 9, 50> {};
static_assert(sizeof(Heartbeat) == Wire<Heartbeat>::length_with_extensions, "HEARTBEAT");

struct __attribute__((packed)) SysStatus {
    uint32_t onboard_control_sensors_present;
    uint32_t onboard_control_sensors_enabled;
    uint32_t onboard_control_sensors_health;
    uint16_t load;
    uint16_t voltage_battery;
    int16_t current_battery;
    uint16_t drop_rate_comm;
    uint16_t errors_comm;
    uint16_t errors_count1;
    uint16_t errors_count2;
    uint16_t errors_count3;
    uint16_t errors_count4;
    int8_t battery_remaining;
    // extensions: MAVLink 2 only
    uint32_t onboard_control_sensors_present_extended;
    uint32_t onboard_control_sensors_enabled_extended;
    uint32_t onboard_control_sensors_health_extended;
};
template <>
struct Wire<SysStatus> : Shape<1, 31, 43, 124> {};
static_assert(sizeof(SysStatus) == Wire<SysStatus>::length_with_extensions, "SYS_STATUS");

struct __attribute__((packed)) SystemTime {
    uint64_t time_unix_usec;
    uint32_t time_boot_ms;
};
template <>
struct Wire<SystemTime> : Shape<2, 12, 12, 137> {};
static_assert(sizeof(SystemTime) == Wire<SystemTime>::length_with_extensions, "SYSTEM_TIME");

struct __attribute__((packed)) Ping {
    uint64_t time_usec;
    uint32_t seq;
    uint8_t target_system;
    uint8_t target_component;
};
template <>
struct Wire<Ping> : Shape<4, 14, 14, 237> {};
static_assert(sizeof(Ping) == Wire<Ping>::length_with_extensions, "PING");

struct __attribute__((packed)) SetMode {
    uint32_t custom_mode;
    uint8_t target_system;
    uint8_t base_mode;
};
template <>
struct Wire<SetMode> : Shape<11, 6, 6, 89> {};
static_assert(sizeof(SetMode) == Wire<SetMode>::length_with_extensions, "SET_MODE");

struct __attribute__((packed)) ParamRequestRead {
    int16_t param_index;
    uint8_t target_system;
    uint8_t target_component;
    char param_id[16];
};
template <>
struct Wire<ParamRequestRead> : Shape<20, 20, 20, 214> {};
static_assert(sizeof(ParamRequestRead) == Wire<ParamRequestRead>::length_with_extensions, "PARAM_REQUEST_READ");

struct __attribute__((packed)) ParamRequestList {
    uint8_t target_system;
    uint8_t target_component;
};
template <>
struct Wire<ParamRequestList> : Shape<21, 2, 2, 159> {};
static_assert(sizeof(ParamRequestList) == Wire<ParamRequestList>::length_with_extensions, "PARAM_REQUEST_LIST");

struct __attribute__((packed)) ParamValue {
    float param_value;
    uint16_t param_count;
    uint16_t param_index;
    char param_id[16];
    uint8_t param_type;
};
template <>
struct Wire<ParamValue> : Shape<22, 25, 25, 220> {};
static_assert(sizeof(ParamValue) == Wire<ParamValue>::length_with_extensions, "PARAM_VALUE");

struct __attribute__((packed)) ParamSet {
    float param_value;
    uint8_t target_system;
    uint8_t target_component;
    char param_id[16];
    uint8_t param_type;
};
template <>
struct Wire<ParamSet> : Shape<23, 23, 23, 168> {};
static_assert(sizeof(ParamSet) == Wire<ParamSet>::length_with_extensions, "PARAM_SET");

struct __attribute__((packed)) GpsRawInt {
    uint64_t time_usec;
    int32_t lat;
    int32_t lon;
    int32_t alt;
    uint16_t eph;
    uint16_t epv;
    uint16_t vel;
    uint16_t cog;
    uint8_t fix_type;
    uint8_t satellites_visible;
    // extensions: MAVLink 2 only
    int32_t alt_ellipsoid;
    uint32_t h_acc;
    uint32_t v_acc;
    uint32_t vel_acc;
    uint32_t hdg_acc;
    uint16_t yaw;
};
template <>
struct Wire<GpsRawInt> : Shape<24, 30, 52, 24> {};
static_assert(sizeof(GpsRawInt) == Wire<GpsRawInt>::length_with_extensions, "GPS_RAW_INT");

struct __attribute__((packed)) ScaledImu {
    uint32_t time_boot_ms;
    int16_t xacc;
    int16_t yacc;
    int16_t zacc;
    int16_t xgyro;
    int16_t ygyro;
    int16_t zgyro;
    int16_t xmag;
    int16_t ymag;
    int16_t zmag;
    // extensions: MAVLink 2 only
    int16_t temperature;
};
template <>
struct Wire<ScaledImu> : Shape<26, 22, 24, 170> {};
static_assert(sizeof(ScaledImu) == Wire<ScaledImu>::length_with_extensions, "SCALED_IMU");

struct __attribute__((packed)) RawImu {
    uint64_t time_usec;
    int16_t xacc;
    int16_t yacc;
    int16_t zacc;
    int16_t xgyro;
    int16_t ygyro;
    int16_t zgyro;
    int16_t xmag;
    int16_t ymag;
    int16_t zmag;
    // extensions: MAVLink 2 only
    uint8_t id;
    int16_t temperature;
};
template <>
struct Wire<RawImu> : Shape<27, 26, 29, 144> {};
static_assert(sizeof(RawImu) == Wire<RawImu>::length_with_extensions, "RAW_IMU");

struct __attribute__((packed)) ScaledPressure {
    uint32_t time_boot_ms;
    float press_abs;
    float press_diff;
    int16_t temperature;
    // extensions: MAVLink 2 only
    int16_t temperature_press_diff;
};
template <>
struct Wire<ScaledPressure> : Shape<29, 14, 16, 115> {};
static_assert(sizeof(ScaledPressure) == Wire<ScaledPressure>::length_with_extensions, "SCALED_PRESSURE");

struct __attribute__((packed)) Attitude {
    uint32_t time_boot_ms;
    float roll;
    float pitch;
    float yaw;
    float rollspeed;
    float pitchspeed;
    float yawspeed;
};
template <>
struct Wire<Attitude> : Shape<30, 28, 28, 39> {};
static_assert(sizeof(Attitude) == Wire<Attitude>::length_with_extensions, "ATTITUDE");

struct __attribute__((packed)) AttitudeQuaternion {
    uint32_t time_boot_ms;
    float q1;
    float q2;
    float q3;
    float q4;
    float rollspeed;
    float pitchspeed;
    float yawspeed;
    // extensions: MAVLink 2 only
    float repr_offset_q[4];
};
template <>
struct Wire<AttitudeQuaternion> : Shape<31, 32, 48, 246> {};
static_assert(sizeof(AttitudeQuaternion) == Wire<AttitudeQuaternion>::length_with_extensions, "ATTITUDE_QUATERNION");

struct __attribute__((packed)) LocalPositionNed {
    uint32_t time_boot_ms;
    float x;
    float y;
    float z;
    float vx;
    float vy;
    float vz;
};
template <>
struct Wire<LocalPositionNed> : Shape<32, 28, 28, 185> {};
static_assert(sizeof(LocalPositionNed) == Wire<LocalPositionNed>::length_with_extensions, "LOCAL_POSITION_NED");

struct __attribute__((packed)) GlobalPositionInt {
    uint32_t time_boot_ms;
    int32_t lat;
    int32_t lon;
    int32_t alt;
    int32_t relative_alt;
    int16_t vx;
    int16_t vy;
    int16_t vz;
    uint16_t hdg;
};
template <>
struct Wire<GlobalPositionInt> : Shape<33, 28, 28, 104> {};
static_assert(sizeof(GlobalPositionInt) == Wire<GlobalPositionInt>::length_with_extensions, "GLOBAL_POSITION_INT");

struct __attribute__((packed)) RcChannelsScaled {
    uint32_t time_boot_ms;
    int16_t chan1_scaled;
    int16_t chan2_scaled;
    int16_t chan3_scaled;
    int16_t chan4_scaled;
    int16_t chan5_scaled;
    int16_t chan6_scaled;
    int16_t chan7_scaled;
    int16_t chan8_scaled;
    uint8_t port;
    uint8_t rssi;
};
template <>
struct Wire<RcChannelsScaled> : Shape<34, 22, 22, 237> {};
static_assert(sizeof(RcChannelsScaled) == Wire<RcChannelsScaled>::length_with_extensions, "RC_CHANNELS_SCALED");

struct __attribute__((packed)) RcChannelsRaw {
    uint32_t time_boot_ms;
    uint16_t chan1_raw;
    uint16_t chan2_raw;
    uint16_t chan3_raw;
    uint16_t chan4_raw;
    uint16_t chan5_raw;
    uint16_t chan6_raw;
    uint16_t chan7_raw;
    uint16_t chan8_raw;
    uint8_t port;
    uint8_t rssi;
};
template <>
struct Wire<RcChannelsRaw> : Shape<35, 22, 22, 244> {};
static_assert(sizeof(RcChannelsRaw) == Wire<RcChannelsRaw>::length_with_extensions, "RC_CHANNELS_RAW");

struct __attribute__((packed)) ServoOutputRaw {
    uint32_t time_usec;
    uint16_t servo1_raw;
    uint16_t servo2_raw;
    uint16_t servo3_raw;
    uint16_t servo4_raw;
    uint16_t servo5_raw;
    uint16_t servo6_raw;
    uint16_t servo7_raw;
    uint16_t servo8_raw;
    uint8_t port;
    // extensions: MAVLink 2 only
    uint16_t servo9_raw;
    uint16_t servo10_raw;
    uint16_t servo11_raw;
    uint16_t servo12_raw;
    uint16_t servo13_raw;
    uint16_t servo14_raw;
    uint16_t servo15_raw;
    uint16_t servo16_raw;
};
template <>
struct Wire<ServoOutputRaw> : Shape<36, 21, 37, 222> {};
static_assert(sizeof(ServoOutputRaw) == Wire<ServoOutputRaw>::length_with_extensions, "SERVO_OUTPUT_RAW");

struct __attribute__((packed)) MissionRequestPartialList {
    int16_t start_index;
    int16_t end_index;
    uint8_t target_system;
    uint8_t target_component;
    // extensions: MAVLink 2 only
    uint8_t mission_type;
};
template <>
struct Wire<MissionRequestPartialList> : Shape<37, 6, 7, 212> {};
static_assert(sizeof(MissionRequestPartialList) == Wire<MissionRequestPartialList>::length_with_extensions, "MISSION_REQUEST_PARTIAL_LIST");

struct __attribute__((packed)) MissionWritePartialList {
    int16_t start_index;
    int16_t end_index;
    uint8_t target_system;
    uint8_t target_component;
    // extensions: MAVLink 2 only
    uint8_t mission_type;
};
template <>
struct Wire<MissionWritePartialList> : Shape<38, 6, 7, 9> {};
static_assert(sizeof(MissionWritePartialList) == Wire<MissionWritePartialList>::length_with_extensions, "MISSION_WRITE_PARTIAL_LIST");

struct __attribute__((packed)) MissionItem {
    float param1;
    float param2;
    float param3;
    float param4;
    float x;
    float y;
    float z;
    uint16_t seq;
    uint16_t command;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t frame;
    uint8_t current;
    uint8_t autocontinue;
    // extensions: MAVLink 2 only
    uint8_t mission_type;
};
template <>
struct Wire<MissionItem> : Shape<39, 37, 38, 254> {};
static_assert(sizeof(MissionItem) == Wire<MissionItem>::length_with_extensions, "MISSION_ITEM");

struct __attribute__((packed)) MissionRequest {
    uint16_t seq;
    uint8_t target_system;
    uint8_t target_component;
    // extensions: MAVLink 2 only
    uint8_t mission_type;
};
template <>
struct Wire<MissionRequest> : Shape<40, 4, 5, 230> {};
static_assert(sizeof(MissionRequest) == Wire<MissionRequest>::length_with_extensions, "MISSION_REQUEST");

struct __attribute__((packed)) MissionSetCurrent {
    uint16_t seq;
    uint8_t target_system;
    uint8_t target_component;
};
template <>
struct Wire<MissionSetCurrent> : Shape<41, 4, 4, 28> {};
static_assert(sizeof(MissionSetCurrent) == Wire<MissionSetCurrent>::length_with_extensions, "MISSION_SET_CURRENT");

struct __attribute__((packed)) MissionCurrent {
    uint16_t seq;
    // extensions: MAVLink 2 only
    uint16_t total;
    uint8_t mission_state;
    uint8_t mission_mode;
    uint32_t mission_id;
    uint32_t fence_id;
    uint32_t rally_points_id;
};
template <>
struct Wire<MissionCurrent> : Shape<42, 2, 18, 28> {};
static_assert(sizeof(MissionCurrent) == Wire<MissionCurrent>::length_with_extensions, "MISSION_CURRENT");

struct __attribute__((packed)) MissionRequestList {
    uint8_t target_system;
    uint8_t target_component;
    // extensions: MAVLink 2 only
    uint8_t mission_type;
};
template <>
struct Wire<MissionRequestList> : Shape<43, 2, 3, 132> {};
static_assert(sizeof(MissionRequestList) == Wire<MissionRequestList>::length_with_extensions, "MISSION_REQUEST_LIST");

struct __attribute__((packed)) MissionCount {
    uint16_t count;
    uint8_t target_system;
    uint8_t target_component;
    // extensions: MAVLink 2 only
    uint8_t mission_type;
    uint32_t opaque_id;
};
template <>
struct Wire<MissionCount> : Shape<44, 4, 9, 221> {};
static_assert(sizeof(MissionCount) == Wire<MissionCount>::length_with_extensions, "MISSION_COUNT");

struct __attribute__((packed)) MissionClearAll {
    uint8_t target_system;
    uint8_t target_component;
    // extensions: MAVLink 2 only
    uint8_t mission_type;
};
template <>
struct Wire<MissionClearAll> : Shape<45, 2, 3, 232> {};
static_assert(sizeof(MissionClearAll) == Wire<MissionClearAll>::length_with_extensions, "MISSION_CLEAR_ALL");

struct __attribute__((packed)) MissionItemReached {
    uint16_t seq;
};
template <>
struct Wire<MissionItemReached> : Shape<46, 2, 2, 11> {};
static_assert(sizeof(MissionItemReached) == Wire<MissionItemReached>::length_with_extensions, "MISSION_ITEM_REACHED");

struct __attribute__((packed)) MissionAck {
    uint8_t target_system;
    uint8_t target_component;
    uint8_t type;
    // extensions: MAVLink 2 only
    uint8_t mission_type;
    uint32_t opaque_id;
};
template <>
struct Wire<MissionAck> : Shape<47, 3, 8, 153> {};
static_assert(sizeof(MissionAck) == Wire<MissionAck>::length_with_extensions, "MISSION_ACK");

struct __attribute__((packed)) MissionRequestInt {
    uint16_t seq;
    uint8_t target_system;
    uint8_t target_component;
    // extensions: MAVLink 2 only
    uint8_t mission_type;
};
template <>
struct Wire<MissionRequestInt> : Shape<51, 4, 5, 196> {};
static_assert(sizeof(MissionRequestInt) == Wire<MissionRequestInt>::length_with_extensions, "MISSION_REQUEST_INT");

struct __attribute__((packed)) NavControllerOutput {
    float nav_roll;
    float nav_pitch;
    float alt_error;
    float aspd_error;
    float xtrack_error;
    int16_t nav_bearing;
    int16_t target_bearing;
    uint16_t wp_dist;
};
template <>
struct Wire<NavControllerOutput> : Shape<62, 26, 26, 183> {};
static_assert(sizeof(NavControllerOutput) == Wire<NavControllerOutput>::length_with_extensions, "NAV_CONTROLLER_OUTPUT");

struct __attribute__((packed)) RcChannels {
    uint32_t time_boot_ms;
    uint16_t chan1_raw;
    uint16_t chan2_raw;
    uint16_t chan3_raw;
    uint16_t chan4_raw;
    uint16_t chan5_raw;
    uint16_t chan6_raw;
    uint16_t chan7_raw;
    uint16_t chan8_raw;
    uint16_t chan9_raw;
    uint16_t chan10_raw;
    uint16_t chan11_raw;
    uint16_t chan12_raw;
    uint16_t chan13_raw;
    uint16_t chan14_raw;
    uint16_t chan15_raw;
    uint16_t chan16_raw;
    uint16_t chan17_raw;
    uint16_t chan18_raw;
    uint8_t chancount;
    uint8_t rssi;
};
template <>
struct Wire<RcChannels> : Shape<65, 42, 42, 118> {};
static_assert(sizeof(RcChannels) == Wire<RcChannels>::length_with_extensions, "RC_CHANNELS");

struct __attribute__((packed)) RequestDataStream {
    uint16_t req_message_rate;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t req_stream_id;
    uint8_t start_stop;
};
template <>
struct Wire<RequestDataStream> : Shape<66, 6, 6, 148> {};
static_assert(sizeof(RequestDataStream) == Wire<RequestDataStream>::length_with_extensions, "REQUEST_DATA_STREAM");

struct __attribute__((packed)) ManualControl {
    int16_t x;
    int16_t y;
    int16_t z;
    int16_t r;
    uint16_t buttons;
    uint8_t target;
    // extensions: MAVLink 2 only
    uint16_t buttons2;
    uint8_t enabled_extensions;
    int16_t s;
    int16_t t;
    int16_t aux1;
    int16_t aux2;
    int16_t aux3;
    int16_t aux4;
    int16_t aux5;
    int16_t aux6;
};
template <>
struct Wire<ManualControl> : Shape<69, 11, 30, 243> {};
static_assert(sizeof(ManualControl) == Wire<ManualControl>::length_with_extensions, "MANUAL_CONTROL");

struct __attribute__((packed)) RcChannelsOverride {
    uint16_t chan1_raw;
    uint16_t chan2_raw;
    uint16_t chan3_raw;
    uint16_t chan4_raw;
    uint16_t chan5_raw;
    uint16_t chan6_raw;
    uint16_t chan7_raw;
    uint16_t chan8_raw;
    uint8_t target_system;
    uint8_t target_component;
    // extensions: MAVLink 2 only
    uint16_t chan9_raw;
    uint16_t chan10_raw;
    uint16_t chan11_raw;
    uint16_t chan12_raw;
    uint16_t chan13_raw;
    uint16_t chan14_raw;
    uint16_t chan15_raw;
    uint16_t chan16_raw;
    uint16_t chan17_raw;
    uint16_t chan18_raw;
};
template <>
struct Wire<RcChannelsOverride> : Shape<70, 18, 38, 124> {};
static_assert(sizeof(RcChannelsOverride) == Wire<RcChannelsOverride>::length_with_extensions, "RC_CHANNELS_OVERRIDE");

struct __attribute__((packed)) MissionItemInt {
    float param1;
    float param2;
    float param3;
    float param4;
    int32_t x;
    int32_t y;
    float z;
    uint16_t seq;
    uint16_t command;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t frame;
    uint8_t current;
    uint8_t autocontinue;
    // extensions: MAVLink 2 only
    uint8_t mission_type;
};
template <>
struct Wire<MissionItemInt> : Shape<73, 37, 38, 38> {};
static_assert(sizeof(MissionItemInt) == Wire<MissionItemInt>::length_with_extensions, "MISSION_ITEM_INT");

struct __attribute__((packed)) VfrHud {
    float airspeed;
    float groundspeed;
    float alt;
    float climb;
    int16_t heading;
    uint16_t throttle;
};
template <>
struct Wire<VfrHud> : Shape<74, 20, 20, 20> {};
static_assert(sizeof(VfrHud) == Wire<VfrHud>::length_with_extensions, "VFR_HUD");

struct __attribute__((packed)) CommandInt {
    float param1;
    float param2;
    float param3;
    float param4;
    int32_t x;
    int32_t y;
    float z;
    uint16_t command;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t frame;
    uint8_t current;
    uint8_t autocontinue;
};
template <>
struct Wire<CommandInt> : Shape<75, 35, 35, 158> {};
static_assert(sizeof(CommandInt) == Wire<CommandInt>::length_with_extensions, "COMMAND_INT");

struct __attribute__((packed)) CommandLong {
    float param1;
    float param2;
    float param3;
    float param4;
    float param5;
    float param6;
    float param7;
    uint16_t command;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t confirmation;
};
template <>
struct Wire<CommandLong> : Shape<76, 33, 33, 152> {};
static_assert(sizeof(CommandLong) == Wire<CommandLong>::length_with_extensions, "COMMAND_LONG");

struct __attribute__((packed)) CommandAck {
    uint16_t command;
    uint8_t result;
    // extensions: MAVLink 2 only
    uint8_t progress;
    int32_t result_param2;
    uint8_t target_system;
    uint8_t target_component;
};
template <>
struct Wire<CommandAck> : Shape<77, 3, 10, 143> {};
static_assert(sizeof(CommandAck) == Wire<CommandAck>::length_with_extensions, "COMMAND_ACK");

struct __attribute__((packed)) SetAttitudeTarget {
    uint32_t time_boot_ms;
    float q[4];
    float body_roll_rate;
    float body_pitch_rate;
    float body_yaw_rate;
    float thrust;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t type_mask;
    // extensions: MAVLink 2 only
    float thrust_body[3];
};
template <>
struct Wire<SetAttitudeTarget> : Shape<82, 39, 51, 49> {};
static_assert(sizeof(SetAttitudeTarget) == Wire<SetAttitudeTarget>::length_with_extensions, "SET_ATTITUDE_TARGET");

struct __attribute__((packed)) SetPositionTargetLocalNed {
    uint32_t time_boot_ms;
    float x;
    float y;
    float z;
    float vx;
    float vy;
    float vz;
    float afx;
    float afy;
    float afz;
    float yaw;
    float yaw_rate;
    uint16_t type_mask;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t coordinate_frame;
};
template <>
struct Wire<SetPositionTargetLocalNed> : Shape<84, 53, 53, 143> {};
static_assert(sizeof(SetPositionTargetLocalNed) == Wire<SetPositionTargetLocalNed>::length_with_extensions, "SET_POSITION_TARGET_LOCAL_NED");

struct __attribute__((packed)) SetPositionTargetGlobalInt {
    uint32_t time_boot_ms;
    int32_t lat_int;
    int32_t lon_int;
    float alt;
    float vx;
    float vy;
    float vz;
    float afx;
    float afy;
    float afz;
    float yaw;
    float yaw_rate;
    uint16_t type_mask;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t coordinate_frame;
};
template <>
struct Wire<SetPositionTargetGlobalInt> : Shape<86, 53, 53, 5> {};
static_assert(sizeof(SetPositionTargetGlobalInt) == Wire<SetPositionTargetGlobalInt>::length_with_extensions, "SET_POSITION_TARGET_GLOBAL_INT");

struct __attribute__((packed)) PositionTargetGlobalInt {
    uint32_t time_boot_ms;
    int32_t lat_int;
    int32_t lon_int;
    float alt;
    float vx;
    float vy;
    float vz;
    float afx;
    float afy;
    float afz;
    float yaw;
    float yaw_rate;
    uint16_t type_mask;
    uint8_t coordinate_frame;
};
template <>
struct Wire<PositionTargetGlobalInt> : Shape<87, 51, 51, 150> {};
static_assert(sizeof(PositionTargetGlobalInt) == Wire<PositionTargetGlobalInt>::length_with_extensions, "POSITION_TARGET_GLOBAL_INT");

struct __attribute__((packed)) RadioStatus {
    uint16_t rxerrors;
    uint16_t fixed;
    uint8_t rssi;
    uint8_t remrssi;
    uint8_t txbuf;
    uint8_t noise;
    uint8_t remnoise;
};
template <>
struct Wire<RadioStatus> : Shape<109, 9, 9, 185> {};
static_assert(sizeof(RadioStatus) == Wire<RadioStatus>::length_with_extensions, "RADIO_STATUS");

struct __attribute__((packed)) FileTransferProtocol {
    uint8_t target_network;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t payload[251];
};
template <>
struct Wire<FileTransferProtocol> : Shape<110, 254, 254, 84> {};
static_assert(sizeof(FileTransferProtocol) == Wire<FileTransferProtocol>::length_with_extensions, "FILE_TRANSFER_PROTOCOL");

struct __attribute__((packed)) Timesync {
    int64_t tc1;
    int64_t ts1;
    // extensions: MAVLink 2 only
    uint8_t target_system;
    uint8_t target_component;
};
template <>
struct Wire<Timesync> : Shape<111, 16, 18, 34> {};
static_assert(sizeof(Timesync) == Wire<Timesync>::length_with_extensions, "TIMESYNC");

struct __attribute__((packed)) LogRequestList {
    uint16_t start;
    uint16_t end;
    uint8_t target_system;
    uint8_t target_component;
};
template <>
struct Wire<LogRequestList> : Shape<117, 6, 6, 128> {};
static_assert(sizeof(LogRequestList) == Wire<LogRequestList>::length_with_extensions, "LOG_REQUEST_LIST");

struct __attribute__((packed)) LogEntry {
    uint32_t time_utc;
    uint32_t size;
    uint16_t id;
    uint16_t num_logs;
    uint16_t last_log_num;
};
template <>
struct Wire<LogEntry> : Shape<118, 14, 14, 56> {};
static_assert(sizeof(LogEntry) == Wire<LogEntry>::length_with_extensions, "LOG_ENTRY");

struct __attribute__((packed)) LogRequestData {
    uint32_t ofs;
    uint32_t count;
    uint16_t id;
    uint8_t target_system;
    uint8_t target_component;
};
template <>
struct Wire<LogRequestData> : Shape<119, 12, 12, 116> {};
static_assert(sizeof(LogRequestData) == Wire<LogRequestData>::length_with_extensions, "LOG_REQUEST_DATA");

struct __attribute__((packed)) LogData {
    uint32_t ofs;
    uint16_t id;
    uint8_t count;
    uint8_t data[90];
};
template <>
struct Wire<LogData> : Shape<120, 97, 97, 134> {};
static_assert(sizeof(LogData) == Wire<LogData>::length_with_extensions, "LOG_DATA");

struct __attribute__((packed)) LogErase {
    uint8_t target_system;
    uint8_t target_component;
};
template <>
struct Wire<LogErase> : Shape<121, 2, 2, 237> {};
static_assert(sizeof(LogErase) == Wire<LogErase>::length_with_extensions, "LOG_ERASE");

struct __attribute__((packed)) LogRequestEnd {
    uint8_t target_system;
    uint8_t target_component;
};
template <>
struct Wire<LogRequestEnd> : Shape<122, 2, 2, 203> {};
static_assert(sizeof(LogRequestEnd) == Wire<LogRequestEnd>::length_with_extensions, "LOG_REQUEST_END");

struct __attribute__((packed)) PowerStatus {
    uint16_t Vcc;
    uint16_t Vservo;
    uint16_t flags;
};
template <>
struct Wire<PowerStatus> : Shape<125, 6, 6, 203> {};
static_assert(sizeof(PowerStatus) == Wire<PowerStatus>::length_with_extensions, "POWER_STATUS");

struct __attribute__((packed)) BatteryStatus {
    int32_t current_consumed;
    int32_t energy_consumed;
    int16_t temperature;
    uint16_t voltages[10];
    int16_t current_battery;
    uint8_t id;
    uint8_t battery_function;
    uint8_t type;
    int8_t battery_remaining;
    // extensions: MAVLink 2 only
    int32_t time_remaining;
    uint8_t charge_state;
    uint16_t voltages_ext[4];
    uint8_t mode;
    uint32_t fault_bitmask;
};
template <>
struct Wire<BatteryStatus> : Shape<147, 36, 54, 154> {};
static_assert(sizeof(BatteryStatus) == Wire<BatteryStatus>::length_with_extensions, "BATTERY_STATUS");

struct __attribute__((packed)) AutopilotVersion {
    uint64_t capabilities;
    uint64_t uid;
    uint32_t flight_sw_version;
    uint32_t middleware_sw_version;
    uint32_t os_sw_version;
    uint32_t board_version;
    uint16_t vendor_id;
    uint16_t product_id;
    uint8_t flight_custom_version[8];
    uint8_t middleware_custom_version[8];
    uint8_t os_custom_version[8];
    // extensions: MAVLink 2 only
    uint8_t uid2[18];
};
template <>
struct Wire<AutopilotVersion> : Shape<148, 60, 78, 178> {};
static_assert(sizeof(AutopilotVersion) == Wire<AutopilotVersion>::length_with_extensions, "AUTOPILOT_VERSION");

struct __attribute__((packed)) Meminfo {
    uint16_t brkval;
    uint16_t freemem;
    // extensions: MAVLink 2 only
    uint32_t freemem32;
};
template <>
struct Wire<Meminfo> : Shape<152, 4, 8, 208> {};
static_assert(sizeof(Meminfo) == Wire<Meminfo>::length_with_extensions, "MEMINFO");

struct __attribute__((packed)) FencePoint {
    float lat;
    float lng;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t idx;
    uint8_t count;
};
template <>
struct Wire<FencePoint> : Shape<160, 12, 12, 78> {};
static_assert(sizeof(FencePoint) == Wire<FencePoint>::length_with_extensions, "FENCE_POINT");

struct __attribute__((packed)) FenceFetchPoint {
    uint8_t target_system;
    uint8_t target_component;
    uint8_t idx;
};
template <>
struct Wire<FenceFetchPoint> : Shape<161, 3, 3, 68> {};
static_assert(sizeof(FenceFetchPoint) == Wire<FenceFetchPoint>::length_with_extensions, "FENCE_FETCH_POINT");

struct __attribute__((packed)) FenceStatus {
    uint32_t breach_time;
    uint16_t breach_count;
    uint8_t breach_status;
    uint8_t breach_type;
    // extensions: MAVLink 2 only
    uint8_t breach_mitigation;
};
template <>
struct Wire<FenceStatus> : Shape<162, 8, 9, 189> {};
static_assert(sizeof(FenceStatus) == Wire<FenceStatus>::length_with_extensions, "FENCE_STATUS");

struct __attribute__((packed)) Ahrs {
    float omegaIx;
    float omegaIy;
    float omegaIz;
    float accel_weight;
    float renorm_val;
    float error_rp;
    float error_yaw;
};
template <>
struct Wire<Ahrs> : Shape<163, 28, 28, 127> {};
static_assert(sizeof(Ahrs) == Wire<Ahrs>::length_with_extensions, "AHRS");

struct __attribute__((packed)) Hwstatus {
    uint16_t Vcc;
    uint8_t I2Cerr;
};
template <>
struct Wire<Hwstatus> : Shape<165, 3, 3, 21> {};
static_assert(sizeof(Hwstatus) == Wire<Hwstatus>::length_with_extensions, "HWSTATUS");

struct __attribute__((packed)) Radio {
    uint16_t rxerrors;
    uint16_t fixed;
    uint8_t rssi;
    uint8_t remrssi;
    uint8_t txbuf;
    uint8_t noise;
    uint8_t remnoise;
};
template <>
struct Wire<Radio> : Shape<166, 9, 9, 21> {};
static_assert(sizeof(Radio) == Wire<Radio>::length_with_extensions, "RADIO");

struct __attribute__((packed)) Wind {
    float direction;
    float speed;
    float speed_z;
};
template <>
struct Wire<Wind> : Shape<168, 12, 12, 1> {};
static_assert(sizeof(Wind) == Wire<Wind>::length_with_extensions, "WIND");

struct __attribute__((packed)) RallyPoint {
    int32_t lat;
    int32_t lng;
    int16_t alt;
    int16_t break_alt;
    uint16_t land_dir;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t idx;
    uint8_t count;
    uint8_t flags;
};
template <>
struct Wire<RallyPoint> : Shape<175, 19, 19, 138> {};
static_assert(sizeof(RallyPoint) == Wire<RallyPoint>::length_with_extensions, "RALLY_POINT");

struct __attribute__((packed)) RallyFetchPoint {
    uint8_t target_system;
    uint8_t target_component;
    uint8_t idx;
};
template <>
struct Wire<RallyFetchPoint> : Shape<176, 3, 3, 234> {};
static_assert(sizeof(RallyFetchPoint) == Wire<RallyFetchPoint>::length_with_extensions, "RALLY_FETCH_POINT");

struct __attribute__((packed)) CameraFeedback {
    uint64_t time_usec;
    int32_t lat;
    int32_t lng;
    float alt_msl;
    float alt_rel;
    float roll;
    float pitch;
    float yaw;
    float foc_len;
    uint16_t img_idx;
    uint8_t target_system;
    uint8_t cam_idx;
    uint8_t flags;
    // extensions: MAVLink 2 only
    uint16_t completed_captures;
};
template <>
struct Wire<CameraFeedback> : Shape<180, 45, 47, 52> {};
static_assert(sizeof(CameraFeedback) == Wire<CameraFeedback>::length_with_extensions, "CAMERA_FEEDBACK");

struct __attribute__((packed)) AutopilotVersionRequest {
    uint8_t target_system;
    uint8_t target_component;
};
template <>
struct Wire<AutopilotVersionRequest> : Shape<183, 2, 2, 85> {};
static_assert(sizeof(AutopilotVersionRequest) == Wire<AutopilotVersionRequest>::length_with_extensions, "AUTOPILOT_VERSION_REQUEST");

struct __attribute__((packed)) MagCalProgress {
    float direction_x;
    float direction_y;
    float direction_z;
    uint8_t compass_id;
    uint8_t cal_mask;
    uint8_t cal_status;
    uint8_t attempt;
    uint8_t completion_pct;
    uint8_t completion_mask[10];
};
template <>
struct Wire<MagCalProgress> : Shape<191, 27, 27, 92> {};
static_assert(sizeof(MagCalProgress) == Wire<MagCalProgress>::length_with_extensions, "MAG_CAL_PROGRESS");

struct __attribute__((packed)) MagCalReport {
    float fitness;
    float ofs_x;
    float ofs_y;
    float ofs_z;
    float diag_x;
    float diag_y;
    float diag_z;
    float offdiag_x;
    float offdiag_y;
    float offdiag_z;
    uint8_t compass_id;
    uint8_t cal_mask;
    uint8_t cal_status;
    uint8_t autosaved;
    // extensions: MAVLink 2 only
    float orientation_confidence;
    uint8_t old_orientation;
    uint8_t new_orientation;
    float scale_factor;
};
template <>
struct Wire<MagCalReport> : Shape<192, 44, 54, 36> {};
static_assert(sizeof(MagCalReport) == Wire<MagCalReport>::length_with_extensions, "MAG_CAL_REPORT");

struct __attribute__((packed)) EkfStatusReport {
    float velocity_variance;
    float pos_horiz_variance;
    float pos_vert_variance;
    float compass_variance;
    float terrain_alt_variance;
    uint16_t flags;
    // extensions: MAVLink 2 only
    float airspeed_variance;
};
template <>
struct Wire<EkfStatusReport> : Shape<193, 22, 26, 71> {};
static_assert(sizeof(EkfStatusReport) == Wire<EkfStatusReport>::length_with_extensions, "EKF_STATUS_REPORT");

struct __attribute__((packed)) Vibration {
    uint64_t time_usec;
    float vibration_x;
    float vibration_y;
    float vibration_z;
    uint32_t clipping_0;
    uint32_t clipping_1;
    uint32_t clipping_2;
};
template <>
struct Wire<Vibration> : Shape<241, 32, 32, 90> {};
static_assert(sizeof(Vibration) == Wire<Vibration>::length_with_extensions, "VIBRATION");

struct __attribute__((packed)) HomePosition {
    int32_t latitude;
    int32_t longitude;
    int32_t altitude;
    float x;
    float y;
    float z;
    float q[4];
    float approach_x;
    float approach_y;
    float approach_z;
    // extensions: MAVLink 2 only
    uint64_t time_usec;
};
template <>
struct Wire<HomePosition> : Shape<242, 52, 60, 104> {};
static_assert(sizeof(HomePosition) == Wire<HomePosition>::length_with_extensions, "HOME_POSITION");

struct __attribute__((packed)) MessageInterval {
    int32_t interval_us;
    uint16_t message_id;
};
template <>
struct Wire<MessageInterval> : Shape<244, 6, 6, 95> {};
static_assert(sizeof(MessageInterval) == Wire<MessageInterval>::length_with_extensions, "MESSAGE_INTERVAL");

struct __attribute__((packed)) ExtendedSysState {
    uint8_t vtol_state;
    uint8_t landed_state;
};
template <>
struct Wire<ExtendedSysState> : Shape<245, 2, 2, 130> {};
static_assert(sizeof(ExtendedSysState) == Wire<ExtendedSysState>::length_with_extensions, "EXTENDED_SYS_STATE");

struct __attribute__((packed)) Statustext {
    uint8_t severity;
    char text[50];
    // extensions: MAVLink 2 only
    uint16_t id;
    uint8_t chunk_seq;
};
template <>
struct Wire<Statustext> : Shape<253, 51, 54, 83> {};
static_assert(sizeof(Statustext) == Wire<Statustext>::length_with_extensions, "STATUSTEXT");

struct __attribute__((packed)) SetupSigning {
    uint64_t initial_timestamp;
    uint8_t target_system;
    uint8_t target_component;
    uint8_t secret_key[32];
};
template <>
struct Wire<SetupSigning> : Shape<256, 42, 42, 71> {};
static_assert(sizeof(SetupSigning) == Wire<SetupSigning>::length_with_extensions, "SETUP_SIGNING");

struct __attribute__((packed)) ProtocolVersion {
    uint16_t version;
    uint16_t min_version;
    uint16_t max_version;
    uint8_t spec_version_hash[8];
    uint8_t library_version_hash[8];
};
template <>
struct Wire<ProtocolVersion> : Shape<300, 22, 22, 217> {};
static_assert(sizeof(ProtocolVersion) == Wire<ProtocolVersion>::length_with_extensions, "PROTOCOL_VERSION");

struct __attribute__((packed)) AvailableModes {
    uint32_t custom_mode;
    uint32_t properties;
    uint8_t number_modes;
    uint8_t mode_index;
    uint8_t standard_mode;
    char mode_name[35];
};
template <>
struct Wire<AvailableModes> : Shape<435, 46, 46, 134> {};
static_assert(sizeof(AvailableModes) == Wire<AvailableModes>::length_with_extensions, "AVAILABLE_MODES");

struct __attribute__((packed)) CurrentMode {
    uint32_t custom_mode;
    uint32_t intended_custom_mode;
    uint8_t standard_mode;
};
template <>
struct Wire<CurrentMode> : Shape<436, 9, 9, 193> {};
static_assert(sizeof(CurrentMode) == Wire<CurrentMode>::length_with_extensions, "CURRENT_MODE");

}  // namespace mavlink
// clang-format on

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/reported.hpp"

#include <cmath>

#include "simulator/constants.hpp"

namespace simulator {
namespace {

constexpr uint16_t kUnknown = 0xFFFF;

Reported::Value known(uint16_t value, double scale) {
    return value == kUnknown ? Reported::Value() : value * scale;
}

void takeFlight(Reported& to, const Telemetry& from) {
    if (from.position) {
        to.latitude_deg = from.position->lat * 1e-7;
        to.longitude_deg = from.position->lon * 1e-7;
    }
    if (from.hud) {
        to.ground_speed_mps = from.hud->groundspeed;
        to.climb_mps = from.hud->climb;
        to.throttle_percent = from.hud->throttle;
    }
    if (from.wind) {
        to.wind_mps = from.wind->speed;
        to.wind_from_deg = from.wind->direction < 0 ? from.wind->direction + 360.0
                                                    : static_cast<double>(from.wind->direction);
    }
}

// The errors are demand less estimate. They mean something where it navigates.
void takeDemands(Reported& to, const Telemetry& from) {
    if (!from.navigation || from.mode() != kModeAuto) return;
    if (from.position)
        to.height_demand_m = from.position->relative_alt * 0.001 + from.navigation->alt_error;
    if (from.hud) to.airspeed_demand_mps = from.hud->airspeed + from.navigation->aspd_error;
    to.bearing_demand_deg = from.navigation->nav_bearing;
    to.crosstrack_m = from.navigation->xtrack_error;
}

void takeState(Reported& to, const Telemetry& from) {
    if (from.status) {
        to.battery_v = known(from.status->voltage_battery, 1e-3);
        if (from.status->current_battery >= 0) to.battery_a = from.status->current_battery * 0.01;
        if (from.status->battery_remaining >= 0)
            to.battery_percent = from.status->battery_remaining;
        to.load_percent = from.status->load * 0.1;
    }
    if (from.hardware) to.board_v = from.hardware->Vcc * 1e-3;
    if (!from.gps) return;
    to.satellites = from.gps->satellites_visible;
    to.fix = from.gps->fix_type;
    to.hdop = known(from.gps->eph, 0.01);
    to.gps_speed_mps = known(from.gps->vel, 0.01);
    to.gps_course_deg = known(from.gps->cog, 0.01);
}

// RAW_IMU in millirad/s and milli-g, as ArduPilot sends it.
void takeInertial(Reported& to, const mavlink::RawImu& imu) {
    const int16_t turns[] = {imu.xgyro, imu.ygyro, imu.zgyro};
    const int16_t forces[] = {imu.xacc, imu.yacc, imu.zacc};
    for (int i = 0; i < 3; ++i) {
        to.gyro_dps[i] = turns[i] * 1e-3 * kDegrees;
        to.acceleration_mss[i] = forces[i] * 1e-3 * kGravity_mss;
    }
}

void takeRadio(Reported& to, const mavlink::RcChannels& rc) {
    const uint16_t pulses[] = {rc.chan1_raw, rc.chan2_raw, rc.chan3_raw, rc.chan4_raw,
                               rc.chan5_raw, rc.chan6_raw, rc.chan7_raw, rc.chan8_raw};
    for (size_t i = 0; i < to.rc_us.size(); ++i)
        if (pulses[i] != 0) to.rc_us[i] = known(pulses[i], 1);
}

}  // namespace

Reported reportedBy(const Telemetry& telemetry) {
    Reported reported;
    takeFlight(reported, telemetry);
    takeDemands(reported, telemetry);
    takeState(reported, telemetry);
    if (telemetry.imu) takeInertial(reported, *telemetry.imu);
    if (telemetry.rc) takeRadio(reported, *telemetry.rc);
    return reported;
}

}  // namespace simulator

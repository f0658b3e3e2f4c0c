// SPDX-License-Identifier: GPL-3.0-or-later
// The recording for other programs, as a table.
#include <cmath>
#include <cstdio>
#include <functional>

#include "simulator/constants.hpp"
#include "simulator/report/recorder.hpp"

namespace simulator {
namespace {

struct Column {
    const char* name;
    int decimals;
    std::function<std::optional<double>(const Sample&)> value;
};

// clang-format off
const Column kColumns[] = {
    {"time_s",                  2, [](const Sample& s) { return s.time_s; }},
    {"mode",                    0, [](const Sample& s) { return s.mode < 0 ? std::optional<double>() : s.mode; }},
    {"armed",                   0, [](const Sample& s) { return s.armed ? 1.0 : 0.0; }},
    {"item",                    0, [](const Sample& s) { return double(s.item); }},
    {"latitude_deg",            7, [](const Sample& s) { return s.truth.latitude_deg; }},
    {"longitude_deg",           7, [](const Sample& s) { return s.truth.longitude_deg; }},
    {"north_m",                 2, [](const Sample& s) { return s.place.north_m; }},
    {"east_m",                  2, [](const Sample& s) { return s.place.east_m; }},
    {"height_m",                2, [](const Sample& s) { return s.truth.height_m; }},
    {"planned_height_m",        2, [](const Sample& s) { return s.planned.height_m; }},
    {"reported_height_m",           2, [](const Sample& s) { return s.height_m; }},
    {"crosstrack_m",            2, [](const Sample& s) { return s.planned.crosstrack_m; }},
    {"leg_captured",            0, [](const Sample& s) { return s.planned.counts ? 1.0 : 0.0; }},
    {"ground_speed_mps",        2, [](const Sample& s) { return std::hypot(s.truth.velocity_north_mps, s.truth.velocity_east_mps); }},
    {"climb_mps",               2, [](const Sample& s) { return -s.truth.velocity_down_mps; }},
    {"equivalent_airspeed_mps", 2, [](const Sample& s) { return s.truth.equivalent_airspeed_mps; }},
    {"planned_airspeed_mps",    2, [](const Sample& s) { return s.planned.airspeed_mps; }},
    {"reported_airspeed_mps",       2, [](const Sample& s) { return s.airspeed_mps; }},
    {"roll_deg",                2, [](const Sample& s) { return s.truth.roll_rad * kDegrees; }},
    {"pitch_deg",               2, [](const Sample& s) { return s.truth.pitch_rad * kDegrees; }},
    {"yaw_deg",                 2, [](const Sample& s) { return s.truth.yaw_rad * kDegrees; }},
    {"reported_roll_deg",           2, [](const Sample& s) { return s.roll_deg; }},
    {"reported_pitch_deg",          2, [](const Sample& s) { return s.pitch_deg; }},
    {"reported_yaw_deg",            2, [](const Sample& s) { return s.yaw_deg; }},
    {"roll_demand_deg",         2, [](const Sample& s) { return s.roll_demand_deg; }},
    {"pitch_demand_deg",        2, [](const Sample& s) { return s.pitch_demand_deg; }},
    {"angle_of_attack_deg",     2, [](const Sample& s) { return s.truth.alpha_rad * kDegrees; }},
    {"sideslip_deg",            2, [](const Sample& s) { return s.truth.beta_rad * kDegrees; }},
    {"wind_north_mps",          2, [](const Sample& s) { return s.truth.wind_north_mps; }},
    {"wind_east_mps",           2, [](const Sample& s) { return s.truth.wind_east_mps; }},
    {"servo1_us",               1, [](const Sample& s) { return s.servo_us[0]; }},
    {"servo2_us",               1, [](const Sample& s) { return s.servo_us[1]; }},
    {"servo3_us",               1, [](const Sample& s) { return s.servo_us[2]; }},
    {"servo4_us",               1, [](const Sample& s) { return s.servo_us[3]; }},
    {"servo5_us",               1, [](const Sample& s) { return s.servo_us[4]; }},
    {"servo6_us",               1, [](const Sample& s) { return s.servo_us[5]; }},
    {"servo7_us",               1, [](const Sample& s) { return s.servo_us[6]; }},
    {"servo8_us",               1, [](const Sample& s) { return s.servo_us[7]; }},
    {"battery_v",               2, [](const Sample& s) { return s.truth.battery_v; }},
    {"motor_current_a",         2, [](const Sample& s) { return s.truth.motor_current_a; }},
    {"mean_frame_us",           0, [](const Sample& s) { return s.frame_mean_us; }},
    {"longest_frame_us",        0, [](const Sample& s) { return s.frame_us; }},
};
// clang-format on

std::string number(double value, int decimals) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

}  // namespace

std::string flightCsv(const std::vector<Sample>& samples) {
    std::string text;
    for (const Column& column : kColumns) {
        text += (&column == kColumns ? "" : ",") + std::string(column.name);
    }
    text += '\n';
    for (const Sample& sample : samples) {
        for (const Column& column : kColumns) {
            if (&column != kColumns) text += ',';
            if (auto value = column.value(sample)) text += number(*value, column.decimals);
        }
        text += '\n';
    }
    return text;
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/samples.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "simulator/constants.hpp"
#include "simulator/devices/ppm_encoder.hpp"

namespace simulator::live {
namespace {

constexpr double kMilliG_mss = 1e-3 * kGravity_mss;  // RAW_IMU, as ArduPilot sends it

struct Moment {
    const Truth& truth;
    const Telemetry& said;
    World& world;
    std::optional<double> frame_us;
};
using Value = std::optional<double>;

double heading(double angle_rad) {
    const double deg = angle_rad * kDegrees;
    return deg < 0 ? deg + 360 : deg;
}

// Where it comes from; nothing in calm air.
Value windFrom(const Truth& t) {
    if (std::hypot(t.wind_north_mps, t.wind_east_mps) < 0.05) return std::nullopt;
    return heading(std::atan2(-t.wind_east_mps, -t.wind_north_mps));
}

double energyHeight_m(const Truth& t) {
    return t.height_m + t.airspeed_mps * t.airspeed_mps / (2 * kGravity_mss);
}

struct Row {
    const char *name, *title, *unit, *group, *kind;
    int decimals;
    Value (*value)(const Moment&);
};

#define OF_TRUTH(expression)       \
    [](const Moment& m) -> Value { \
        const Truth& t = m.truth;  \
        return expression;         \
    }
#define OF(message, expression)                   \
    [](const Moment& m) -> Value {                \
        if (!m.said.message) return std::nullopt; \
        const auto& x = *m.said.message;          \
        return expression;                        \
    }
#define OF_OUTPUT(number) [](const Moment& m) -> Value { return m.world.servoPulse_us(number); }
#define OF_STICK(number)                                   \
    [](const Moment& m) -> Value {                         \
        if (!m.world.radio().heard()) return std::nullopt; \
        return m.world.radio().sticks()[number - 1];       \
    }
// clang-format off
constexpr Row kRows[] = {
    {"lat_deg", "latitude", "°", "", "truth", 7, OF_TRUTH(t.latitude_deg)},
    {"lon_deg", "longitude", "°", "", "truth", 7, OF_TRUTH(t.longitude_deg)},
    {"altitude_m", "altitude above the sea", "m", "", "truth", 2, OF_TRUTH(t.altitude_m)},
    {"height_m", "height", "m", "height", "truth", 2, OF_TRUTH(t.height_m)},
    {"height_m", "height", "m", "height", "estimate", 2, OF(position, x.relative_alt * 1e-3)},
    {"height_m", "height", "m", "height", "demand", 2, [](const Moment& m) -> Value {
        if (!m.said.navigation || !m.said.position) return std::nullopt;
        return m.said.position->relative_alt * 1e-3 + m.said.navigation->alt_error; }},
    {"roll_deg", "roll", "°", "roll", "truth", 2, OF_TRUTH(t.roll_rad * kDegrees)},
    {"roll_deg", "roll", "°", "roll", "estimate", 2, OF(attitude, x.roll * kDegrees)},
    {"roll_deg", "roll", "°", "roll", "demand", 2, OF(navigation, double{x.nav_roll})},
    {"pitch_deg", "pitch", "°", "pitch", "truth", 2, OF_TRUTH(t.pitch_rad * kDegrees)},
    {"pitch_deg", "pitch", "°", "pitch", "estimate", 2, OF(attitude, x.pitch * kDegrees)},
    {"pitch_deg", "pitch", "°", "pitch", "demand", 2, OF(navigation, double{x.nav_pitch})},
    {"yaw_deg", "yaw", "°", "heading", "truth", 2, OF_TRUTH(heading(t.yaw_rad))},
    {"yaw_deg", "yaw", "°", "heading", "estimate", 2, OF(attitude, heading(double{x.yaw}))},
    {"bearing_deg", "bearing", "°", "heading", "demand", 0, OF(navigation, heading(x.nav_bearing / kDegrees))},
    {"airspeed_mps", "airspeed", "m/s", "speed", "truth", 2, OF_TRUTH(t.equivalent_airspeed_mps)},
    {"airspeed_mps", "airspeed", "m/s", "speed", "measured", 2, OF(hud, double{x.airspeed})},
    {"ground_speed_mps", "ground speed", "m/s", "speed", "truth", 2,
     OF_TRUTH(std::hypot(t.velocity_north_mps, t.velocity_east_mps))},
    {"ground_speed_mps", "ground speed", "m/s", "speed", "estimate", 2, OF(hud, double{x.groundspeed})},
    {"climb_mps", "climb", "m/s", "climb", "truth", 2, OF_TRUTH(-t.velocity_down_mps)},
    {"climb_mps", "climb", "m/s", "climb", "estimate", 2, OF(hud, double{x.climb})},
    {"crosstrack_m", "crosstrack", "m", "track", "estimate", 1, OF(navigation, double{x.xtrack_error})},
    {"throttle_percent", "throttle", "%", "controls", "truth", 1, OF_TRUTH(t.throttle * 100)},
    {"aileron_percent", "aileron", "%", "controls", "truth", 1, OF_TRUTH(t.aileron * 100)},
    {"elevator_percent", "elevator", "%", "controls", "truth", 1, OF_TRUTH(t.elevator * 100)},
    {"rudder_percent", "rudder", "%", "controls", "truth", 1, OF_TRUTH(t.rudder * 100)},
    {"servo1_us", "output 1", "µs", "servos", "measured", 0, OF_OUTPUT(1)},
    {"servo2_us", "output 2", "µs", "servos", "measured", 0, OF_OUTPUT(2)},
    {"servo3_us", "output 3", "µs", "servos", "measured", 0, OF_OUTPUT(3)},
    {"servo4_us", "output 4", "µs", "servos", "measured", 0, OF_OUTPUT(4)},
    {"servo5_us", "output 5", "µs", "servos", "measured", 0, OF_OUTPUT(5)},
    {"servo6_us", "output 6", "µs", "servos", "measured", 0, OF_OUTPUT(6)},
    {"servo7_us", "output 7", "µs", "servos", "measured", 0, OF_OUTPUT(7)},
    {"servo8_us", "output 8", "µs", "servos", "measured", 0, OF_OUTPUT(8)},
    {"rc1_us", "input 1", "µs", "rc", "measured", 0, OF_STICK(1)},
    {"rc2_us", "input 2", "µs", "rc", "measured", 0, OF_STICK(2)},
    {"rc3_us", "input 3", "µs", "rc", "measured", 0, OF_STICK(3)},
    {"rc4_us", "input 4", "µs", "rc", "measured", 0, OF_STICK(4)},
    {"rc5_us", "input 5", "µs", "rc", "measured", 0, OF_STICK(5)},
    {"rc6_us", "input 6", "µs", "rc", "measured", 0, OF_STICK(6)},
    {"rc7_us", "input 7", "µs", "rc", "measured", 0, OF_STICK(7)},
    {"rc8_us", "input 8", "µs", "rc", "measured", 0, OF_STICK(8)},
    {"energy_height_m", "energy as height", "m", "energy", "truth", 1, OF_TRUTH(energyHeight_m(t))},
    {"battery_used_mah", "used", "mAh", "energy", "truth", 0, OF_TRUTH(t.battery_used_mah)},
    {"battery_v", "voltage", "V", "battery", "truth", 2, OF_TRUTH(t.battery_v)},
    {"battery_v", "voltage", "V", "battery", "estimate", 2, OF(status, x.voltage_battery * 1e-3)},
    {"battery_a", "current", "A", "battery", "truth", 2, OF_TRUTH(t.motor_current_a)},
    {"board_v", "board supply", "V", "battery", "measured", 2, OF(hardware, x.Vcc * 1e-3)},
    {"wind_mps", "wind", "m/s", "wind", "truth", 1, OF_TRUTH(std::hypot(t.wind_north_mps, t.wind_east_mps))},
    {"wind_from_deg", "wind from", "°", "wind", "truth", 0, OF_TRUTH(windFrom(t))},
    {"wind_mps", "wind", "m/s", "wind", "estimate", 1, OF(wind, double{x.speed})},
    {"wind_from_deg", "wind from", "°", "wind", "estimate", 0, OF(wind, heading(x.direction / kDegrees))},
    {"satellites", "satellites", "", "gps", "measured", 0, OF(gps, double(x.satellites_visible))},
    {"hdop", "HDOP", "", "gps", "measured", 2, OF(gps, x.eph * 0.01)},
    {"gps_fix", "fix", "", "gps", "measured", 0, OF(gps, double(x.fix_type))},
    {"gps_speed_mps", "GPS speed", "m/s", "gps", "measured", 2, OF(gps, x.vel * 0.01)},
    {"roll_rate_dps", "roll", "°/s", "rates", "truth", 1, OF_TRUTH(t.roll_rate_rads * kDegrees)},
    {"pitch_rate_dps", "pitch", "°/s", "rates", "truth", 1, OF_TRUTH(t.pitch_rate_rads * kDegrees)},
    {"yaw_rate_dps", "yaw", "°/s", "rates", "truth", 1, OF_TRUTH(t.yaw_rate_rads * kDegrees)},
    {"acceleration_x_mss", "acceleration x", "m/s²", "vibration", "measured", 2, OF(imu, x.xacc * kMilliG_mss)},
    {"acceleration_y_mss", "acceleration y", "m/s²", "vibration", "measured", 2, OF(imu, x.yacc * kMilliG_mss)},
    {"acceleration_z_mss", "acceleration z", "m/s²", "vibration", "measured", 2, OF(imu, x.zacc * kMilliG_mss)},
    {"cpu_percent", "load reported", "%", "cpu", "measured", 1, OF(status, x.load * 0.1)},
    {"frame_us", "last frame", "µs", "frames", "measured", 0, [](const Moment& m) { return m.frame_us; }},
};
// clang-format on
#undef OF_TRUTH
#undef OF
#undef OF_OUTPUT
#undef OF_STICK

std::string keyOf(const Row& row) {
    const std::string kind = row.kind;
    return kind == "truth" ? row.name : row.name + (":" + kind);
}

std::string text(const Row& row, const Moment& moment) {
    const Value value = row.value(moment);
    if (!value || !std::isfinite(*value)) return "null";
    char digits[48];
    std::snprintf(digits, sizeof digits, "%.*f", row.decimals, *value);
    return digits;
}

}  // namespace

Json seriesJson() {
    Json all = Json::array();
    for (const Row& row : kRows)
        all.push_back({{"name", row.name},
                       {"title", row.title},
                       {"unit", row.unit},
                       {"group", row.group},
                       {"kind", row.kind},
                       {"time", 0},
                       {"values", Json::array()}});
    return all;
}

// Ten a second, thousands when a flight goes as fast as it can: written by hand.
std::string sampleJson(Board& board, const Telemetry& telemetry) {
    const Moment moment = {board.world().truth(), telemetry, board.world(), board.lastFrame_us()};
    char time[48];
    std::snprintf(time, sizeof time, "%.2f", static_cast<double>(board.time_us()) * 1e-6);
    std::string json = std::string("{\"time_s\":") + time + ",\"values\":{";
    for (const Row& row : kRows) {
        if (&row != kRows) json += ',';
        json += '"' + keyOf(row) + "\":" + text(row, moment);
    }
    return json + "}}";
}

}  // namespace simulator::live

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/samples.hpp"

#include <cmath>
#include <optional>

#include "simulator/devices/ppm_encoder.hpp"

namespace simulator::live {
namespace {

constexpr double kDegrees = 180 / M_PI;

struct Moment {
    const Truth& truth;
    const Telemetry& said;
    World& world;
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
    {"lat_deg", "latitude", "deg", "", "truth", 7, OF_TRUTH(t.latitude_deg)},
    {"lon_deg", "longitude", "deg", "", "truth", 7, OF_TRUTH(t.longitude_deg)},
    {"altitude_m", "altitude", "m", "", "truth", 2, OF_TRUTH(t.altitude_m)},
    {"height_m", "height", "m", "height", "truth", 2, OF_TRUTH(t.height_m)},
    {"height_m", "height", "m", "height", "estimate", 2, OF(position, x.relative_alt * 1e-3)},
    {"height_m", "height", "m", "height", "demand", 2, [](const Moment& m) -> Value {
        if (!m.said.navigation || !m.said.position) return std::nullopt;
        return m.said.position->relative_alt * 1e-3 + m.said.navigation->alt_error; }},
    {"roll_deg", "roll", "deg", "roll", "truth", 2, OF_TRUTH(t.roll_rad * kDegrees)},
    {"roll_deg", "roll", "deg", "roll", "estimate", 2, OF(attitude, x.roll * kDegrees)},
    {"roll_deg", "roll", "deg", "roll", "demand", 2, OF(navigation, double{x.nav_roll})},
    {"pitch_deg", "pitch", "deg", "pitch", "truth", 2, OF_TRUTH(t.pitch_rad * kDegrees)},
    {"pitch_deg", "pitch", "deg", "pitch", "estimate", 2, OF(attitude, x.pitch * kDegrees)},
    {"pitch_deg", "pitch", "deg", "pitch", "demand", 2, OF(navigation, double{x.nav_pitch})},
    {"yaw_deg", "heading", "deg", "heading", "truth", 2, OF_TRUTH(heading(t.yaw_rad))},
    {"yaw_deg", "heading", "deg", "heading", "estimate", 2, OF(attitude, heading(double{x.yaw}))},
    {"bearing_deg", "bearing", "deg", "heading", "demand", 0, OF(navigation, heading(x.nav_bearing / kDegrees))},
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
    {"servo1_us", "servo 1", "us", "servos", "measured", 0, OF_OUTPUT(1)},
    {"servo2_us", "servo 2", "us", "servos", "measured", 0, OF_OUTPUT(2)},
    {"servo3_us", "servo 3", "us", "servos", "measured", 0, OF_OUTPUT(3)},
    {"servo4_us", "servo 4", "us", "servos", "measured", 0, OF_OUTPUT(4)},
    {"rc1_us", "roll stick", "us", "rc", "measured", 0, OF_STICK(1)},
    {"rc2_us", "pitch stick", "us", "rc", "measured", 0, OF_STICK(2)},
    {"rc3_us", "throttle stick", "us", "rc", "measured", 0, OF_STICK(3)},
    {"rc4_us", "yaw stick", "us", "rc", "measured", 0, OF_STICK(4)},
    {"battery_v", "battery", "V", "battery", "truth", 2, OF_TRUTH(t.battery_v)},
    {"battery_v", "battery", "V", "battery", "measured", 2, OF(status, x.voltage_battery * 1e-3)},
    {"current_a", "current", "A", "battery", "truth", 2, OF_TRUTH(t.motor_current_a)},
    {"wind_mps", "wind", "m/s", "wind", "truth", 1, OF_TRUTH(std::hypot(t.wind_north_mps, t.wind_east_mps))},
    {"wind_from_deg", "wind from", "deg", "wind", "truth", 0, OF_TRUTH(windFrom(t))},
    {"satellites", "satellites", "", "gps", "measured", 0, OF(gps, double(x.satellites_visible))},
    {"hdop", "HDOP", "", "gps", "measured", 2, OF(gps, x.eph * 0.01)},
    {"load_percent", "load", "%", "cpu", "measured", 1, OF(status, x.load * 0.1)},
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
    const Moment moment = {board.world().truth(), telemetry, board.world()};
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/world_file.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "simulator/input_file.hpp"

namespace simulator {
namespace {

using Json = nlohmann::ordered_json;

struct Row {
    const char* key;
    double WorldOptions::*value;
    double least, most;
};
constexpr Row kRows[] = {
    {"wind_mps", &WorldOptions::wind_mps, 0, 30},
    {"wind_from_deg", &WorldOptions::wind_from_deg, 0, 360},
    {"thermal_mps", &WorldOptions::thermal_mps, 0, 10},
    {"declination_deg", &WorldOptions::declination_deg, -180, 180},
    {"inclination_deg", &WorldOptions::inclination_deg, -90, 90},
    {"magnetic_field_mg", &WorldOptions::magnetic_field_mg, 0, 1000},
    {"board_warmth_c", &WorldOptions::board_warmth_c, -20, 40},
    {"board_warmth_start_c", &WorldOptions::board_warmth_start_c, -20, 40},
};

struct ErrorKey {
    const char* key;
    double SensorErrors::*value;
    double most;
};
constexpr ErrorKey kErrors[] = {
    {"gyro_bias_dps", &SensorErrors::gyro_bias_dps, 20},
    {"gyro_noise_dps", &SensorErrors::gyro_noise_dps, 20},
    {"gyro_vibration_dps", &SensorErrors::gyro_vibration_dps, 50},
    {"accel_bias_g", &SensorErrors::accel_bias_g, 0.2},
    {"accel_scale", &SensorErrors::accel_scale, 0.2},
    {"accel_noise_g", &SensorErrors::accel_noise_g, 1},
    {"accel_vibration_g", &SensorErrors::accel_vibration_g, 5},
    {"compass_noise_mg", &SensorErrors::compass_noise_mg, 100},
    {"compass_offset_mg", &SensorErrors::compass_offset_mg, 1000},
    {"baro_noise_pa", &SensorErrors::baro_noise_pa, 100},
    {"baro_drift_pa", &SensorErrors::baro_drift_pa, 100},
    {"baro_drift_s", &SensorErrors::baro_drift_s, 1e5},
    {"airspeed_noise_v", &SensorErrors::airspeed_noise_v, 1},
    {"airspeed_offset_v", &SensorErrors::airspeed_offset_v, 1},
    {"airspeed_ratio", &SensorErrors::airspeed_ratio, 0.5},
    {"gps_horizontal_m", &SensorErrors::gps_horizontal_m, 50},
    {"gps_vertical_m", &SensorErrors::gps_vertical_m, 50},
    {"gps_wander_s", &SensorErrors::gps_wander_s, 1e5},
    {"gps_velocity_mps", &SensorErrors::gps_velocity_mps, 10},
    {"gps_age_s", &SensorErrors::gps_age_s, 1},
    {"gps_rate_hz", &SensorErrors::gps_rate_hz, 10},
    {"gust_mps", &SensorErrors::gust_mps, 5},
};
static_assert(std::size(kErrors) == kErrorCount, "every error has its key");

double numberOf(const Json& json, const std::string& key, double least, double most) {
    if (!json.is_number()) throw std::runtime_error("'" + key + "': expected a number");
    const double value = json.get<double>();
    if (!(value >= least && value <= most)) {
        const Json limits = {least, most};
        throw std::runtime_error("'" + key + "': expected " + limits[0].dump() + " to " +
                                 limits[1].dump() + ", not " + json.dump());
    }
    return value;
}

void readErrors(const Json& json, SensorErrors& errors) {
    for (const auto& [key, value] : json.items()) {
        const ErrorKey* row = nullptr;
        for (const ErrorKey& each : kErrors)
            if (key == each.key) row = &each;
        if (!row) throw std::runtime_error("does not know 'errors/" + key + "'");
        errors.*row->value = numberOf(value, key, 0, row->most);
    }
}

void readMotorField(const Json& json, WorldOptions& world) {
    if (!json.is_array() || json.size() != world.motor_field_mg_a.size())
        throw std::runtime_error("'motor_field_mg_a': expected three numbers");
    for (size_t i = 0; i < world.motor_field_mg_a.size(); ++i)
        world.motor_field_mg_a[i] = numberOf(json[i], "motor_field_mg_a", -100, 100);
}

void readRow(const std::string& key, const Json& json, WorldOptions& world) {
    for (const Row& row : kRows)
        if (key == row.key) {
            world.*row.value = numberOf(json, key, row.least, row.most);
            return;
        }
    throw std::runtime_error("does not know '" + key + "'");
}

void read(const Json& json, WorldOptions& world) {
    if (!json.is_object()) throw std::runtime_error("expected a JSON object");
    SensorErrors errors = world.errors.value_or(SensorErrors{});
    for (const auto& [key, value] : json.items()) {
        if (key == "errors")
            readErrors(value, errors);
        else if (key == "motor_field_mg_a")
            readMotorField(value, world);
        else if (key != "about")
            readRow(key, value, world);
    }
    world.errors = errors;
    world.gusts = errors.gust_mps > 0;
    world.gps_latency_s = errors.gps_age_s;
}

Json parsed(const std::string& text) {
    if (text.empty()) throw std::runtime_error("expected JSON, found nothing");
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const auto end = text.begin() + std::min<ptrdiff_t>(static_cast<ptrdiff_t>(error.byte),
                                                            static_cast<ptrdiff_t>(text.size()));
        throw std::runtime_error("expected JSON, found an error in line " +
                                 std::to_string(1 + std::count(text.begin(), end, '\n')));
    }
}

}  // namespace

void readWorldFile(const std::string& path, WorldOptions& world) {
    const auto text = wholeFile(path);
    if (!text) throw WorldFileError(path + ": cannot be read");
    try {
        read(parsed(*text), world);
    } catch (const std::exception& error) {
        throw WorldFileError(path + ": " + error.what());
    }
}

std::string worldFileText(const WorldOptions& world) {
    Json json;
    for (const Row& row : kRows) json[row.key] = world.*row.value;
    json["motor_field_mg_a"] = world.motor_field_mg_a;
    const SensorErrors errors = world.errors.value_or(SensorErrors{});
    for (const ErrorKey& each : kErrors) json["errors"][each.key] = errors.*each.value;
    return json.dump(4) + "\n";
}

}  // namespace simulator

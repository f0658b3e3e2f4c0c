// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/recorded_series.hpp"

#include <cmath>
#include <string>

#include "simulator/constants.hpp"

namespace simulator {
namespace {

using Value = std::optional<double>;

constexpr double kFrame_us = 10'000;
constexpr bool kFast = false, kSlow = true;

double positive(double degrees) { return degrees < 0 ? degrees + 360 : degrees; }
Value positive(const Value& degrees) { return degrees ? Value(positive(*degrees)) : degrees; }
Value share(const Value& us) { return us ? Value(*us / kFrame_us * 100) : us; }
Value whileKnown(bool known, double value) { return known ? Value(value) : std::nullopt; }

double windFrom_deg(const Truth& truth) {
    return positive(std::atan2(-truth.wind_east_mps, -truth.wind_north_mps) * kDegrees);
}

double energyHeight_m(const Truth& truth) {
    return truth.height_m + truth.airspeed_mps * truth.airspeed_mps / (2 * kGravity_mss);
}

// clang-format off
using S = const Sample&;

std::vector<RecordedSeries> path() {
    return {
        {"lat_deg", "latitude", "°", "", "truth", kFast, [](S s) { return s.truth.latitude_deg; }},
        {"lon_deg", "longitude", "°", "", "truth", kFast, [](S s) { return s.truth.longitude_deg; }},
        {"lat_deg", "latitude", "°", "", "estimate", kFast, [](S s) { return s.reported.latitude_deg; }},
        {"lon_deg", "longitude", "°", "", "estimate", kFast, [](S s) { return s.reported.longitude_deg; }},
        {"altitude_m", "altitude above the sea", "m", "", "truth", kFast, [](S s) { return s.truth.altitude_m; }},
        {"height_m", "height", "m", "height", "truth", kFast, [](S s) { return s.truth.height_m; }},
        {"height_m", "height", "m", "height", "estimate", kFast, [](S s) { return s.height_m; }},
        {"height_m", "height", "m", "height", "demand", kFast, [](S s) { return s.reported.height_demand_m; }},
        {"planned_height_m", "planned", "m", "height", "", kFast, [](S s) { return s.planned.height_m; }},
        {"airspeed_mps", "airspeed", "m/s", "speed", "truth", kFast, [](S s) { return s.truth.equivalent_airspeed_mps; }},
        {"airspeed_mps", "airspeed", "m/s", "speed", "estimate", kFast, [](S s) { return s.airspeed_mps; }},
        {"airspeed_mps", "airspeed", "m/s", "speed", "demand", kFast, [](S s) { return s.reported.airspeed_demand_mps; }},
        {"ground_speed_mps", "ground speed", "m/s", "speed", "truth", kFast, [](S s) { return std::hypot(s.truth.velocity_north_mps, s.truth.velocity_east_mps); }},
        {"ground_speed_mps", "ground speed", "m/s", "speed", "estimate", kFast, [](S s) { return s.reported.ground_speed_mps; }},
        {"climb_mps", "climb", "m/s", "climb", "truth", kFast, [](S s) { return -s.truth.velocity_down_mps; }},
        {"climb_mps", "climb", "m/s", "climb", "estimate", kFast, [](S s) { return s.reported.climb_mps; }},
        {"crosstrack_m", "crosstrack", "m", "track", "truth", kFast, [](S s) { return s.planned.crosstrack_m; }},
        {"crosstrack_m", "crosstrack", "m", "track", "estimate", kSlow, [](S s) { return s.reported.crosstrack_m; }},
        {"distance_m", "distance to the item", "m", "track", "", kSlow, [](S s) { return s.distance_m; }},
    };
}

std::vector<RecordedSeries> attitude() {
    return {
        {"roll_deg", "roll", "°", "roll", "truth", kFast, [](S s) { return s.truth.roll_rad * kDegrees; }},
        {"roll_deg", "roll", "°", "roll", "estimate", kFast, [](S s) { return s.roll_deg; }},
        {"roll_deg", "roll", "°", "roll", "demand", kFast, [](S s) { return s.roll_demand_deg; }},
        {"pitch_deg", "pitch", "°", "pitch", "truth", kFast, [](S s) { return s.truth.pitch_rad * kDegrees; }},
        {"pitch_deg", "pitch", "°", "pitch", "estimate", kFast, [](S s) { return s.pitch_deg; }},
        {"pitch_deg", "pitch", "°", "pitch", "demand", kFast, [](S s) { return s.pitch_demand_deg; }},
        {"angle_of_attack_deg", "angle of attack", "°", "pitch", "", kFast, [](S s) { return whileKnown(s.truth.airspeed_mps > 4, s.truth.alpha_rad * kDegrees); }},
        {"yaw_deg", "yaw", "°", "heading", "truth", kFast, [](S s) { return positive(s.truth.yaw_rad * kDegrees); }},
        {"yaw_deg", "yaw", "°", "heading", "estimate", kFast, [](S s) { return positive(s.yaw_deg); }},
        {"bearing_deg", "bearing", "°", "heading", "demand", kSlow, [](S s) { return positive(s.reported.bearing_demand_deg); }},
        {"roll_rate_dps", "roll", "°/s", "rates", "truth", kFast, [](S s) { return s.truth.roll_rate_rads * kDegrees; }},
        {"pitch_rate_dps", "pitch", "°/s", "rates", "truth", kFast, [](S s) { return s.truth.pitch_rate_rads * kDegrees; }},
        {"yaw_rate_dps", "yaw", "°/s", "rates", "truth", kFast, [](S s) { return s.truth.yaw_rate_rads * kDegrees; }},
        {"acceleration_x_mss", "acceleration x", "m/s²", "vibration", "measured", kFast, [](S s) { return s.reported.acceleration_mss[0]; }},
        {"acceleration_y_mss", "acceleration y", "m/s²", "vibration", "measured", kFast, [](S s) { return s.reported.acceleration_mss[1]; }},
        {"acceleration_z_mss", "acceleration z", "m/s²", "vibration", "measured", kFast, [](S s) { return s.reported.acceleration_mss[2]; }},
    };
}

std::vector<RecordedSeries> controls() {
    return {
        {"throttle_percent", "throttle", "%", "controls", "", kFast, [](S s) { return s.truth.throttle * 100; }},
        {"aileron_percent", "aileron", "%", "controls", "", kFast, [](S s) { return s.truth.aileron * 100; }},
        {"elevator_percent", "elevator", "%", "controls", "", kFast, [](S s) { return s.truth.elevator * 100; }},
        {"rudder_percent", "rudder", "%", "controls", "", kFast, [](S s) { return s.truth.rudder * 100; }},
    };
}

std::vector<RecordedSeries> energy() {
    return {
        {"energy_height_m", "energy as height", "m", "energy", "truth", kFast, [](S s) { return energyHeight_m(s.truth); }},
        {"battery_used_mah", "used", "mAh", "energy", "truth", kSlow, [](S s) { return s.truth.battery_used_mah; }},
        {"battery_v", "voltage", "V", "battery", "truth", kSlow, [](S s) { return s.truth.battery_v; }},
        {"battery_v", "voltage", "V", "battery", "estimate", kSlow, [](S s) { return s.reported.battery_v; }},
        {"battery_a", "current", "A", "battery", "truth", kSlow, [](S s) { return s.truth.motor_current_a; }},
        {"battery_a", "current", "A", "battery", "estimate", kSlow, [](S s) { return s.reported.battery_a; }},
        {"board_v", "board supply", "V", "battery", "measured", kSlow, [](S s) { return s.reported.board_v; }},
    };
}

std::vector<RecordedSeries> windAndGps() {
    return {
        {"wind_mps", "wind", "m/s", "wind", "truth", kSlow, [](S s) { return std::hypot(s.truth.wind_north_mps, s.truth.wind_east_mps); }},
        {"wind_mps", "wind", "m/s", "wind", "estimate", kSlow, [](S s) { return s.reported.wind_mps; }},
        {"wind_from_deg", "wind from", "°", "wind", "truth", kSlow, [](S s) { return whileKnown(std::hypot(s.truth.wind_north_mps, s.truth.wind_east_mps) > 0.1, windFrom_deg(s.truth)); }},
        {"wind_from_deg", "wind from", "°", "wind", "estimate", kSlow, [](S s) { return s.reported.wind_from_deg; }},
        {"satellites", "satellites", "", "gps", "", kSlow, [](S s) { return s.reported.satellites; }},
        {"gps_fix", "fix", "", "gps", "", kSlow, [](S s) { return s.reported.fix; }},
        {"hdop", "HDOP", "", "gps", "", kSlow, [](S s) { return s.reported.hdop; }},
        {"gps_speed_mps", "GPS speed", "m/s", "gps", "measured", kSlow, [](S s) { return s.reported.gps_speed_mps; }},
    };
}

std::vector<RecordedSeries> processor() {
    return {
        {"cpu_percent", "load reported", "%", "cpu", "", kSlow, [](S s) { return s.reported.load_percent; }},
        {"frame_mean_percent", "mean of the frames", "%", "cpu", "", kFast, [](S s) { return share(s.frame_mean_us); }},
        {"frame_mean_us", "mean frame", "µs", "frames", "", kFast, [](S s) { return s.frame_mean_us; }},
        {"longest_frame_us", "longest frame", "µs", "frames", "", kFast, [](S s) { return s.frame_us; }},
    };
}

// clang-format on

// Outputs 1 to 4 move quickly.
std::vector<RecordedSeries> servos() {
    std::vector<RecordedSeries> rows;
    for (size_t i = 0; i < Sample{}.servo_us.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        rows.push_back({"servo" + number + "_us", "output " + number, "µs", "servos", "", i >= 4,
                        [i](S s) { return whileKnown(s.servo_us[i] > 0, s.servo_us[i]); }});
    }
    return rows;
}

std::vector<RecordedSeries> sticks() {
    std::vector<RecordedSeries> rows;
    for (size_t i = 0; i < Sample{}.reported.rc_us.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        rows.push_back({"rc" + number + "_us", "input " + number, "µs", "rc", "", kSlow,
                        [i](S s) { return s.reported.rc_us[i]; }});
    }
    return rows;
}

std::vector<RecordedSeries> table() {
    std::vector<RecordedSeries> all;
    for (const auto& rows :
         {path(), attitude(), controls(), servos(), energy(), windAndGps(), sticks(), processor()})
        all.insert(all.end(), rows.begin(), rows.end());
    return all;
}

// Every so many samples: longer flights in larger steps, so that a report stays small.
constexpr size_t kMaxSamples = 6000, kSlowEvery = 5;

std::vector<double> valuesOf(const RecordedSeries& series, const std::vector<Sample>& samples,
                             size_t every) {
    std::vector<double> values;
    for (size_t i = 0; i < samples.size(); i += every)
        values.push_back(series.value(samples[i]).value_or(NAN));
    return values;
}

bool anyKnown(const std::vector<double>& values) {
    for (const double value : values)
        if (std::isfinite(value)) return true;
    return false;
}

}  // namespace

const std::vector<RecordedSeries>& recordedSeries() {
    static const std::vector<RecordedSeries> all = table();
    return all;
}

void addSeries(FlightDocument& document, const std::vector<Sample>& samples) {
    const size_t every = (samples.size() + kMaxSamples - 1) / kMaxSamples;
    if (every == 0) return;
    const size_t steps[] = {every, every * kSlowEvery};
    for (const size_t step : steps) {
        std::vector<double> times;
        for (size_t i = 0; i < samples.size(); i += step) times.push_back(samples[i].time_s);
        document.times.push_back(times);
    }
    for (const RecordedSeries& row : recordedSeries()) {
        const size_t time = row.slow ? 1 : 0;
        const std::vector<double> values = valuesOf(row, samples, steps[time]);
        if (anyKnown(values))
            document.series.push_back(
                {row.name, row.title, row.unit, row.group, row.kind, time, values});
    }
}

}  // namespace simulator

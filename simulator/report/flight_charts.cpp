// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/flight_charts.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {
namespace {

constexpr char kTruth[] = "#1f6ab0", kDemand[] = "#d9771f", kTold[] = "#7fb2d9",
               kPlan[] = "#8793a1", kLoad[] = "#6b4fa3";
constexpr double kDegrees = 180 / M_PI;
constexpr double kBefore_s = 5;

std::string place(const PlannedNav& nav) {
    const bool land = nav.command == mavlink::MavCmd::nav_land;
    return std::to_string(nav.item) + (land ? " land" : "");
}

bool any(const Points& points) {
    return std::any_of(points.begin(), points.end(),
                       [](auto& p) { return std::isfinite(p.second); });
}

}  // namespace

FlightCharts::FlightCharts(const std::vector<Sample>& samples, const Plan& plan) : plan_(plan) {
    const auto first = std::find_if(samples.begin(), samples.end(), [](const Sample& s) {
        return s.mode == static_cast<int>(kModeAuto);
    });
    const double from_s = first == samples.end() ? 0 : first->time_s - kBefore_s;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(flight_),
                 [&](const Sample& s) { return s.time_s >= from_s; });
}

Points FlightCharts::series(const Value& value) const {
    Points points;
    for (const Sample& s : flight_) points.push_back({s.time_s, value(s).value_or(NAN)});
    return points;
}

Chart FlightCharts::overTime(const std::string& y_label, bool items) const {
    Chart chart;
    chart.x_label = "time since power-on, s";
    chart.y_label = y_label;
    int item = 0;
    for (const Sample& s : flight_) {
        if (items && s.item != item && s.item != 0) {
            chart.uprights.push_back({s.time_s, 0, std::to_string(s.item)});
        }
        item = s.item;
    }
    return chart;
}

std::string FlightCharts::map() const {
    Chart chart;
    chart.map = true;
    chart.height = 620;
    chart.x_label = "east of home, m";
    chart.y_label = "north of home, m";
    Points planned, flown;
    for (const PlannedNav& nav : plan_.navs) {
        if (!nav.place) continue;
        if (!nav.from) planned.push_back({NAN, NAN});
        planned.push_back({nav.place->east_m, nav.place->north_m});
        chart.places.push_back({nav.place->east_m, nav.place->north_m, place(nav)});
    }
    for (const Sample& s : flight_) flown.push_back({s.place.east_m, s.place.north_m});
    chart.lines = {{"planned legs", kPlan, Stroke::dashed, planned},
                   {"flown (truth)", kTruth, Stroke::solid, flown}};
    return drawChart(chart);
}

std::string FlightCharts::altitude() const {
    Chart chart = overTime("altitude above home, m");
    chart.lines = {
        {"as the autopilot tells", kTold, Stroke::thin, series([](auto& s) { return s.height_m; })},
        {"planned", kDemand, Stroke::dashed, series([](auto& s) { return s.planned.height_m; })},
        {"truth", kTruth, Stroke::solid, series([](auto& s) { return s.truth.height_m; })}};
    return drawChart(chart);
}

std::string FlightCharts::airspeed() const {
    Chart chart = overTime("airspeed, m/s");
    chart.lines = {{"as the autopilot tells", kTold, Stroke::thin,
                    series([](auto& s) { return s.airspeed_mps; })},
                   {"demanded", kDemand, Stroke::dashed,
                    series([](auto& s) { return s.planned.airspeed_mps; })},
                   {"truth", kTruth, Stroke::solid,
                    series([](auto& s) { return s.truth.equivalent_airspeed_mps; })}};
    return drawChart(chart);
}

std::string FlightCharts::crosstrack() const {
    Chart chart = overTime("crosstrack, m");
    const Points counted = series([](auto& s) {
        return s.planned.counts ? s.planned.crosstrack_m : std::optional<double>();
    });
    chart.lines = {
        {"capture", kTold, Stroke::thin, series([](auto& s) { return s.planned.crosstrack_m; })},
        {"captured: counts", kTruth, Stroke::solid, counted}};
    chart.y_from = -15;
    chart.y_to = 15;
    return any(chart.lines[0].points) ? drawChart(chart) : "";
}

std::string FlightCharts::attitude(const char* label, const Value& truth,
                                   const Value& demand) const {
    Chart chart = overTime(label, false);
    chart.width = 560;
    chart.lines = {{"demand", kDemand, Stroke::thin, series(demand)},
                   {"truth", kTruth, Stroke::solid, series(truth)}};
    return drawChart(chart);
}

std::string FlightCharts::roll() const {
    return attitude(
        "roll, degrees", [](const Sample& s) { return s.truth.roll_rad * kDegrees; },
        [](const Sample& s) { return s.roll_demand_deg; });
}

std::string FlightCharts::pitch() const {
    return attitude(
        "pitch, degrees", [](const Sample& s) { return s.truth.pitch_rad * kDegrees; },
        [](const Sample& s) { return s.pitch_demand_deg; });
}

std::string FlightCharts::servos() const {
    static const std::pair<const char*, const char*> kOutputs[] = {
        {"1 aileron", "#1f6ab0"}, {"2 elevator", "#d9771f"}, {"3 throttle", "#b42318"},
        {"4 rudder", "#18794e"},  {"5", "#6b4fa3"},          {"6", "#0f8b8d"},
        {"7", "#a3762f"},         {"8", "#8793a1"}};
    Chart chart = overTime("pulse, µs");
    for (size_t i = 0; i < std::size(kOutputs); ++i) {
        const Points points = series([i](const Sample& s) {
            return s.servo_us[i] > 0 ? std::optional<double>(s.servo_us[i]) : std::nullopt;
        });
        if (!any(points)) continue;
        chart.lines.push_back(
            {kOutputs[i].first, kOutputs[i].second, i < 4 ? Stroke::solid : Stroke::thin, points});
    }
    return chart.lines.empty() ? "" : drawChart(chart);
}

std::string FlightCharts::frames() const {
    Chart chart = overTime("longest frame, µs");
    chart.lines = {{"", kLoad, Stroke::thin, series([](auto& s) { return s.frame_us; })}};
    chart.y_from = 0;
    return any(chart.lines[0].points) ? drawChart(chart) : "";
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/flight_charts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace simulator {
namespace {

constexpr char kTruth[] = "#1f6ab0", kDemand[] = "#d9771f", kReported[] = "#7fb2d9",
               kLoad[] = "#6b4fa3", kBand[] = "#f3c892";
constexpr double kDegrees = 180 / M_PI;
constexpr double kBefore_s = 5;

std::string place(const PlannedNav& nav) {
    const bool land = nav.command == mavlink::MavCmd::nav_land;
    return std::to_string(nav.item) + (land ? " land" : "");
}

std::string windText(const Summary& summary) {
    if (summary.wind_mps <= 0) return summary.gusts ? "gusts only" : "calm air";
    char text[48];
    std::snprintf(text, sizeof text, "%.1f m/s%s", summary.wind_mps,
                  summary.gusts ? ", gusts" : "");
    return text;
}

double bearing(const Point& from, const Point& to) {
    return std::atan2(to.east_m - from.east_m, to.north_m - from.north_m);
}

Point onCircle(const Point& centre, double radius, double bearing_rad) {
    return {centre.north_m + radius * std::cos(bearing_rad),
            centre.east_m + radius * std::sin(bearing_rad)};
}

// Where the way from `from` touches a circle flown to the right, or below 0 to the left.
Point tangentPoint(const Point& from, const Point& centre, double radius) {
    const double away = distance_m(from, centre);
    if (away <= std::abs(radius)) return centre;
    const double opening = std::acos(std::abs(radius) / away);
    return onCircle(centre, std::abs(radius),
                    bearing(centre, from) + std::copysign(opening, radius));
}

bool any(const Points& points) {
    return std::any_of(points.begin(), points.end(),
                       [](auto& p) { return std::isfinite(p.second); });
}

}  // namespace

FlightCharts::FlightCharts(const Summary& summary, const std::vector<Sample>& samples,
                           const Plan& plan)
    : summary_(summary), plan_(plan) {
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

double FlightCharts::radius_m(const PlannedNav& nav) const {
    if (!nav.circle_m) return 0;
    return *nav.circle_m != 0 ? *nav.circle_m : summary_.loiter_radius_m.value_or(0);
}

// From the place where it stands to the first place, and on from place to place; to a circle along
// its tangent, from a circle on the line from its centre.
Points FlightCharts::legs() const {
    Points legs;
    Point from;
    double from_radius = 0;
    for (const PlannedNav& nav : plan_.navs) {
        if (!nav.place) continue;
        const Point begin = onCircle(from, from_radius, bearing(from, *nav.place));
        const Point end = tangentPoint(begin, *nav.place, radius_m(nav));
        legs.push_back({begin.east_m, begin.north_m});
        legs.push_back({end.east_m, end.north_m});
        legs.push_back({NAN, NAN});
        from = *nav.place;
        from_radius = std::abs(radius_m(nav));
    }
    return legs;
}

Points FlightCharts::circles() const {
    constexpr int kSides = 72;
    Points points;
    for (const PlannedNav& nav : plan_.navs) {
        if (!nav.place || radius_m(nav) == 0) continue;
        for (int side = 0; side <= kSides; ++side) {
            const Point at = onCircle(*nav.place, radius_m(nav), side * 2 * M_PI / kSides);
            points.push_back({at.east_m, at.north_m});
        }
        points.push_back({NAN, NAN});
    }
    return points;
}

std::string FlightCharts::map() const {
    Chart chart;
    chart.map = true;
    chart.width = 620;
    chart.height = 830;
    chart.x_label = "east of home, m";
    chart.y_label = "north of home, m";
    for (const PlannedNav& nav : plan_.navs) {
        if (nav.place) chart.places.push_back({nav.place->east_m, nav.place->north_m, place(nav)});
    }
    Points flown;
    for (const Sample& s : flight_) flown.push_back({s.place.east_m, s.place.north_m});
    chart.lines = {{"planned", kBand, Stroke::band, legs()},
                   {"", kBand, Stroke::band, circles()},
                   {"flown", kTruth, Stroke::solid, flown}};
    if (!summary_.from_log)
        chart.wind = Wind{summary_.wind_from_deg, windText(summary_), summary_.wind_mps <= 0};
    return drawChart(chart);
}

std::string FlightCharts::altitude() const {
    Chart chart = overTime("altitude above home, m");
    chart.lines = {
        {summary_.from_log ? "" : "as estimated", kReported, Stroke::thin,
         series([](auto& s) { return s.height_m; })},
        {"planned", kDemand, Stroke::dashed, series([](auto& s) { return s.planned.height_m; })},
        {summary_.from_log ? "logged" : "truth", kTruth, Stroke::solid,
         series([](auto& s) { return s.truth.height_m; })}};
    return drawChart(chart);
}

std::string FlightCharts::airspeed() const {
    Chart chart = overTime("airspeed, m/s");
    chart.lines = {{summary_.from_log ? "" : "as estimated", kReported, Stroke::thin,
                    series([](auto& s) { return s.airspeed_mps; })},
                   {"demanded", kDemand, Stroke::dashed,
                    series([](auto& s) { return s.planned.airspeed_mps; })},
                   {summary_.from_log ? "logged" : "truth", kTruth, Stroke::solid,
                    series([](auto& s) { return s.truth.equivalent_airspeed_mps; })}};
    return drawChart(chart);
}

std::string FlightCharts::crosstrack() const {
    Chart chart = overTime("crosstrack, m");
    const Points counted = series([](auto& s) {
        return s.planned.counts ? s.planned.crosstrack_m : std::optional<double>();
    });
    chart.lines = {{"capture", kReported, Stroke::thin,
                    series([](auto& s) { return s.planned.crosstrack_m; })},
                   {"captured: counts", kTruth, Stroke::solid, counted}};
    chart.y_from = -15;
    chart.y_to = 15;
    return any(chart.lines[0].points) ? drawChart(chart) : "";
}

std::string FlightCharts::attitude(const char* label, const Value& truth,
                                   const Value& demand) const {
    Chart chart = overTime(label);
    chart.lines = {{"demand", kDemand, Stroke::thin, series(demand)},
                   {summary_.from_log ? "logged" : "truth", kTruth, Stroke::solid, series(truth)}};
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

std::string FlightCharts::servos(const std::vector<size_t>& outputs, const char* label) const {
    static const std::pair<const char*, const char*> kOutputs[] = {
        {"1 aileron", "#1f6ab0"}, {"2 elevator", "#d9771f"}, {"3 throttle", "#b42318"},
        {"4 rudder", "#18794e"},  {"5", "#6b4fa3"},          {"6", "#0f8b8d"},
        {"7", "#a3762f"},         {"8", "#8793a1"}};
    Chart chart = overTime(label);
    for (const size_t i : outputs) {
        const Points points = series([i](const Sample& s) {
            return s.servo_us[i] > 0 ? std::optional<double>(s.servo_us[i]) : std::nullopt;
        });
        if (any(points))
            chart.lines.push_back({kOutputs[i].first, kOutputs[i].second, Stroke::thin, points});
    }
    return chart.lines.empty() ? "" : drawChart(chart);
}

std::string FlightCharts::surfaces() const { return servos({0, 1, 3}, "pulse, µs"); }

std::string FlightCharts::otherServos() const { return servos({2, 4, 5, 6, 7}, "pulse, µs"); }

std::string FlightCharts::frames() const {
    constexpr double kFrame_us = 10'000;
    const auto share = [](const std::optional<double>& us) {
        return us ? std::optional<double>(*us / kFrame_us * 100) : std::nullopt;
    };
    Chart chart = overTime("share of a frame, %");
    chart.lines = {
        {"busiest frame", kReported, Stroke::thin,
         series([&](auto& s) { return share(s.frame_us); })},
        {"mean", kLoad, Stroke::solid, series([&](auto& s) { return share(s.frame_mean_us); })}};
    chart.y_from = 0;
    chart.y_to = 100;
    return any(chart.lines[0].points) ? drawChart(chart) : "";
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "budgets.hpp"
#include "simulator/devices/errors.hpp"
#include "simulator/report/html.hpp"
#include "simulator/report/vectors.hpp"

namespace simulator {
namespace {

constexpr double kCycles_us = 16;

struct Row {
    const char* name;
    std::optional<double> value;
    const char* unit;
    int decimals;
    std::optional<double> most;  // the limit, where there is one
};

std::optional<double> share(const std::optional<double>& value) {
    return value ? std::optional<double>(*value * 100) : std::nullopt;
}

std::optional<double> longestInterrupt_us(const BoardFigures& figures) {
    if (figures.interrupts.empty()) return std::nullopt;
    uint32_t longest = 0;
    for (const auto& i : figures.interrupts) longest = std::max(longest, i.max_cycles);
    return longest / kCycles_us;
}

std::optional<double> memory(const BoardFigures& f) {
    if (!f.ram_static_bytes || !f.stack_max_bytes) return std::nullopt;
    return *f.ram_static_bytes + *f.stack_max_bytes;
}

// What the flights of the tests are held to, by the air they are flown in.
struct FlightLimits {
    double crosstrack_rms_m, altitude_rms_m, touchdown_m;
};
FlightLimits limitsIn(const Summary& s) {
    const bool calm = s.wind_mps <= 0 && !s.gusts;
    return calm ? FlightLimits{3, 2, 30} : FlightLimits{5, 3, 60};
}

std::string limitText(const std::optional<double>& most) {
    if (!most) return "";
    return *most == 0 ? "none" : "≤ " + fixed(*most, 0);
}

std::vector<std::string> cells(const Row& row) {
    const bool within = !row.most || *row.value <= *row.most;
    return {row.name, fixed(*row.value, row.decimals), limitText(row.most), row.unit,
            !row.most ? ""
            : within  ? "✓"
                      : "✗"};
}

Row withoutLimit(const Row& row) {
    return {row.name, row.value, row.unit, row.decimals, std::nullopt};
}

}  // namespace

std::string summaryTable(const Summary& s) {
    const BoardFigures& f = s.figures;
    const FlightLimits most = limitsIn(s);
    const std::optional<double> emulated_s =
        s.from_log ? std::nullopt : std::optional<double>(s.emulated_s);
    const budgets::BoardBudget& board = s.board == "apm1" ? budgets::k_apm1 : budgets::k_apm2;
    // clang-format off
    const Row rows[] = {
        {"Touch-down from landing point",   s.landed_distance_m,     "m",    1, most.touchdown_m},
        {"Stands from landing point",       s.standing_distance_m,   "m",    1, {}},
        {"Sink at touch-down",              s.touchdown_sink_mps,    "m/s",  2, {}},
        {"Flight time",                     s.flight_time_s,         "s",    1, {}},
        {"Crosstrack, RMS",                 s.crosstrack_rms_m,      "m",    2, most.crosstrack_rms_m},
        {"of it from 5 s later on each leg", s.crosstrack_settled_rms_m, "m", 2, {}},
        {"Crosstrack, largest",             s.crosstrack_max_m,      "m",    2, {}},
        {"Altitude, RMS",                   s.altitude_rms_m,        "m",    2, most.altitude_rms_m},
        {"of it level",                     s.altitude_level_rms_m,  "m",    2, {}},
        {"of it on slopes",                 s.altitude_sloped_rms_m, "m",    2, {}},
        {"Altitude, largest",               s.altitude_max_m,        "m",    2, {}},
        {"Airspeed, RMS",                   s.airspeed_rms_mps,      "m/s",  2, {}},
        {"Radius of circles, RMS",          s.loiter_radius_rms_m,   "m",    2, {}},
        {"Estimate of roll, RMS",           s.roll_error_rms_deg,    "°",    2, {}},
        {"Estimate of pitch, RMS",          s.pitch_error_rms_deg,   "°",    2, {}},
        {"Estimate of yaw, RMS",            s.yaw_error_rms_deg,     "°",    2, {}},
        {"Processor load",                  share(f.cpu_load),       "%",    1, board.processor_percent},
        {"of it interrupts",                share(f.interrupt_load), "%",    1, board.interrupts_percent},
        {"Frame, mean",                     f.frame_mean_us,         "µs",   0, {}},
        {"Frame, 99 of 100",                f.frame_p99_us,          "µs",   0, {}},
        {"Frame, longest",                  f.frame_max_us,          "µs",   0, budgets::kFrame_us},
        {"Sample to servos, mean",          f.latency_mean_us,       "µs",   0, {}},
        {"Sample to servos, longest",       f.latency_max_us,        "µs",   0, budgets::kGyroToServo_us},
        {"Frames late",                     f.frame_overruns,        "",     0, 0},
        {"Longest interrupt",               longestInterrupt_us(f),  "µs",   1, budgets::kInterrupt_us},
        {"Inertial samples lost",           s.imu_samples_lost,      "",     0, 0},
        {"Inertial samples read twice",     s.imu_samples_repeated,  "",     0, 0},
        {"Flash",                           f.flash_bytes,           "bytes", 0, budgets::kFlash_bytes},
        {"Static RAM",                      f.ram_static_bytes,      "bytes", 0, {}},
        {"Deepest stack seen",              f.stack_max_bytes,       "bytes", 0, {}},
        {"RAM and stack",                   memory(f),               "bytes", 0, budgets::kRamAndStack_bytes},
        {"Emulated time",                   emulated_s,              "s",    1, {}},
        {"Speed over real time",            s.speedup,               "times", 1, {}},
    };
    // clang-format on
    Table table({"", "value", "limit", "unit", ""});
    for (const Row& row : rows) {  // the limits are those of the tests' flights
        if (row.value) table.row(cells(s.from_log ? withoutLimit(row) : row));
    }
    return table.done();
}

std::string eventTable(const Summary& summary) {
    if (summary.events.empty()) return "";
    Table table({"event", "time, s"});
    for (const Event& event : summary.events) table.row({event.text, fixed(event.time_s, 1)});
    return table.done();
}

std::string violationTable(const Summary& summary) {
    if (summary.violations.empty()) return "";
    Table table({"invariant", "time, s"});
    for (const Event& each : summary.violations) table.row({each.text, fixed(each.time_s, 2)});
    return table.done();
}

std::string taskTable(const Summary& summary) {
    if (summary.figures.tasks.empty()) return "";
    Table table({"task", "every, frames", "runs", "mean, µs", "longest, µs", "budget, µs"});
    for (const auto& task : summary.figures.tasks) {
        const TaskName* named = find(summary.task_names, task.number);
        table.row({named ? named->name : std::to_string(task.number),
                   named ? std::to_string(named->period) : "", std::to_string(task.runs),
                   fixed(task.mean_cycles / kCycles_us, 1), fixed(task.max_cycles / kCycles_us, 1),
                   named ? std::to_string(named->budget_us) : ""});
    }
    return table.done();
}

std::string interruptTable(const BoardFigures& figures, double emulated_s) {
    if (figures.interrupts.empty()) return "";
    Table table({"interrupt", "runs", "mean, µs", "longest, µs", "load, %"});
    for (const auto& i : figures.interrupts) {
        const auto cycles = static_cast<double>(i.cycles);
        table.row({vectorName(i.vector), std::to_string(i.runs),
                   fixed(cycles / static_cast<double>(i.runs) / kCycles_us, 1),
                   fixed(i.max_cycles / kCycles_us, 1),
                   fixed(cycles / (emulated_s * 1e6 * kCycles_us) * 100, 2)});
    }
    return table.done();
}

std::string errorTable() {
    const SensorErrors errors;
    Table table({"error", "value", "unit"});
    for (const ErrorRow& row : kErrorRows) {
        char text[32];
        std::snprintf(text, sizeof text, "%g", errors.*row.value);
        table.row({row.name, text, row.unit});
    }
    return table.done();
}

}  // namespace simulator

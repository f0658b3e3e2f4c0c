// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "budgets.hpp"
#include "simulator/devices/errors.hpp"
#include "simulator/report/goals.hpp"
#include "simulator/report/vectors.hpp"

namespace simulator {
namespace {

constexpr double kCycles_us = 16;

std::string fixed(double value, int decimals) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

struct Row {
    const char* name;
    std::optional<double> value;
    const char* unit;
    std::optional<double> most;  // the goal or the limit, where there is one
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

std::string microseconds(double cycles) { return fixed(cycles / kCycles_us, 1); }

}  // namespace

std::vector<Deviation> deviationsOf(const Summary& s) {
    const BoardFigures& f = s.figures;
    const bool windy = s.wind_mps > 0 || s.gusts;
    const auto goal = [&](const char* figure) {
        return s.from_log ? std::nullopt : goalOf(figure, windy, s.calibrated);
    };
    const budgets::BoardBudget& board = s.board == "apm1" ? budgets::k_apm1 : budgets::k_apm2;
    // clang-format off
    const Row rows[] = {
        {"Touch-down from landing point",   s.landed_distance_m,     "m", goal("landed_distance_m")},
        {"Stands from landing point",       s.standing_distance_m,   "m", {}},
        {"Sink at touch-down",              s.touchdown_sink_mps,    "m/s", goal("touchdown_sink_mps")},
        {"Flight time",                     s.flight_time_s,         "s", {}},
        {"Crosstrack, RMS",                 s.crosstrack_rms_m,      "m", goal("crosstrack_rms_m")},
        {"of it from 5 s later on each leg", s.crosstrack_settled_rms_m, "m", goal("crosstrack_settled_rms_m")},
        {"Crosstrack, largest",             s.crosstrack_max_m,      "m", {}},
        {"Altitude, RMS",                   s.altitude_rms_m,        "m", {}},
        {"of it level",                     s.altitude_level_rms_m,  "m", goal("altitude_level_rms_m")},
        {"of it on slopes",                 s.altitude_sloped_rms_m, "m", goal("altitude_sloped_rms_m")},
        {"Altitude, largest",               s.altitude_max_m,        "m", {}},
        {"Airspeed, RMS",                   s.airspeed_rms_mps,      "m/s", goal("airspeed_rms_mps")},
        {"Airspeed, lowest",                s.airspeed_min_mps,      "m/s", {}},
        {"Radius of circles, RMS",          s.loiter_radius_rms_m,   "m", goal("loiter_radius_rms_m")},
        {"Estimate of roll, RMS",           s.roll_error_rms_deg,    "°", goal("roll_error_rms_deg")},
        {"Estimate of pitch, RMS",          s.pitch_error_rms_deg,   "°", goal("pitch_error_rms_deg")},
        {"Estimate of yaw, RMS",            s.yaw_error_rms_deg,     "°", goal("yaw_error_rms_deg")},
        {"Processor load",                  share(f.cpu_load),       "%", board.processor_percent},
        {"of it interrupts",                share(f.interrupt_load), "%", board.interrupts_percent},
        {"Frame, mean",                     f.frame_mean_us,         "µs", {}},
        {"Frame, 99 of 100",                f.frame_p99_us,          "µs", {}},
        {"Frame, longest",                  f.frame_max_us,          "µs", budgets::kFrame_us},
        {"Sample to servos, mean",          f.latency_mean_us,       "µs", {}},
        {"Sample to servos, longest",       f.latency_max_us,        "µs", budgets::kGyroToServo_us},
        {"Frames late",                     f.frame_overruns,        "", 0},
        {"Longest interrupt",               longestInterrupt_us(f),  "µs", budgets::kInterrupt_us},
        {"Inertial samples lost",           s.imu_samples_lost,      "", 0},
        {"Inertial samples read twice",     s.imu_samples_repeated,  "", 0},
        {"Flash",                           f.flash_bytes,           "bytes", budgets::kFlash_bytes},
        {"Static RAM",                      f.ram_static_bytes,      "bytes", {}},
        {"Deepest stack seen",              f.stack_max_bytes,       "bytes", {}},
        {"RAM and stack",                   memory(f),               "bytes", budgets::kRamAndStack_bytes},
    };
    // clang-format on
    std::vector<Deviation> known;
    for (const Row& row : rows)
        if (row.value) known.push_back({row.name, *row.value, row.unit, row.most});
    return known;
}

static DocumentTable taskTable(const Summary& summary) {
    DocumentTable table{"Tasks",
                        "Interrupts within a task are not counted to it.",
                        {"task", "every, frames", "runs", "mean, µs", "longest, µs", "budget, µs"},
                        {}};
    for (const auto& task : summary.figures.tasks) {
        const TaskName* named = find(summary.task_names, task.number);
        table.rows.push_back({named ? named->name : std::to_string(task.number),
                              named ? std::to_string(named->period) : "", std::to_string(task.runs),
                              microseconds(task.mean_cycles), microseconds(task.max_cycles),
                              named ? std::to_string(named->budget_us) : ""});
    }
    return table;
}

static DocumentTable interruptTable(const BoardFigures& figures, double emulated_s) {
    DocumentTable table{
        "Interrupts", "", {"interrupt", "runs", "mean, µs", "longest, µs", "load, %"}, {}};
    for (const auto& i : figures.interrupts) {
        const auto cycles = static_cast<double>(i.cycles);
        table.rows.push_back({vectorName(i.vector), std::to_string(i.runs),
                              microseconds(cycles / static_cast<double>(i.runs)),
                              microseconds(i.max_cycles),
                              fixed(cycles / (emulated_s * 1e6 * kCycles_us) * 100, 2)});
    }
    return table;
}

static DocumentTable errorTable() {
    const SensorErrors errors;
    DocumentTable table{"Sensor errors of this flight",
                        "Deviations are one sigma, drawn from the seed.",
                        {"error", "value", "unit"},
                        {}};
    for (const ErrorRow& row : kErrorRows) {
        char text[32];
        std::snprintf(text, sizeof text, "%g", errors.*row.value);
        table.rows.push_back({row.name, text, row.unit});
    }
    return table;
}

std::vector<DocumentTable> tablesOf(const Summary& summary) {
    std::vector<DocumentTable> tables;
    if (!summary.figures.tasks.empty()) tables.push_back(taskTable(summary));
    if (!summary.figures.interrupts.empty())
        tables.push_back(interruptTable(summary.figures, summary.emulated_s));
    if (!summary.from_log) tables.push_back(errorTable());
    return tables;
}

}  // namespace simulator

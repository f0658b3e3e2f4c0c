// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "simulator/report/goals.hpp"
#include "simulator/report/vectors.hpp"

namespace simulator {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json orNull(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json rounded(const std::optional<double>& value, double steps) {
    return value && std::isfinite(*value) ? Json(std::round(*value * steps) / steps)
                                          : Json(nullptr);
}
// Three decimals say all there is to say of metres and seconds.
Json orNull(const std::optional<double>& value) { return rounded(value, 1e3); }
// A budget is a whole per cent: what is past it by a thousandth has to show.
Json loadOrNull(const std::optional<double>& value) { return rounded(value, 1e5); }

Json list(const std::vector<Event>& events) {
    Json json = Json::array();
    for (const Event& event : events) {
        json.push_back(
            {{"time_s", orNull(std::optional<double>(event.time_s))}, {"text", event.text}});
    }
    return json;
}

void addErrors(Json& json, const Summary& summary) {
    json["crosstrack_rms_m"] = orNull(summary.crosstrack_rms_m);
    json["crosstrack_settled_rms_m"] = orNull(summary.crosstrack_settled_rms_m);
    json["crosstrack_max_m"] = orNull(summary.crosstrack_max_m);
    json["altitude_rms_m"] = orNull(summary.altitude_rms_m);
    json["altitude_level_rms_m"] = orNull(summary.altitude_level_rms_m);
    json["altitude_sloped_rms_m"] = orNull(summary.altitude_sloped_rms_m);
    json["altitude_max_m"] = orNull(summary.altitude_max_m);
    json["airspeed_rms_mps"] = orNull(summary.airspeed_rms_mps);
    json["airspeed_min_mps"] = orNull(summary.airspeed_min_mps);
    json["loiter_radius_rms_m"] = orNull(summary.loiter_radius_rms_m);
    json["roll_error_rms_deg"] = orNull(summary.roll_error_rms_deg);
    json["pitch_error_rms_deg"] = orNull(summary.pitch_error_rms_deg);
    json["yaw_error_rms_deg"] = orNull(summary.yaw_error_rms_deg);
}

// The most that a figure may be, of those that have a goal.
Json goalsOf(const Summary& summary) {
    Json json = Json::object();
    const bool windy = summary.wind_mps > 0 || summary.gusts;
    for (const Goal& goal : goals())
        if (const auto most = goalOf(goal.figure, windy, summary.calibrated))
            json[goal.figure] = *most;
    return json;
}

void addFigures(Json& json, const BoardFigures& figures, const std::vector<TaskName>& names) {
    json["cpu_load"] = loadOrNull(figures.cpu_load);
    json["interrupt_load"] = loadOrNull(figures.interrupt_load);
    json["frames"] = orNull(figures.frames);
    json["frame_mean_us"] = orNull(figures.frame_mean_us);
    json["frame_p99_us"] = orNull(figures.frame_p99_us);
    json["frame_max_us"] = orNull(figures.frame_max_us);
    json["latency_mean_us"] = orNull(figures.latency_mean_us);
    json["latency_max_us"] = orNull(figures.latency_max_us);
    json["frame_overruns"] = orNull(figures.frame_overruns);
    json["flash_bytes"] = orNull(figures.flash_bytes);
    json["ram_static_bytes"] = orNull(figures.ram_static_bytes);
    json["stack_max_bytes"] = orNull(figures.stack_max_bytes);
    json["tasks"] = Json::array();
    for (const auto& task : figures.tasks) {
        Json row = {{"number", task.number}};
        if (const TaskName* named = find(names, task.number)) {
            row["name"] = named->name;
            row["budget_us"] = named->budget_us;
        }
        row["runs"] = task.runs;
        row["mean_cycles"] = std::round(task.mean_cycles);
        row["max_cycles"] = task.max_cycles;
        json["tasks"].push_back(row);
    }
    json["interrupts"] = Json::array();
    for (const auto& interrupt : figures.interrupts) {
        json["interrupts"].push_back({{"vector", interrupt.vector},
                                      {"name", vectorName(interrupt.vector)},
                                      {"runs", interrupt.runs},
                                      {"cycles", interrupt.cycles},
                                      {"max_cycles", interrupt.max_cycles}});
    }
}

}  // namespace

std::string summaryJson(const Summary& summary) {
    Json json;
    json["completed"] = summary.completed;
    json["reason"] = summary.reason.empty() ? Json(nullptr) : Json(summary.reason);
    json["mission"] = summary.mission;
    json["firmware"] = summary.firmware;
    json["board"] = summary.board;
    json["wind_mps"] = summary.wind_mps;
    json["wind_from_deg"] = summary.wind_from_deg;
    json["gusts"] = summary.gusts;
    json["seed"] = summary.seed;
    json["landed_distance_m"] = orNull(summary.landed_distance_m);
    json["touchdown_long_m"] = orNull(summary.touchdown_long_m);
    json["touchdown_right_m"] = orNull(summary.touchdown_right_m);
    json["standing_distance_m"] = orNull(summary.standing_distance_m);
    json["touchdown_sink_mps"] = orNull(summary.touchdown_sink_mps);
    json["flight_time_s"] = orNull(summary.flight_time_s);
    json["emulated_s"] = orNull(std::optional<double>(summary.emulated_s));
    json["speedup"] = orNull(summary.speedup);
    addErrors(json, summary);
    if (!summary.from_log) json["goals"] = goalsOf(summary);
    json["items_reached"] = orNull(summary.items_reached);
    json["items_planned"] = summary.items_planned;
    json["imu_samples"] = orNull(summary.imu_samples);
    json["imu_samples_lost"] = orNull(summary.imu_samples_lost);
    json["imu_samples_repeated"] = orNull(summary.imu_samples_repeated);
    json["model_answers_skipped"] = summary.model_answers_skipped;
    json["model_begun_anew"] = summary.model_begun_anew;
    addFigures(json, summary.figures, summary.task_names);
    json["provenance"] = Json::parse(provenanceJson(summary.provenance));
    json["events"] = list(summary.events);
    json["texts"] = list(summary.texts);
    json["violations"] = list(summary.violations);
    // texts come from outside: a byte that is no UTF-8 is replaced, not thrown over
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace simulator

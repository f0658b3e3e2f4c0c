// SPDX-License-Identifier: GPL-3.0-or-later
// What a flight comes down to. Empty: not known, null in summary.json, absent from the report.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simulator/board.hpp"
#include "simulator/devices/mpu6000.hpp"
#include "simulator/ground/telemetry.hpp"
#include "simulator/report/metrics.hpp"
#include "simulator/report/provenance.hpp"
#include "simulator/report/task_names.hpp"

namespace simulator {

struct FaultSpan {
    std::string name;  // "gps:lost"
    double from_s, to_s;
};

struct Summary {
    Provenance provenance;
    std::vector<FaultSpan> faults;
    std::string mission, firmware, board;  // as shown: file names, "apm2" or "native"
    double wind_mps = 0, wind_from_deg = 0;
    bool gusts = false, calibrated = false;
    uint64_t seed = 1;

    bool from_log = false;  // all that is known is what the airplane has logged: no truth
    bool completed = false;
    std::string reason;                       // empty when completed
    std::optional<double> landed_distance_m;  // of the touch-down from the landing point
    std::optional<double> touchdown_long_m, touchdown_right_m;  // of it along and across the leg
    std::optional<double> standing_distance_m;                  // of where it came to rest
    std::optional<double> touchdown_sink_mps;
    std::optional<double> flight_time_s;
    double emulated_s = 0;
    std::optional<double> speedup;  // over real time
    std::optional<double> crosstrack_rms_m, crosstrack_max_m, crosstrack_settled_rms_m;
    std::optional<double> altitude_rms_m, altitude_max_m, altitude_level_rms_m,
        altitude_sloped_rms_m;
    std::optional<double> airspeed_rms_mps, airspeed_min_mps, loiter_radius_rms_m;
    std::optional<double> roll_error_rms_deg, pitch_error_rms_deg, yaw_error_rms_deg;
    std::optional<std::vector<int>> items_reached;
    std::vector<int> items_planned;
    std::optional<double> loiter_radius_m;  // the autopilot's own
    std::optional<uint64_t> imu_samples, imu_samples_lost, imu_samples_repeated;
    uint64_t model_answers_skipped = 0;  // of a flight model elsewhere: not understood
    uint64_t model_begun_anew = 0;       // in flight
    BoardFigures figures;
    std::vector<TaskName> task_names;              // empty: numbers must do
    std::vector<Event> events, texts, violations;  // of invariants: none in a good flight

    void setSamples(const SampleCount& imu) {
        imu_samples = imu.made;
        imu_samples_lost = imu.lost;
        imu_samples_repeated = imu.repeated;
    }
};

std::string summaryJson(const Summary& summary);

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// The flight recorder: at 10 Hz the truth, what the autopilot says, the servo pulses and the
// processor's load, in one row of time series.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "simulator/board.hpp"
#include "simulator/devices/mpu6000.hpp"
#include "simulator/ground/plan.hpp"
#include "simulator/ground/telemetry.hpp"
#include "simulator/report/attitude_errors.hpp"
#include "simulator/report/metrics.hpp"
#include "simulator/report/reported.hpp"

namespace simulator {

struct Sample {
    double time_s;
    Truth truth;
    Point place;  // from home
    Planned planned;
    int mode = -1, item = 0;  // mode -1: not reported yet
    bool armed = false;
    std::optional<double> roll_deg, pitch_deg, yaw_deg, height_m, airspeed_mps;  // as reported
    std::optional<double> roll_demand_deg, pitch_demand_deg, distance_m;
    std::array<double, 8> servo_us{};  // 0: silent
    Reported reported;
    // of the frames since the last sample
    std::optional<double> frame_us, frame_mean_us;
};

class Recorder {
public:
    Recorder(const Plan& plan, const LocalFrame& frame) : frame_(frame), metrics_(plan, {}) {}

    void watchFrame(Board& board, const Telemetry& telemetry);  // as often as there is one
    void sample(Board& board, const Telemetry& telemetry, std::optional<double> cruise_speed_mps,
                std::optional<double> loiter_radius_m);

    const std::vector<Sample>& samples() const { return samples_; }
    const Metrics& metrics() const { return metrics_; }
    const AttitudeErrors& attitude() const { return attitude_; }
    // What became of the inertial sensor's samples since the first second, in which the firmware
    // sets it up; empty when it made none.
    std::optional<SampleCount> imuSamples() const;

private:
    const LocalFrame frame_;
    Metrics metrics_;
    AttitudeErrors attitude_;
    std::vector<Sample> samples_;
    double frame_us_ = 0, frames_us_ = 0;  // longest and sum since the last sample
    int frames_ = 0;
    std::optional<SampleCount> imu_from_;
    SampleCount imu_;
};

std::string flightCsv(const std::vector<Sample>& samples);

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/recorder.hpp"

#include <algorithm>
#include <cmath>

#include "simulator/constants.hpp"

namespace simulator {

constexpr uint64_t kSetUp_us = 1'000'000;  // from when the program begins

void Recorder::watchFrame(Board& board, const Telemetry& telemetry) {
    attitude_.watch(board.world().truth());
    if (telemetry.attitude) attitude_.take(*telemetry.attitude, board.begun_us());
    const std::optional<uint32_t> frame_us = board.lastFrame_us();
    if (!frame_us) return;
    frame_us_ = std::max(frame_us_, static_cast<double>(*frame_us));
    frames_us_ += *frame_us;
    ++frames_;
}

std::optional<SampleCount> Recorder::imuSamples() const {
    if (!imu_from_ || imu_.made == imu_from_->made) return std::nullopt;
    return SampleCount{imu_.made - imu_from_->made, imu_.read - imu_from_->read,
                       imu_.lost - imu_from_->lost, imu_.repeated - imu_from_->repeated};
}

static void copyTelemetry(Sample& sample, const Telemetry& from) {
    if (from.heartbeat) sample.mode = static_cast<int>(from.mode());
    sample.armed = from.armed();
    if (from.mode() == kModeAuto) sample.item = from.current();
    if (from.attitude) {
        sample.roll_deg = from.attitude->roll * kDegrees;
        sample.pitch_deg = from.attitude->pitch * kDegrees;
        sample.yaw_deg = from.attitude->yaw * kDegrees;
    }
    if (from.position) sample.height_m = from.position->relative_alt * 0.001;
    if (from.hud) sample.airspeed_mps = from.hud->airspeed;
    if (from.navigation) {
        sample.roll_demand_deg = from.navigation->nav_roll;
        sample.pitch_demand_deg = from.navigation->nav_pitch;
        sample.distance_m = from.navigation->wp_dist;
    }
    sample.reported = reportedBy(from);
}

void Recorder::sample(Board& board, const Telemetry& telemetry,
                      std::optional<double> cruise_speed_mps,
                      std::optional<double> loiter_radius_m) {
    const Truth& truth = board.world().truth();
    Sample sample{};
    sample.time_s = static_cast<double>(board.time_us()) * 1e-6;
    sample.truth = truth;
    sample.place = frame_.at(truth.latitude_deg, truth.longitude_deg);
    sample.mode = -1;
    copyTelemetry(sample, telemetry);
    metrics_.setCruiseSpeed(cruise_speed_mps);
    metrics_.setLoiterRadius(loiter_radius_m);
    if (!sample.armed) metrics_.setHomeHeight(truth.height_m);
    sample.planned = metrics_.sample(sample.time_s, truth, sample.place, sample.item);
    for (int i = 0; i < 8; ++i) {
        sample.servo_us[static_cast<size_t>(i)] = board.world().servoPulse_us(i + 1);
    }
    if (frames_ > 0) {
        sample.frame_us = frame_us_;
        sample.frame_mean_us = frames_us_ / frames_;
    }
    frame_us_ = frames_us_ = 0;
    frames_ = 0;
    imu_ = board.world().imu().samples();
    if (!imu_from_ && imu_.made > 0 && board.time_us() >= board.begun_us() + kSetUp_us)
        imu_from_ = imu_;
    samples_.push_back(sample);
}

}  // namespace simulator

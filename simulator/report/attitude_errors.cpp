// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/attitude_errors.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {

constexpr uint64_t kRemembered_us = 1'000'000;

static double apart_deg(double a_rad, double b_rad) {
    return std::remainder(a_rad - b_rad, 2 * M_PI) * 180 / M_PI;
}

void AttitudeErrors::watch(const Truth& truth) {
    past_.push_back(truth);
    while (past_.front().time_us + kRemembered_us < truth.time_us) past_.pop_front();
}

void AttitudeErrors::take(const mavlink::Attitude& sent, uint64_t begun_us) {
    if (sent.time_boot_ms == taken_ms_) return;
    taken_ms_ = sent.time_boot_ms;
    const uint64_t when_us = begun_us + uint64_t{sent.time_boot_ms} * 1000;
    const auto next = std::find_if(past_.begin(), past_.end(),
                                   [&](const Truth& truth) { return truth.time_us >= when_us; });
    // the message may be of the run before a restart
    if (next == past_.end() || next == past_.begin() || next->on_ground) return;
    const Truth& before = *std::prev(next);
    const double share = static_cast<double>(when_us - before.time_us) /
                         static_cast<double>(next->time_us - before.time_us);
    const auto at = [share](double a_rad, double b_rad) {
        return a_rad + share * std::remainder(b_rad - a_rad, 2 * M_PI);
    };
    roll_deg.add(apart_deg(double{sent.roll}, at(before.roll_rad, next->roll_rad)));
    pitch_deg.add(apart_deg(double{sent.pitch}, at(before.pitch_rad, next->pitch_rad)));
    yaw_deg.add(apart_deg(double{sent.yaw}, at(before.yaw_rad, next->yaw_rad)));
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/native/ppm_receiver.hpp"

#include <algorithm>
#include <utility>

#include "simulator/devices/ppm_encoder.hpp"

namespace simulator {

// As hal_avr/ppm.cpp has them.
constexpr uint64_t kGap_halfus = 2 * 4000, kShortest_halfus = 2 * 700, kLongest_halfus = 2 * 2500;
constexpr int kFewestChannels = 5;

uint64_t PpmReceiver::due_us() const {
    const uint64_t edge_halfus = radio_.nextEdge_us_x2();
    return edge_halfus == UINT64_MAX ? UINT64_MAX : (edge_halfus + 1) / 2;
}

void PpmReceiver::run() {
    for (uint64_t next; (next = radio_.nextEdge_us_x2()) <= now_us_ * 2;) {
        edge(next);
        radio_.passEdge();
    }
}

void PpmReceiver::edge(uint64_t time_halfus) {
    const uint64_t width_halfus = time_halfus - last_edge_halfus_;
    last_edge_halfus_ = time_halfus;
    if (width_halfus > kGap_halfus) {
        if (channel_ >= kFewestChannels) finish();
        channel_ = 0;
        building_halfus_.fill(0);
    } else if (width_halfus < kShortest_halfus || width_halfus > kLongest_halfus) {
        channel_ = -1;
    } else if (channel_ >= 0 && channel_ < hal::kRcChannels) {
        building_halfus_[channel_++] = static_cast<uint16_t>(width_halfus);
        if (channel_ == hal::kRcChannels) {
            finish();
            channel_ = -1;
        }
    }
}

void PpmReceiver::finish() {
    frame_halfus_ = building_halfus_;
    frame_us_ = now_us_;
    fresh_ = true;
}

bool PpmReceiver::read(uint16_t (&pulse_us)[hal::kRcChannels]) {
    for (int i = 0; i < hal::kRcChannels; ++i) pulse_us[i] = frame_halfus_[i] / 2;
    return std::exchange(fresh_, false);
}

uint32_t PpmReceiver::age_us() const {
    if (frame_us_ == UINT64_MAX) return UINT32_MAX;
    return static_cast<uint32_t>(std::min<uint64_t>(now_us_ - frame_us_, UINT32_MAX));
}

}  // namespace simulator

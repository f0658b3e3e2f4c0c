// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/native/ppm_receiver.hpp"

#include <algorithm>
#include <utility>

#include "simulator/devices/ppm_encoder.hpp"

namespace simulator {

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
    const bool too_long = width_halfus > UINT16_MAX;
    if (!frames_.edge(static_cast<uint16_t>(width_halfus), too_long)) return;
    frame_us_ = now_us_;
    fresh_ = true;
}

bool PpmReceiver::read(uint16_t (&pulse_us)[hal::kRcChannels]) {
    for (int i = 0; i < hal::kRcChannels; ++i) pulse_us[i] = frames_.newest()[i] / 2;
    return std::exchange(fresh_, false);
}

bool PpmReceiver::readWhole(uint16_t (&pulse_us)[hal::kRcChannels]) {
    const uint16_t* whole = frames_.takeWhole();
    for (int i = 0; whole && i < hal::kRcChannels; ++i) pulse_us[i] = whole[i] / 2;
    return whole != nullptr;
}

uint32_t PpmReceiver::age_us() const {
    if (frame_us_ == UINT64_MAX) return UINT32_MAX;
    return static_cast<uint32_t>(std::min<uint64_t>(now_us_ - frame_us_, UINT32_MAX));
}

}  // namespace simulator

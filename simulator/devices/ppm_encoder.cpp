// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ppm_encoder.hpp"

#include <algorithm>

namespace simulator {
namespace {

constexpr uint16_t kShortest_us = 900, kLongest_us = 2100;
constexpr uint16_t kLost_us[4] = {1500, 1500, 900, 1500};

}  // namespace

void PpmEncoder::sticks(const std::array<uint16_t, kChannels>& us, bool transmitting) {
    transmitting_ = transmitting;
    if (transmitting) {
        sticks_ = us;
        ever_ = true;
    }
    begin();
}

void PpmEncoder::jam(bool jammed) {
    if (jammed_ == jammed) return;
    jammed_ = jammed;
    begin();
}

void PpmEncoder::begin() {
    if (next_edge_ != UINT64_MAX || !sending()) return;
    next_edge_ = 2 * (now_us_ + kGap_us);
    channel_ = 0;
}

bool PpmEncoder::sending() const { return heard() || (ever_ && loss_ == Loss::failsafe_values); }

std::array<uint16_t, PpmEncoder::kChannels> PpmEncoder::sentChannels() const {
    auto channels = sticks_;
    if (!heard()) std::copy(std::begin(kLost_us), std::end(kLost_us), channels.begin());
    for (uint16_t& width : channels) width = std::clamp(width, kShortest_us, kLongest_us);
    return channels;
}

void PpmEncoder::passEdge() {
    if (channel_ == 0) frame_ = sentChannels();
    if (channel_ < kChannels) {
        next_edge_ += 2u * frame_[channel_++];
    } else {
        channel_ = 0;
        next_edge_ = sending() ? next_edge_ + 2 * kGap_us : UINT64_MAX;
    }
}

}  // namespace simulator

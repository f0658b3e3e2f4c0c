// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ppm_encoder.hpp"

#include <algorithm>

namespace simulator {
namespace {

constexpr uint16_t kShortest_us = 900, kLongest_us = 2100;
constexpr int kThrottle = 2;
// The first compare after the generator's start is the timer's longest, 65535 steps of 0.5 us.
constexpr uint64_t kStart_us = 32'768;
// 128 changes of the other wires without a pulse on wire 3, 14 a frame of 20 ms.
constexpr uint64_t kThrottleLost_us = 180'000;
constexpr uint64_t kHeldLost_us = 1'000'000;  // of ArduPPM 2.3.16

// A receiver whose travel is set to 150 %, as its own sum has it.
uint16_t widened(uint16_t us) {
    return static_cast<uint16_t>(std::clamp(1500 + 2 * (us - 1500), 700, 2300));
}

}  // namespace

void PpmEncoder::sticks(const Channels& us, bool transmitting) {
    transmitting_ = transmitting;
    if (transmitting) sticks_ = us;
    noteInput();
    begin();
}

void PpmEncoder::fail(FaultKind kind, uint64_t now_us) {
    now_us_ = std::max(now_us_, now_us);
    if (fault_ == kind) return;
    fault_ = kind;
    failed_us_ = now_us;
    noteInput();
    begin();
}

void PpmEncoder::power(bool on, uint64_t now_us) {
    now_us_ = std::max(now_us_, now_us);
    powered_ = on;
    brown_out_ = brown_out_ || !on;
    ever_ = false;
    powered_us_ = silent_since_us_ = now_us;
    sent_ = on ? kFailsafe_us : sent_;
    next_edge_ = UINT64_MAX;
    channel_ = split_x2_ = 0;
    noteInput();
    begin();
}

void PpmEncoder::powerReceiver(bool on, uint64_t now_us) {
    now_us_ = std::max(now_us_, now_us);
    receiver_on_ = on;
    noteInput();
    begin();
}

void PpmEncoder::advanceTo(uint64_t now_us) {
    now_us_ = std::max(now_us_, now_us);
    begin();
}

void PpmEncoder::noteInput() {
    if (heard_before_ && !heard()) silent_since_us_ = now_us_;
    heard_before_ = heard();
    ever_ = ever_ || (powered_ && heard());
}

// The watchdog starts the frames after a brown-out.
bool PpmEncoder::sending() const {
    if (!powered_ || fault_ == FaultKind::silent) return false;
    return ever_ || (brown_out_ && now_us_ >= powered_us_ + kWatchdog_us);
}

void PpmEncoder::begin() {
    if (next_edge_ != UINT64_MAX || !sending()) return;
    next_edge_ = 2 * (now_us_ + (powered_us_ > 0 ? kStart_us : kGap_us));
    channel_ = 0;
    split_x2_ = 0;
}

void PpmEncoder::takeInputs(uint64_t at_us) {
    if (!heard()) return takeNothing(at_us);
    for (int i = 0; i < kChannels; ++i) takeWire(i, at_us);
}

void PpmEncoder::takeWire(int channel, uint64_t at_us) {
    const auto i = static_cast<size_t>(channel);
    if (channel == kThrottle && fault_ == FaultKind::throttle_lost) {
        if (at_us >= failed_us_ + kThrottleLost_us) sent_[i] = kFailsafe_us[i];
        return;
    }
    if (fault_ == FaultKind::wide)
        sent_[i] = widened(sticks_[i]);
    else if (sticks_[i] >= kShortest_us && sticks_[i] <= kLongest_us)
        sent_[i] = sticks_[i];
}

void PpmEncoder::takeNothing(uint64_t at_us) {
    const bool holds = fault_ == FaultKind::held;
    if (at_us < silent_since_us_ + (holds ? kHeldLost_us : kWatchdog_us)) return;
    constexpr int kHeldFrom = 4;
    std::copy_n(kFailsafe_us.begin(), holds ? kHeldFrom : kChannels, sent_.begin());
}

std::vector<uint16_t> PpmEncoder::nextFrame(uint64_t at_us) {
    takeInputs(at_us);
    std::vector<uint16_t> frame(sent_.begin(), sent_.end());
    if (!heard()) return frame;
    if (fault_ == FaultKind::nine_channels) frame.push_back(1500);
    return frame;
}

void PpmEncoder::passEdge() {
    do step();
    while (next_edge_ != UINT64_MAX && fault_ == FaultKind::missed_edge && oneOfFifty());
}

void PpmEncoder::step() {
    if (next_edge_ == UINT64_MAX) return;
    if (split_x2_ > 0) {
        next_edge_ += split_x2_;
        split_x2_ = 0;
        return;
    }
    if (channel_ == 0) frame_ = nextFrame(next_edge_ / 2);
    if (channel_ < frame_.size()) {
        const uint32_t width_x2 = 2u * frame_[channel_++];
        if (fault_ == FaultKind::extra_edge && oneOfFifty()) split_x2_ = width_x2 / 2;
        next_edge_ += width_x2 - split_x2_;
    } else {
        channel_ = 0;
        next_edge_ = sending() ? next_edge_ + 2 * kGap_us : UINT64_MAX;
    }
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ads7844.hpp"

#include <algorithm>

namespace simulator {
namespace {

constexpr uint8_t kSingleEnded = 0x04;
constexpr int kControlBits = 8, kBusyBits = 1, kValueBits = 12;
constexpr int kSoonest = 15;  // clocks from one start bit to the next, table III

// Assumed: within the 1.6 ms it loses one step, what the data sheet's accuracy leaves.
constexpr double kDroop_counts_per_us = 1 / 1600.0;

// Data sheet, table I: A2 A1 A0 of the single-ended inputs.
constexpr int kChannelAt[8] = {0, 2, 4, 6, 1, 3, 5, 7};

}  // namespace

void Ads7844::select(bool chosen) {
    if (chosen_ != chosen) {
        clocks_ = kSoonest;
        answer_bits_ = 0;
    }
    chosen_ = chosen;
}

uint8_t Ads7844::transfer(uint8_t mosi, uint64_t now_us) {
    if (!chosen_ || unplugged_) return 0xFF;
    uint8_t miso = 0;
    for (int bit = 7; bit >= 0; --bit)
        miso = static_cast<uint8_t>(miso << 1 | clock(mosi >> bit & 1, now_us));
    return miso;
}

// Figure 4: while the next question goes in, the last bits of the answer before it come out.
bool Ads7844::clock(bool in, uint64_t now_us) {
    const bool out = answer_bits_ > 0 && answer(now_us);
    if (clocks_ >= kSoonest && in) {
        clocks_ = 0;
        control_ = 0;
    }
    if (clocks_ < kControlBits) control_ = static_cast<uint8_t>(control_ << 1 | in);
    if (clocks_ < kSoonest && ++clocks_ == kControlBits) convert(now_us);
    return out;
}

// By successive approximation: a bit is set when what is still held is at least that.
bool Ads7844::answer(uint64_t now_us) {
    if (--answer_bits_ >= kValueBits) return false;  // busy
    const uint64_t since_us = now_us - sampled_us_;
    longest_us_ = std::max(longest_us_, since_us);
    const double held =
        std::max(0.0, held_counts_ - static_cast<double>(since_us) * kDroop_counts_per_us);
    const int tried = decided_ | 1 << answer_bits_;
    if (held < tried) return false;
    decided_ = tried;
    return true;
}

void Ads7844::convert(uint64_t now_us) {
    const int channel = kChannelAt[control_ >> 4 & 7];
    ++conversions_[static_cast<size_t>(channel)];
    const double input_v = volts && (control_ & kSingleEnded) ? volts(channel) : 0;
    held_counts_ = std::clamp(input_v / kReference_v * 4096, 0.0, 4095.0);
    sampled_us_ = now_us;
    decided_ = 0;
    answer_bits_ = kBusyBits + kValueBits;
}

}  // namespace simulator

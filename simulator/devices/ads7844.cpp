// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ads7844.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {
namespace {

constexpr uint8_t kSingleEnded = 0x04;
constexpr int kControlBits = 8, kBusyBits = 1, kValueBits = 12;
constexpr int kSoonest = 15;  // clocks from one start bit to the next, table III

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

uint8_t Ads7844::transfer(uint8_t mosi) {
    if (!chosen_ || unplugged_) return 0xFF;
    uint8_t miso = 0;
    for (int bit = 7; bit >= 0; --bit)
        miso = static_cast<uint8_t>(miso << 1 | clock(mosi >> bit & 1));
    return miso;
}

// Figure 4: while the next question goes in, the last bits of the answer before it come out.
bool Ads7844::clock(bool in) {
    const bool out = answer_bits_ > 0 && (answer_ >> --answer_bits_ & 1);
    if (clocks_ >= kSoonest && in) {
        clocks_ = 0;
        control_ = 0;
    }
    if (clocks_ < kControlBits) control_ = static_cast<uint8_t>(control_ << 1 | in);
    if (clocks_ < kSoonest && ++clocks_ == kControlBits) convert();
    return out;
}

void Ads7844::convert() {
    const int channel = kChannelAt[control_ >> 4 & 7];
    ++conversions_[static_cast<size_t>(channel)];
    const double input_v = volts && (control_ & kSingleEnded) ? volts(channel) : 0;
    const double counts = std::floor(input_v / kReference_v * 4096);
    answer_ = static_cast<uint16_t>(std::clamp(counts, 0.0, 4095.0));
    answer_bits_ = kBusyBits + kValueBits;
}

}  // namespace simulator

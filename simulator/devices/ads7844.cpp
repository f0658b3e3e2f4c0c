// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ads7844.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {
namespace {

constexpr uint8_t kStart = 0x80, kSingleEnded = 0x04;

// Data sheet, table I: A2 A1 A0 of the single-ended inputs.
constexpr int kChannelAt[8] = {0, 2, 4, 6, 1, 3, 5, 7};

}  // namespace

void Ads7844::select(bool chosen) {
    if (chosen_ != chosen) answer_ = 0;
    chosen_ = chosen;
}

// Figure 5: while the next question goes in, the last bits of the answer before it come out.
uint8_t Ads7844::transfer(uint8_t mosi) {
    if (!chosen_ || unplugged_) return 0xFF;
    const auto out = static_cast<uint8_t>(answer_ >> 8);
    answer_ = static_cast<uint16_t>(answer_ << 8);
    if (mosi & kStart) convert(mosi);
    return out;
}

// One busy bit, twelve of the value, zeros.
void Ads7844::convert(uint8_t control) {
    const int channel = kChannelAt[control >> 4 & 7];
    ++conversions_[static_cast<size_t>(channel)];
    const double input_v = volts && (control & kSingleEnded) ? volts(channel) : 0;
    const double counts = std::floor(input_v / kReference_v * 4096);
    answer_ = static_cast<uint16_t>(static_cast<int>(std::clamp(counts, 0.0, 4095.0)) << 3);
}

}  // namespace simulator

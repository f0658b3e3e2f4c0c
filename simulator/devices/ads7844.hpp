// SPDX-License-Identifier: GPL-3.0-or-later
// Burr-Brown ADS7844 (data sheet SBAS100): eight inputs of 12 bits, single-ended, reference 3.3 V;
// bit by bit, as a question may begin in the middle of a byte.
#pragma once
#include <array>
#include <cstdint>
#include <functional>

namespace simulator {

class Ads7844 {
public:
    static constexpr int kChannels = 8;
    static constexpr double kReference_v = 3.3;

    void select(bool chosen);
    uint8_t transfer(uint8_t mosi);

    std::function<double(int channel)> volts;  // of an input, at its conversion
    void unplug(bool unplugged) { unplugged_ = unplugged; }
    uint64_t conversions(int channel) const { return conversions_[static_cast<size_t>(channel)]; }

private:
    bool clock(bool in);
    void convert();

    uint8_t control_ = 0;
    int clocks_ = 15;  // since the start bit
    uint16_t answer_ = 0;
    int answer_bits_ = 0;  // still to be shifted out
    std::array<uint64_t, kChannels> conversions_{};
    bool chosen_ = false, unplugged_ = false;
};

}  // namespace simulator

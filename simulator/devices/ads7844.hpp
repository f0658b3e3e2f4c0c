// SPDX-License-Identifier: GPL-3.0-or-later
// Burr-Brown ADS7844 (data sheet SBAS100): eight inputs of 12 bits, single-ended, reference 3.3 V;
// bit by bit, as a question may begin in the middle of a byte. What it has sampled lies on a
// capacitor that leaks until the last bit is decided, each with its clock: the data sheet's slowest
// clock of 10 kHz allows 1.6 ms for 16 of them.
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
    uint8_t transfer(uint8_t mosi, uint64_t now_us);

    std::function<double(int channel)> volts;  // of an input, at its conversion
    void unplug(bool unplugged) { unplugged_ = unplugged; }
    uint64_t longestConversion_us() const { return longest_us_; }
    uint64_t conversions(int channel) const { return conversions_[static_cast<size_t>(channel)]; }

private:
    bool clock(bool in, uint64_t now_us);
    bool answer(uint64_t now_us);
    void convert(uint64_t now_us);

    uint8_t control_ = 0;
    int clocks_ = 15;  // since the start bit
    double held_counts_ = 0;
    uint64_t sampled_us_ = 0, longest_us_ = 0;
    int decided_ = 0;      // of the answer, so far
    int answer_bits_ = 0;  // still to be shifted out
    std::array<uint64_t, kChannels> conversions_{};
    bool chosen_ = false, unplugged_ = false;
};

}  // namespace simulator

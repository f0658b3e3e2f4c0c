// SPDX-License-Identifier: GPL-3.0-or-later
// What a serial receiver makes of a byte sent at another rate than its own: it samples the wrong
// places of the wrong bits, drops what lacks a stop bit and takes the rest for something else.
#pragma once
#include <cstdint>
#include <cstdlib>
#include <optional>

namespace simulator {

class LineNoise {
public:
    std::optional<uint8_t> through(uint8_t byte, uint32_t sender_baud, uint32_t receiver_baud) {
        const int64_t apart = std::abs(int64_t{sender_baud} - int64_t{receiver_baud});
        if (apart * 25 <= sender_baud) return byte;  // 4 %: bit 10 is still sampled within itself
        state_ = state_ * 1664525u + 1013904223u;    // Numerical Recipes' generator
        if (!(state_ >> 31)) return std::nullopt;
        return static_cast<uint8_t>(byte ^ state_ >> 16 ^ 0x55);
    }

private:
    uint32_t state_ = 1;
};

}  // namespace simulator

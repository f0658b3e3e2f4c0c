// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/dead_gyros.hpp"

namespace firmware {
namespace sensors {

uint8_t DeadGyros::look(const int32_t (&rates)[3]) {
    uint8_t dead = 0, bit = kRollGyro;
    for (uint8_t i = 0; i < 3; ++i, bit = static_cast<uint8_t>(bit << 1)) {
        auto& gyro = gyros_[i];
        const uint8_t now = static_cast<uint8_t>(rates[i]);
        if (now != gyro.last) gyro.still = 0;
        gyro.last = now;
        if (gyro.still >= kFrames)
            dead |= bit;
        else
            ++gyro.still;
    }
    return dead;
}

}  // namespace sensors
}  // namespace firmware

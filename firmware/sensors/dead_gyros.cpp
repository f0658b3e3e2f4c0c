// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/dead_gyros.hpp"

namespace firmware {
namespace sensors {

// Of ordinary gyros two change in every frame: 0.3 s. Of ones with a twentieth of their noise two
// change in every other frame, and one repeats its reading through three in four: for as long as
// this takes hardly once in 10^10.
constexpr uint8_t kDead = 60;

uint8_t DeadGyros::look(const int32_t (&rates)[3]) {
    uint8_t changed = 0;
    for (uint8_t i = 0; i < 3; ++i) {
        Gyro& gyro = gyros_[i];
        const uint8_t now = static_cast<uint8_t>(rates[i]);
        if (now == gyro.last) continue;
        gyro.last = now;
        gyro.others_changed = 0;
        ++changed;
    }
    if (changed == 3) return 0;
    // One that has just changed counts, too: at its next change it is back at 0.
    uint8_t dead = 0, bit = kRollGyro;
    for (Gyro& gyro : gyros_) {
        if (gyro.others_changed >= kDead)
            dead |= bit;
        else
            gyro.others_changed += changed;
        bit = static_cast<uint8_t>(bit << 1);
    }
    return dead;
}

}  // namespace sensors
}  // namespace firmware

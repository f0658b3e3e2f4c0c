// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the gyro that is dead while the others work. A quiet gyro may repeat its reading for a
// while, in which the others, which are as quiet, repeat theirs: what counts is how often those
// changed.
#pragma once
#include <stdint.h>

namespace firmware {
namespace sensors {

class DeadGyros {
public:
    // Every frame, what was read about x, y, z; a bit for each that is dead. When all three stand
    // still there is no evidence here: that is seen by the sensor's health.
    uint8_t look(const int32_t (&rates)[3]);

private:
    struct Gyro {
        uint8_t last;            // the lowest byte of its reading
        uint8_t others_changed;  // so often since this one did
    };
    Gyro gyros_[3] = {};
};

constexpr uint8_t kRollGyro = 1, kPitchGyro = 2, kYawGyro = 4;

}  // namespace sensors
}  // namespace firmware

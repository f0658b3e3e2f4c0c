// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the gyro that is dead while the others live: one that lives never says the same for a fifth
// of a second, if only for its noise.
#pragma once
#include <stdint.h>

namespace firmware {
namespace sensors {

class DeadGyros {
public:
    // Every frame, what was read about x, y, z; a bit for each that is dead.
    uint8_t look(const int32_t (&rates)[3]);

private:
    static constexpr uint8_t kFrames = 20;
    struct {
        uint8_t last, still;  // the lowest byte; frames without a change
    } gyros_[3] = {};
};

constexpr uint8_t kRollGyro = 1, kPitchGyro = 2, kYawGyro = 4;

}  // namespace sensors
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// What every inertial sensor hands out, whichever board it is on.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace drivers {

struct ImuSample {
    core::Vector3 rate_rads;  // body axes: x forward, y right, z down
    core::Vector3 force_mss;  // specific force: (0, 0, -g) at rest and level
    uint8_t count;            // samples averaged
    uint8_t periods;  // sample periods since the last take, unreadable ones too: the time covered
};

// The same in whole steps and not averaged, for what reckons in fixed point.
constexpr float kRateStep_rads = core::kPi / 180.0f / 16.4f;  // of an MPU-6000 at 2000 deg/s
constexpr float kForceStep_mss = core::kGravity_mss / 4096.0f;
struct ImuSums {
    int32_t rate[3], force[3];  // x, y, z
    uint8_t count, periods;
};

}  // namespace drivers

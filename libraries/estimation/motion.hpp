// SPDX-License-Identifier: GPL-3.0-or-later
// What the inertial sensors felt in a frame, body axes: x forward, y right, z down.
#pragma once
#include <stdint.h>

#include "core/fixed.hpp"

namespace estimation {

constexpr float kSamplePeriod_s = 0.005f;  // 200 Hz

// Small angles about the three axes, in 2^-30 rad.
struct Turn {
    static constexpr float kSteps = 1073741824.0f;
    int32_t of[3];
};

struct Motion {
    Turn turned;                    // in these periods
    core::BodyRates rate_rads;      // the mean
    core::Accelerations force_mss;  // the mean specific force: (0, 0, -g) at rest and level
    uint8_t periods;                // of kSamplePeriod_s
};

}  // namespace estimation

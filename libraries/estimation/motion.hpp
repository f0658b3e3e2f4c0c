// SPDX-License-Identifier: GPL-3.0-or-later
// What the inertial sensors measured in a frame, body axes: x forward, y right, z down.
#pragma once
#include <stdint.h>

#include "core/fixed.hpp"

namespace estimation {

constexpr float kSamplePeriod_s = 0.005f;  // 200 Hz

// A small angle in radians, or a part of a unit vector: what small steps are summed up in.
using Fine = core::Fixed32<30>;
// Small angles about the three axes, as a Fine's steps.
struct DeltaAngle {
    static constexpr float kSteps = Fine::kSteps;
    int32_t of[3];
};
// A rotation in a sample period as it is kept over a restart, in radians.
using SavedDeltaAngle = core::Fixed<24>;
constexpr int32_t kSavedDeltaAngleSteps = Fine::kOne / SavedDeltaAngle::kOne;
// Horizontal acceleration over ground in m/s2, before it is summed up.
using FineAcceleration = core::Fixed32<23>;

struct Motion {
    DeltaAngle turned;              // in these periods
    core::BodyRates rate_rads;      // the mean
    core::Accelerations force_mss;  // the mean specific force: (0, 0, -g) at rest and level
    uint8_t periods;                // of kSamplePeriod_s
};

}  // namespace estimation

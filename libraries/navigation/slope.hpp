// SPDX-License-Identifier: GPL-3.0-or-later
// The height that belongs to a place along a leg.
#pragma once
#include "core/maths.hpp"

namespace navigation {

struct HeightDemand {
    float height_m;
    float climb_mps;  // at which it moves as the airplane goes on
};

// A straight line from the one height at the leg's start to the other at its end, level beyond
// both. `along_mps` is the speed along the leg.
inline HeightDemand heightOnSlope(float from_m, float to_m, float length_m, float along_m,
                                  float along_mps) {
    if (!core::isPositive(along_m)) return {from_m, 0};
    if (along_m >= length_m || length_m < 1) return {to_m, 0};
    const float slope = (to_m - from_m) / length_m;
    return {from_m + slope * along_m, slope * along_mps};
}

}  // namespace navigation

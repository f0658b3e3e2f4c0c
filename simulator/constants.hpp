// SPDX-License-Identifier: GPL-3.0-or-later
// Constants of the simulated world.
#pragma once

#include <cmath>

namespace simulator {

constexpr double kRadians = M_PI / 180;  // in a degree
constexpr double kDegrees = 180 / M_PI;  // in a radian
// ISO 2533, the standard atmosphere
constexpr double kGravity_mss = 9.80665;
constexpr double kSeaLevelDensity_kgm3 = 1.225;

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geo/position.hpp"

namespace firmware {
namespace modes {

// Demands the height at cruise speed; the bank is the mode's own.
void demandLevel(float height_m);
// Demands a circle of WP_LOITER_RAD (its sign is the direction) around the place, at the height.
void demandCircle(const geo::Position& centre, float height_m);

}  // namespace modes
}  // namespace firmware

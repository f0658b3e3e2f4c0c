// SPDX-License-Identifier: GPL-3.0-or-later
// Magnetic declination from a small table of the World Magnetic Model, east of north positive.
// Between 60 S and 60 N within 0.8 degrees, up to 70 degrees within 1.2, but for the seas south of
// Australia: towards the magnetic pole there (64 S, 135 E) it is as uncertain as a compass itself
// becomes. Beyond 70 degrees the declination of the 70th parallel.
#pragma once
#include <stdint.h>

#include "geo/position.hpp"

namespace geo {

int16_t declination_cd(const Position& position);

// 1: the field points downwards, by 25 degrees at least, -1: upwards; 0: within 20 degrees of where
// it lies level.
int8_t fieldPointsDown(const Position& position);

}  // namespace geo

// SPDX-License-Identifier: GPL-3.0-or-later
// Home: where the airplane returns to, and the zero of its heights.
#pragma once
#include "geo/position.hpp"

namespace firmware {
namespace mission {

bool setHomeHere();                                                // false: no 3D fix
void setHome(const geo::Position& position, int32_t altitude_cm);  // above sea level
// After a restart: as it was before. Nothing that is flown moves.
void resumeHome(const geo::Position& position, int32_t altitude_cm);

}  // namespace mission
}  // namespace firmware

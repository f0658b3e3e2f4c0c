// SPDX-License-Identifier: GPL-3.0-or-later
// Rally points: where RTL goes instead of home when one is nearer, or near enough (RALLY_LIMIT_KM),
// as a mode or as a mission's command.
#pragma once
#include "geo/position.hpp"

namespace firmware {
namespace mission {

void rallyFollow();  // 1 Hz: RALLY_TOTAL

using FlyTo = void (*)(const geo::Position& place, float height_m);

void rallyBegin();             // home is demanded; the points are looked at from now on,
void rallyLook(FlyTo fly_to);  // one each call, and the best so far is demanded instead

}  // namespace mission
}  // namespace firmware

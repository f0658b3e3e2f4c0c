// SPDX-License-Identifier: GPL-3.0-or-later
// The line of the fence: its zones as they are stored. What is to be stayed in must hold the
// airplane all at once, what is to be stayed out of never. Records are read where they lie, a few
// each call; there is no copy.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "geo/position.hpp"

namespace firmware {
namespace mission {

enum class Line : uint8_t {
    unknown,   // not yet looked at since it was stored
    checking,  // is the way back inside?
    none,
    unfit,  // blank, no zone or too few corners, or the way back lies outside
    fit,
};

enum class Side : uint8_t { unknown, inside, outside };

void fenceLineStart();
void fenceLineFollow();  // looks at what is stored when it has changed

bool fenceLineWaits();  // who writes much into the EEPROM in the background lets it look

Line fenceLine();
// Where a place lies: to be asked until it is known; the place of the first call counts.
Side fenceSide(const geo::Position& place);
uint8_t fenceCorners();  // of the polygon that stands alone or beside one circle
bool fenceHasZones();    // more than that polygon, or other ones
bool fenceHasWayBack();
MUST_USE core::Status fenceWayBack(geo::Position& to);

}  // namespace mission
}  // namespace firmware

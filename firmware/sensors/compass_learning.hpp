// SPDX-License-Identifier: GPL-3.0-or-later
// The compass's offsets, from the airplane being turned about: whichever way it lies the field is
// as strong. Two readings b and c that lie well apart show how far the offset o is off along their
// difference, for 2 o (c - b) = b^2 - c^2; it is moved there by a part of the way (Kaczmarz 1937).
// Many readings are compared with one, then another takes its place.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace firmware {
namespace sensors {

void compassTurnsStart();
void compassTurnsUndo();  // brings back the offsets from before
uint8_t compassTurns_pct();
float compassMiss_mg();
bool compassFits(uint8_t within_mg);  // the offsets found make sense

// From the compass, without the offsets. Does something while it is turned about on
// the ground for that, or in flight when COMPASS_LEARN is 1.
void learnCompass(const core::Vector3& reading_mg);
void saveLearntCompass();   // at disarming: offsets that make sense are stored by and by, ...
void storeLearntCompass();  // ... an axis each call

}  // namespace sensors
}  // namespace firmware

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

// The offsets in use are those that are stored: at power-on. While it is disarmed and not turned
// about learnCompass() looks itself.
void noteStoredOffsets();
void restoreStoredOffsets();
void compassTurnsStart();
uint8_t compassTurns_pct();
float compassMiss_mg();
bool compassFits(uint8_t within_mg);  // the offsets found make sense

// What the motor's field goes with, as its current does: about the square of the throttle, 0..1.
float motorPower();

// From the compass, the motor's field taken off, without the offsets. Does something while it is
// turned about on the ground for that, or in flight when COMPASS_LEARN is 1.
void learnCompass(const int16_t (&reading_mg)[3]);
bool compassLearnsInFlight();
// What the estimator has found in turns that the compass still reads of the airplane itself, in
// mG along the body's axes, goes over into the offsets; 0 is left of it. What of it comes and goes
// with motorPower() is learnt as COMPASS_MOT. Five times a second.
void takeCompassOffset(core::Vector3& own_mg);
// What of the offsets is not stored yet, and would be lost by a restart, is taken off them and
// added to what the compass reads of the airplane itself, mG.
void addOffsetsNotStored(int16_t (&own_mg)[3]);
// At disarming: offsets that make sense are stored by and by; of a compass that is known to fail
// those from before the flight are brought back.
void saveLearntCompass();
void storeLearntCompass();  // one of the six values each call

}  // namespace sensors
}  // namespace firmware

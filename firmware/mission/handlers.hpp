// SPDX-License-Identifier: GPL-3.0-or-later
// What the command table's rows point at: range checks, starts, checks. Grouped by class in
// navigation_, condition_, action_ and tuning_commands.cpp; ranges in ranges.cpp.
#pragma once
#include "core/status.hpp"
#include "geo/position.hpp"
#include "mission/command_table.hpp"

namespace firmware {
namespace mission {

using ::mission::ItemPosition;
using ::mission::Jump;
using ::mission::LegStart;
using ::mission::Progress;
using ::mission::Record;

// ---- ranges.cpp: 0 or a MissionResult
uint8_t anything(const Record&, ItemPosition);
uint8_t placeInRange(const Record&, ItemPosition);
uint8_t takeoffInRange(const Record&, ItemPosition);
uint8_t delayInRange(const Record&, ItemPosition);
uint8_t changeAltitudeInRange(const Record&, ItemPosition);
uint8_t distanceInRange(const Record&, ItemPosition);
uint8_t jumpInRange(const Record&, ItemPosition);
uint8_t changeSpeedInRange(const Record&, ItemPosition);
uint8_t setHomeInRange(const Record&, ItemPosition);
uint8_t setParameterInRange(const Record&, ItemPosition);
uint8_t setRelayInRange(const Record&, ItemPosition);
uint8_t repeatRelayInRange(const Record&, ItemPosition);
uint8_t setServoInRange(const Record&, ItemPosition);
uint8_t repeatServoInRange(const Record&, ItemPosition);
uint8_t continueInRange(const Record&, ItemPosition);
uint8_t toHeightInRange(const Record&, ItemPosition);
uint8_t interestInRange(const Record&, ItemPosition);
uint8_t mountInRange(const Record&, ItemPosition);
uint8_t triggerDistanceInRange(const Record&, ItemPosition);
uint8_t oneImageInRange(const Record&, ItemPosition);
uint8_t fenceInRange(const Record&, ItemPosition);
// APM 1.0
uint8_t modeInRange(const Record&, ItemPosition);
uint8_t firstInRange(const Record&, ItemPosition);
uint8_t indexInRange(const Record&, ItemPosition);
uint8_t variableInRange(const Record&, ItemPosition);
uint8_t onOffInRange(const Record&, ItemPosition);
uint8_t cruiseSpeedInRange(const Record&, ItemPosition);
uint8_t cruiseThrottleInRange(const Record&, ItemPosition);
uint8_t resetHomeInRange(const Record&, ItemPosition);
uint8_t gainInRange(const Record&, ItemPosition);
uint8_t channelInRange(const Record&, ItemPosition);
uint8_t otherRadioInRange(const Record&, ItemPosition);
uint8_t eventInRange(const Record&, ItemPosition);
uint8_t pulseInRange(const Record&, ItemPosition);

// ---- navigation_commands.cpp
void startWaypoint(const Record&, LegStart);
Progress waypointDone(const Record&);
void startCircle(const Record&, LegStart);
Progress never(const Record&);
Progress done(const Record&);
Progress turnsDone(const Record&);
Progress timeDone(const Record&);
void startReturn(const Record&, LegStart);
Progress returnDone(const Record&);
void startLand(const Record&, LegStart);
Progress landDone(const Record&);
void startTakeoff(const Record&, LegStart);
Progress takeoffDone(const Record&);
void startContinue(const Record&, LegStart);
Progress continueDone(const Record&);
Progress toHeightDone(const Record&);

void here(Record& record);  // the airplane's place
bool placeless();           // the NAV flown has no place
void rememberPlace();       // of the NAV that has just finished: the next leg begins there
void holdPlace();           // circles the place remembered
void forgetPlace();         // nothing has finished yet

// ---- landing.cpp
void landAgain();    // from the nearest DO_LAND_START; without one the landing itself
void stepLanding();  // 10 Hz
// In a landing: all throttle goes around, once the stick has been below.
void breakOffByThrottle(bool& was_below);

// ---- condition_commands.cpp
void startDelay(const Record&);
Progress delayDoneP1(const Record&);  // APM 1.0
Progress delayDoneP3(const Record&);  // APM 2.0
void startChangeAltitude(const Record&);
Progress changeAltitudeDone(const Record&);
void startDistance(const Record&);
Progress distanceDone(const Record&);
int32_t climbRate_cms(const Record&);
void stepClimb();     // 10 Hz in AUTO: moves the demanded height
void goOnClimbing();  // after a resume: from the airplane's height to the one demanded before
void forgetClimb();   // a NAV begins: its own height counts
void shiftClimb(float by_m);

// ---- action_commands.cpp
Jump jumpCounted(const Record&);
void changeSpeed(const Record&);
void setHomeAction(const Record&);
void setParameterAction(const Record&);
float parameterValue(const Record&);
void setRelay(const Record&);
void repeatRelay(const Record&);
void setServo(const Record&);
void repeatServo(const Record&);
void nothingToDo(const Record&);
void triggerCamera(const Record&);
void triggerByDistance(const Record&);
int32_t triggerDistance_cm(const Record&);
void enableFence(const Record&);
void flyInverted(const Record&);

// ---- places.cpp
// False: no NAV, or none with a place that is known before it loads.
bool placeOfNav(const Record&, ItemPosition, geo::Position& place);
// Of the NAV behind the one flown, whatever jumps there are. busy: not found yet; bad_argument:
// there is none, or it has no place; else it cannot be read.
MUST_USE core::Status nextPlace(geo::Position& place);

// ---- tuning_commands.cpp: of both sets
void setSlot(uint8_t slot, float value);  // a parameter's; what is refused is reported
// ---- and of APM 1.0 only
Jump jumpToFirst(const Record&);
Jump jumpToIndex(const Record&);
void changeMode(const Record&);
void queryVariable(const Record&);
void broadcastVariable(const Record&);
void switchRadio(const Record&);
void cruiseSpeed(const Record&);
void cruiseThrottle(const Record&);
void resetHome(const Record&);
void setGain(const Record&);
void setChannel(const Record&);
void setOtherRadio(const Record&);
void repeatEvent(const Record&);
void setRelayP1(const Record&);
void setPulse(const Record&);
// The slot of the parameter that plays the part; kNoSlot: none does.
constexpr uint8_t kNoSlot = 0xFF;
uint8_t gainSlot(uint8_t id, uint8_t index);
uint8_t channelSlot(uint8_t id, uint8_t index);
uint8_t otherRadioSlot(uint8_t index);
float gain(const Record&);

// Above home, whatever the record's altitude is measured from.
float heightOf_m(const Record&);

}  // namespace mission
}  // namespace firmware

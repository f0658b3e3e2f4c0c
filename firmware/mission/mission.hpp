// SPDX-License-Identifier: GPL-3.0-or-later
// The mission as the rest of the firmware sees it: app/tasks.cpp runs it, modes/auto.cpp enters
// and leaves it, gcs/ moves it up and down. Nothing here waits for the EEPROM: what answers
// `busy` is asked again in a later frame.
#pragma once
#include <stdint.h>

#include "core/rom.hpp"
#include "core/status.hpp"
#include "firmware/notify/status_text.hpp"

namespace firmware {
namespace mission {

// One item in MAVLink's terms (MISSION_ITEM_INT); NaN in a parameter means "not given".
struct MissionItem {
    uint16_t command;
    uint8_t frame;  // MAV_FRAME
    float param1, param2, param3, param4;
    int32_t x, y;  // latitude and longitude, 1e-7 degrees
    float z;       // altitude, metres, in the frame's sense
};

// MAV_MISSION_RESULT, and one value of our own that never goes on the wire.
enum class MissionResult : uint8_t {
    accepted = 0,
    error = 1,
    unsupported_frame = 2,
    unsupported = 3,
    no_space = 4,
    invalid = 5,
    invalid_param1 = 6,  // ... param7 = 12: 6 + the parameter's number - 1
    invalid_sequence = 13,
    denied = 14,
    cancelled = 15,
    busy = 0xFF,  // not yet: ask again in a later frame
};

void missionBoot();  // once: finds the stored mission
void missionRun();   // 10 Hz: one pass while the mode is AUTO, background work always
// 10 Hz, between two missionRuns: the next part of a long pass; or fetches the record that the last
// poll found in the way of a write, for the EEPROM rests only for a reader that comes back soon.
void missionCatchUp();
// 10 Hz: sends the values that a mission asks for and that could not be sent at once.
void reportVariables();

// AUTO. Entering fails when there is nothing to fly; why_not is then a flash text.
bool missionEnter(notify::StatusText& why_not);
void missionLeave();
bool missionComplete();  // no NAV left: AUTO gives way to RTL (or stays after a LAND)
void missionRestart();

bool missionKnown();                     // the stored one has been looked for
uint16_t missionCount();                 // items stored, home (item 0) included; 0: none
uint16_t missionCurrent();               // index of the NAV flown, 0 when none
bool missionSetCurrent(uint16_t index);  // false: no such item or no NAV
bool takeReached(uint16_t& index);       // a NAV that finished and was not yet reported

// AUTO goes on at the nearest DO_LAND_START, as soon as it is found. False: there is none.
bool missionLand();
// The landing that is being flown is broken off: climbs straight on to the height above home, at
// least to one that is safe to turn at, then goes on at the nearest DO_LAND_START, or lands again.
// False: none is flown, or the airplane is down.
bool missionGoAround(float height_m);

void missionShiftHeights(float by_m);  // home is elsewhere: what is flown stays where it is

uint16_t missionSkipped();  // records passed over at run time since reset

MUST_USE core::Status missionItem(uint16_t index, MissionItem& to);  // busy, bad_argument, ok

// An upload: begin, items in order, commit. Until commit answers `accepted` the old mission is
// the mission. A part of the mission is replaced by the same three calls with `first` > 0 or
// `last` short of the end. One at a time.
MissionResult missionBeginUpload(uint16_t count);
MissionResult missionBeginPartial(uint16_t first, uint16_t last);  // both inclusive
MissionResult missionUploadItem(uint16_t index, const MissionItem& item);
MissionResult missionCommit();
void missionAbort();
MissionResult missionClear();  // until it is not busy

// Does at once what an action (DO command) of the APM 2.0 set does in a mission.
MissionResult missionAct(const MissionItem& item);

// An APM 1.0 command may switch off all that is sent on the telemetry ports, never on USB. A valid
// packet addressed to the airplane switches it on again.
bool telemetryMuted();
void radioHeard();

}  // namespace mission
}  // namespace firmware

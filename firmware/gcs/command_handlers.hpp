// SPDX-License-Identifier: GPL-3.0-or-later
// What the command table's rows point at: one function a command, each answers a MAV_RESULT.
// Grouped in commands_flight, _aux, _messages and _board.cpp.
#pragma once
#include "firmware/mission/mission.hpp"
#include "mavlink/messages.hpp"

namespace firmware {
namespace gcs {

struct Link;

// A command in one form, whichever message brought it; whoever carries it out may use it up.
struct CommandRequest {
    uint16_t command;
    mission::MissionItem item;  // x, y: parameters 5 and 6 as a place, z: parameter 7
    float param5, param6;       // as numbers
    uint8_t system, component;  // who gives it
    bool has_frame;             // it came as COMMAND_INT
};

constexpr int32_t kNoPlace = INT32_MAX;  // in x or y: none is given

// A parameter that should be a whole number; kNoNumber: is not, or is not one of 0..65534.
constexpr uint16_t kNoNumber = 0xFFFF;
uint16_t number(float param);
// Whether this link may force what is refused else; what it may not is reported to the pilot.
bool mayForce(const Link& link);

bool isGiven(float param);  // neither 0 nor NaN

uint8_t whenTrue(bool done, uint8_t otherwise);
bool acknowledge(Link& link, const CommandRequest& request, uint8_t result);

// ---- commands_flight.cpp
uint8_t setModeOf(uint8_t base_mode, uint32_t custom_mode);
uint8_t doSetMode(Link&, CommandRequest&);
uint8_t doSetStandardMode(Link&, CommandRequest&);
uint8_t loiterHere(Link&, CommandRequest&);
uint8_t returnToLaunch(Link&, CommandRequest&);
uint8_t startMission(Link&, CommandRequest&);
uint8_t setCurrentItem(Link&, CommandRequest&);
uint8_t reposition(Link&, CommandRequest&);
uint8_t changeAltitude(Link&, CommandRequest&);
uint8_t changeSpeedNow(Link&, CommandRequest&);
uint8_t guidedSpeed(Link&, CommandRequest&);
uint8_t guidedAltitude(Link&, CommandRequest&);
uint8_t guidedHeading(Link&, CommandRequest&);
uint8_t enableAutotune(Link&, CommandRequest&);
uint8_t takeOffNow(Link&, CommandRequest&);
uint8_t actNow(Link&, CommandRequest&);  // what a mission does at once
uint8_t enableFence(Link&, CommandRequest&);
uint8_t terminate(Link&, CommandRequest&);
uint8_t startLanding(Link&, CommandRequest&);
uint8_t goAround(Link&, CommandRequest&);
uint8_t armOrDisarm(Link&, CommandRequest&);
uint8_t runPrearmChecks(Link&, CommandRequest&);
uint8_t doSetHome(Link&, CommandRequest&);

// ---- commands_aux.cpp
uint8_t doAuxFunction(Link&, CommandRequest&);

// ---- commands_messages.cpp
uint8_t homePosition(Link&, CommandRequest&);
uint8_t requestMessage(Link&, CommandRequest&);
uint8_t setMessageInterval(Link&, CommandRequest&);
uint8_t getMessageInterval(Link&, CommandRequest&);
uint8_t autopilotVersion(Link&, CommandRequest&);
uint8_t protocolVersion(Link&, CommandRequest&);
uint8_t sendBanner(Link&, CommandRequest&);

// ---- commands_board.cpp
uint8_t calibrate(Link&, CommandRequest&);
uint8_t calibrateCompass(Link&, CommandRequest&);
uint8_t acceptCompass(Link&, CommandRequest&);
uint8_t cancelCalibration(Link&, CommandRequest&);
uint8_t sideIsReady(Link&, CommandRequest&);
uint8_t setSensorOffsets(Link&, CommandRequest&);
uint8_t resetStorage(Link&, CommandRequest&);
uint8_t reboot(Link&, CommandRequest&);

}  // namespace gcs
}  // namespace firmware

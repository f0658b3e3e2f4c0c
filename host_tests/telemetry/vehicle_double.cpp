// SPDX-License-Identifier: GPL-3.0-or-later
#include "vehicle_double.hpp"

#include <string.h>

#include "firmware/home.hpp"
#include "firmware/modes/guided.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/tasks.hpp"
#include "firmware/telemetry/text.hpp"
#include "firmware/vehicle.hpp"

namespace doubles {
Mission mission;
Vehicle vehicle;
void reset() {
    mission = Mission();
    vehicle = Vehicle();
}
namespace {
bool isBusy() {
    if (mission.busy == 0) return false;
    --mission.busy;
    return true;
}
}  // namespace
}  // namespace doubles

namespace firmware {

using doubles::isBusy;
using doubles::mission;

bool missionKnown() { return !isBusy(); }
bool radioSilenced() { return mission.radio_off; }
void radioHeard() { mission.radio_off = false; }

uint16_t missionCount() { return static_cast<uint16_t>(mission.items.size()); }
uint16_t missionCurrent() { return mission.current; }
bool missionSetCurrent(uint16_t index) {
    if (index >= mission.items.size()) return false;
    mission.current = index;
    return true;
}
bool takeReached(uint16_t& index) {
    if (mission.reached.empty()) return false;
    index = mission.reached.front();
    mission.reached.erase(mission.reached.begin());
    return true;
}
core::Status missionItem(uint16_t index, MissionItem& to) {
    if (isBusy()) return core::Status::busy;
    if (index >= mission.items.size()) return core::Status::bad_argument;
    to = mission.items[index];
    return core::Status::ok;
}
MissionResult missionBeginUpload(uint16_t count) {
    if (isBusy()) return MissionResult::busy;
    if (count > mission.room) return MissionResult::no_space;
    mission.staged.assign(count, MissionItem());
    mission.uploading = true;
    return MissionResult::accepted;
}
MissionResult missionBeginPartial(uint16_t first, uint16_t last) {
    if (isBusy()) return MissionResult::busy;
    if (first > last || last >= mission.items.size()) return MissionResult::invalid_sequence;
    mission.staged = mission.items;
    mission.uploading = true;
    return MissionResult::accepted;
}
MissionResult missionUploadItem(uint16_t index, const MissionItem& item) {
    if (isBusy()) return MissionResult::busy;
    if (mission.unsupported == item.command) return MissionResult::unsupported;
    mission.staged.at(index) = item;
    return MissionResult::accepted;
}
MissionResult missionCommit() {
    if (isBusy()) return MissionResult::busy;
    mission.items = mission.staged;
    mission.uploading = false;
    return MissionResult::accepted;
}
void missionAbort() {
    ++mission.aborts;
    mission.uploading = false;
}
MissionResult missionClear() {
    if (isBusy()) return MissionResult::busy;
    mission.items.clear();
    return MissionResult::accepted;
}

void missionRestart() { ++mission.restarts; }
MissionResult missionAct(const MissionItem& item) {
    mission.acts.push_back(item);
    return mission.answer;
}
MissionResult guideTo(MissionItem& item) {
    doubles::vehicle.targets.push_back(item);
    return mission.answer;
}
MissionResult guideToHeight(MissionItem& item) {
    doubles::vehicle.heights.push_back(item);
    return mission.answer;
}

bool isMode(uint8_t custom_mode) {
    return std::set<int>{0, 1, 2, 5, 10, 11, 12, 15}.count(custom_mode) != 0;
}
bool setMode(Mode mode, ModeReason reason) {
    doubles::vehicle.modes.emplace_back(mode, reason);
    if (doubles::vehicle.mode_can_be_entered) vehicle.mode = mode;
    return doubles::vehicle.mode_can_be_entered;
}
bool guidesItself() { return vehicle.mode >= Mode::automatic; }

bool arm(ArmReason, bool force) {
    doubles::vehicle.force = force;
    if (!doubles::vehicle.can_arm && !force) {
        tell(Severity::error, ROM_TEXT("PreArm: no GPS fix"));
        return false;
    }
    vehicle.armed = true;
    return true;
}
bool disarm(ArmReason, bool force) {
    doubles::vehicle.force = force;
    vehicle.armed = false;
    return true;
}
core::RomText prearmFailure() { return doubles::vehicle.can_arm ? nullptr : "PreArm: no GPS fix"; }
bool prearmOk() { return doubles::vehicle.can_arm; }

bool setHomeHere() {
    if (doubles::vehicle.home_can_be_set) doubles::vehicle.home = geo::Position{1, 1};
    return doubles::vehicle.home_can_be_set;
}
void setHome(const geo::Position& position, int32_t altitude_cm) {
    doubles::vehicle.home = position;
    doubles::vehicle.home_altitude_cm = altitude_cm;
}

void calibrateGyros() { ++doubles::vehicle.gyro_calibrations; }
void calibratePressures() { ++doubles::vehicle.pressure_calibrations; }

uint16_t loadPermille() { return 250; }
uint16_t lateFrames() { return 3; }
uint16_t longestFrame_us() { return 4321; }

}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
#include "vehicle_double.hpp"

#include <string.h>

#include "firmware/actuators/camera.hpp"
#include "firmware/actuators/outputs.hpp"
#include "firmware/gcs/host.hpp"
#include "firmware/mission/home.hpp"
#include "firmware/modes/guided.hpp"
#include "firmware/modes/mode_switch.hpp"
#include "firmware/modes/takeoff.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameter_host.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace doubles {
core::FileState<Mission> plan;
core::FileState<Vehicle> vehicle;
core::FileState<Lists> lists;

namespace {
bool isBusy() {
    if (plan.busy == 0) return false;
    --plan.busy;
    return true;
}
}  // namespace
}  // namespace doubles

namespace firmware {

using doubles::isBusy;
using doubles::plan;

namespace mission {
bool missionKnown() { return !isBusy(); }
bool telemetryMuted() { return plan.radio_off; }
void radioHeard() { plan.radio_off = false; }

uint16_t missionCount() { return static_cast<uint16_t>(plan.items.size()); }
uint16_t missionCurrent() { return plan.current; }
bool missionComplete() { return plan.complete; }
}  // namespace mission

namespace actuators {
uint16_t cameraTriggerCount() { return plan.triggers; }
bool isOutputFunction(int8_t) { return true; }
}  // namespace actuators

namespace mission {
bool missionSetCurrent(uint16_t index) {
    if (index >= plan.items.size()) return false;
    plan.current = index;
    return true;
}
bool takeReached(uint16_t& index) {
    if (plan.reached.empty()) return false;
    index = plan.reached.front();
    plan.reached.erase(plan.reached.begin());
    return true;
}
core::Status missionItem(uint16_t index, MissionItem& to) {
    if (isBusy()) return core::Status::busy;
    if (index >= plan.items.size()) return core::Status::bad_argument;
    to = plan.items[index];
    return core::Status::ok;
}
MissionResult missionBeginUpload(uint16_t count) {
    if (isBusy()) return MissionResult::busy;
    if (count > plan.room) return MissionResult::no_space;
    plan.staged.assign(count, MissionItem());
    plan.uploading = true;
    return MissionResult::accepted;
}
MissionResult missionBeginPartial(uint16_t first, uint16_t last) {
    if (isBusy()) return MissionResult::busy;
    if (first > last || last >= plan.items.size()) return MissionResult::invalid_sequence;
    plan.staged = plan.items;
    plan.uploading = true;
    return MissionResult::accepted;
}
MissionResult missionUploadItem(uint16_t index, const MissionItem& item) {
    if (isBusy()) return MissionResult::busy;
    if (plan.unsupported == item.command) return MissionResult::unsupported;
    plan.staged.at(index) = item;
    return MissionResult::accepted;
}
MissionResult missionCommit() {
    if (isBusy()) return MissionResult::busy;
    plan.items = plan.staged;
    plan.uploading = false;
    return MissionResult::accepted;
}
void missionAbort() {
    ++plan.aborts;
    doubles::lists.staging = false;
    plan.uploading = false;
}
MissionResult missionClear() {
    if (isBusy()) return MissionResult::busy;
    plan.items.clear();
    return MissionResult::accepted;
}

void missionRestart() { ++plan.restarts; }
bool missionLand() {
    ++plan.landings;
    return plan.land_start;
}
bool missionGoAround(float height_m) {
    plan.around_m.push_back(height_m);
    return plan.landing;
}
MissionResult missionAct(const MissionItem& item) {
    plan.acts.push_back(item);
    return plan.answer;
}
}  // namespace mission

namespace modes {
using namespace mission;

MissionResult guideTo(MissionItem& item) {
    doubles::vehicle.targets.push_back(item);
    return plan.answer;
}
MissionResult guideToHeight(MissionItem& item) {
    doubles::vehicle.heights.push_back(item);
    return plan.answer;
}
void resetModeSwitch() { ++doubles::vehicle.switch_resets; }
bool guideAlong(float course_rad) {
    doubles::vehicle.courses_rad.push_back(course_rad);
    return plan.answer == MissionResult::accepted;
}
MissionResult takeOff(MissionItem& item) {
    doubles::vehicle.takeoffs.push_back(item);
    return plan.answer;
}
}  // namespace modes

namespace mission {
using doubles::lists;

namespace {
constexpr uint8_t kCapacity[] = {171, 20, 10}, kRecordSize[] = {14, 10, 11};
const std::vector<doubles::Lists::Record>& records(ListKind kind) {
    return lists.now[static_cast<int>(kind)];
}
}  // namespace

uint8_t listCapacity(ListKind kind) { return kCapacity[static_cast<int>(kind)]; }
uint8_t listCount(ListKind kind) { return static_cast<uint8_t>(records(kind).size()); }
uint8_t listGeneration(ListKind kind) { return lists.generation[static_cast<int>(kind)]; }
uint32_t listId(ListKind kind) {
    return kind == ListKind::mission ? plan.id
                                     : 1000u * static_cast<uint32_t>(kind) + listCount(kind);
}
core::Status listRead(ListKind kind, uint8_t index, uint8_t* to) {
    if (isBusy()) return core::Status::busy;
    if (index >= records(kind).size()) return core::Status::bad_argument;
    memcpy(to, records(kind)[index].data(), records(kind)[index].size());
    return core::Status::ok;
}
MissionResult listBegin(ListKind kind, uint16_t count, uint8_t) {
    if (isBusy()) return MissionResult::busy;
    if (count > listCapacity(kind)) return MissionResult::no_space;
    lists.kind = kind;
    lists.count = static_cast<uint8_t>(count);
    lists.staged.clear();
    lists.staging = true;
    return MissionResult::accepted;
}
MissionResult listPut(const uint8_t* record) {
    if (isBusy() || lists.slow-- > 0) return MissionResult::busy;
    lists.staged.emplace_back(record, record + kRecordSize[static_cast<int>(lists.kind)]);
    return MissionResult::accepted;
}
MissionResult listCopy() { return listPut(records(lists.kind).at(lists.staged.size()).data()); }
uint8_t listStaged() { return static_cast<uint8_t>(lists.staged.size()); }
uint8_t listStagedCount() { return lists.count; }
bool listStaging(ListKind kind) { return lists.staging && lists.kind == kind; }
MissionResult listCommit() {
    if (isBusy()) return MissionResult::busy;
    if (lists.staged.size() != lists.count) return MissionResult::invalid_sequence;
    lists.now[static_cast<int>(lists.kind)] = lists.staged;
    ++lists.generation[static_cast<int>(lists.kind)];
    lists.staging = false;
    return MissionResult::accepted;
}
MissionResult listClear(ListKind kind, uint8_t set) {
    const MissionResult result = listBegin(kind, 0, set);
    return result == MissionResult::accepted ? listCommit() : result;
}
}  // namespace mission

namespace modes {
using namespace state;

bool requestMode(Mode mode, ModeReason reason) {
    doubles::vehicle.modes.emplace_back(mode, reason);
    if (doubles::vehicle.mode_can_be_entered) mutable_vehicle.mode = mode;
    return doubles::vehicle.mode_can_be_entered;
}
}  // namespace modes

namespace safety {
using namespace notify;
using namespace state;

bool arm(ArmReason, bool force) {
    doubles::vehicle.force = force;
    if (!doubles::vehicle.can_arm && !force) {
        sendStatusText(Severity::error, STATUS_TEXT("PreArm: no GPS fix"));
        return false;
    }
    mutable_vehicle.armed = true;
    return true;
}
bool disarm(ArmReason, bool force) {
    doubles::vehicle.force = force;
    mutable_vehicle.armed = false;
    return true;
}
bool terminateFlight() {
    mutable_vehicle.terminated = parameters.termination_action == 42;
    return vehicle.terminated;
}
bool reportPrearmFailure(Severity severity) {
    if (!doubles::vehicle.can_arm) sendStatusText(severity, STATUS_TEXT("PreArm: no GPS fix"));
    return !doubles::vehicle.can_arm;
}
}  // namespace safety

namespace mission {
bool setHomeHere() {
    if (doubles::vehicle.home_can_be_set) doubles::vehicle.home = geo::Position{1, 1};
    return doubles::vehicle.home_can_be_set;
}
void setHome(const geo::Position& position, int32_t altitude_cm) {
    doubles::vehicle.home = position;
    doubles::vehicle.home_altitude_cm = altitude_cm;
}
}  // namespace mission

namespace sensors {
using namespace state;

const drivers::GpsFix& gpsFix() { return doubles::vehicle.fix; }
uint16_t vibration_cmss(uint8_t axis) { return doubles::vehicle.vibration_cmss[axis]; }
uint8_t accelerometerClips() { return doubles::vehicle.clips; }
core::Vector3 restForce_mss() { return doubles::vehicle.rest_force_mss; }
bool wrongBoard() { return doubles::vehicle.wrong_board; }
void calibrateGyros() {
    ++doubles::vehicle.gyro_calibrations;
    mutable_vehicle.imu.calibrated = false;
}
void calibratePressures() { ++doubles::vehicle.pressure_calibrations; }
}  // namespace sensors

namespace state {
const ParameterHost parameter_host = {actuators::isOutputFunction};
}

namespace gcs {

const Host host = {[]() -> uint8_t { return 2; },
                   [](uint8_t task) -> TaskFigures {
                       if (task == 0) return {STATUS_TEXT("runInertial"), 823, 1050};
                       return {STATUS_TEXT("orthonormalizeMatrix"), 65535, 330};
                   }};

}  // namespace gcs
}  // namespace firmware

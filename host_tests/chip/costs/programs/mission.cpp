// SPDX-License-Identifier: GPL-3.0-or-later
// The whole firmware, and what its mission engine takes: an upload of 170 commands item by item,
// polls in which nothing ends, the advance from the first of them over 145 actions to the last,
// a step that sets a parameter and begins a NAV.
#include "firmware/mission/mission.hpp"
#include "board.hpp"
#include "firmware/app/tasks.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "steps.hpp"

namespace {

using namespace firmware;
using namespace firmware::state;
using namespace firmware::mission;
using namespace firmware::app;

constexpr uint8_t kItems = 148;
constexpr int32_t kLatitude_e7 = 473977000, kLongitude_e7 = 85456000;

MissionItem waypoint(uint8_t index) {
    return {16, 3, 0, 30, 0, 0, kLatitude_e7 + index * 10000L, kLongitude_e7, 60};
}
MissionItem longRow(uint8_t index, uint8_t count) {
    if (index < 2 || index + 1 == count) return waypoint(index);
    return {181, 2, 0, index % 2 == 0 ? 1.0f : 0.0f, 0, 0, 0, 0, 0};
}
MissionItem setsParameter(uint8_t index, uint8_t) {
    if (index != 2) return waypoint(index);
    return {180, 2, 134, 31.5f, 0, 0, 0, 0, 0};
}

void turns(uint16_t count) {
    while (count-- > 0) loop();
}

void upload(MissionItem (*item)(uint8_t, uint8_t), uint8_t count) {
    while (missionBeginUpload(count) == MissionResult::busy) turns(10);
    for (uint8_t i = 0; i < count;) {
        hal::trace(costs::kUploadItem);
        const MissionResult result = missionUploadItem(i, item(i, count));
        hal::trace(hal::kTraceTaskEnd);
        if (result == MissionResult::accepted) ++i;
        turns(2);
    }
    while (missionCommit() == MissionResult::busy) turns(10);
    turns(500);  // what the store does behind
}

// The firmware's own tasks rest: nothing but the engine moves.
void poll(uint8_t step, bool begins) {
    hal::trace(step);
    if (begins)
        missionRun();
    else
        missionCatchUp();
    hal::trace(hal::kTraceTaskEnd);
}

// From the NAV being flown to the next.
void advance(uint8_t step) {
    mutable_vehicle.demand.new_path = false;
    mutable_vehicle.progress.distance_m = 0;
    poll(step, true);
    while (mission_engine.midPass()) poll(step, mission_engine.starved());
    mutable_vehicle.demand.new_path = false;
    mutable_vehicle.progress.distance_m = 5000;
}

void fly() {
    firmware::notify::StatusText why_not;
    while (!missionEnter(why_not)) turns(10);
    do missionRun();
    while (mission_engine.midPass());
    mutable_vehicle.demand.new_path = false;
    mutable_vehicle.progress.distance_m = 5000;
    mutable_vehicle.progress.passed = false;
}

}  // namespace

int main() {
    setup();
    while (!missionReady()) turns(10);
    mutable_vehicle.home.position = {kLatitude_e7, kLongitude_e7};
    mutable_vehicle.home.set = true;
    upload(longRow, kItems);
    fly();
    for (uint8_t i = 0; i < 100; ++i) poll(costs::kIdlePoll, true);
    advance(costs::kAdvance);
    missionLeave();
    upload(setsParameter, 4);
    fly();
    advance(costs::kHeavyStep);
    hal::trace(costs::kNothing);
    hal::trace(hal::kTraceTaskEnd);
    for (;;) loop();
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that fly: modes, GUIDED, the mission, home, arming.
#include <math.h>

#include "core/based.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/gcs/available_modes.hpp"
#include "firmware/gcs/command_handlers.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/mission/home.hpp"
#include "firmware/mission/speed.hpp"
#include "firmware/modes/guided.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/modes/takeoff.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/safety/arming.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/safety/termination.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;
using namespace mission;
using namespace modes;
using namespace safety;

namespace {

using mavlink::MavFrame;
using mavlink::MavResult;

uint8_t enterMode(uint32_t custom_mode) {
    if (custom_mode > 0xFF || !isMode(static_cast<uint8_t>(custom_mode))) return MavResult::denied;
    return whenTrue(requestMode(static_cast<Mode>(custom_mode), ModeReason::ground),
                    MavResult::temporarily_rejected);
}

uint8_t enter(Mode mode) { return enterMode(static_cast<uint8_t>(mode)); }

// The base modes of before there were custom modes (MAV_MODE).
uint8_t enterBaseMode(uint8_t base_mode) {
    switch (base_mode & ~mavlink::MavModeFlag::safety_armed & 0xFF) {
        case 64:
            return enter(Mode::manual);
        case 80:
            return enter(Mode::fbwa);
        case 92:
            return enter(Mode::automatic);
        default:
            return MavResult::denied;
    }
}

uint8_t answer(MissionResult result) {
    struct Row {
        MissionResult result;
        uint8_t answer;
    };
    static constexpr Row kRows[] ROM = {
        {MissionResult::accepted, MavResult::accepted},
        {MissionResult::unsupported, MavResult::unsupported},
        {MissionResult::unsupported_frame, MavResult::command_unsupported_mav_frame},
        {MissionResult::error, MavResult::temporarily_rejected}};
    for (const Row& row : kRows)
        if (core::romRead(row.result) == result) return core::romRead(row.answer);
    return MavResult::denied;
}

bool followsGroundSpeed() {
    return vehicle.mode == Mode::automatic || vehicle.mode == Mode::guided;
}

}  // namespace

uint8_t setModeOf(uint8_t base_mode, uint32_t custom_mode) {
    if ((base_mode & mavlink::MavModeFlag::custom_mode_enabled) != 0) return enterMode(custom_mode);
    return enterBaseMode(base_mode);
}

uint8_t doSetMode(Link&, CommandRequest& request) {
    const uint16_t base_mode = number(request.item.param1);
    if (base_mode > 0xFF) return MavResult::denied;
    return setModeOf(static_cast<uint8_t>(base_mode), number(request.item.param2));
}

uint8_t doSetStandardMode(Link&, CommandRequest& request) {
    return enterMode(customModeOf(number(request.item.param1)));
}

uint8_t returnToLaunch(Link&, CommandRequest&) { return enter(Mode::rtl); }
uint8_t loiterHere(Link&, CommandRequest&) { return enter(Mode::loiter); }

uint8_t startMission(Link&, CommandRequest& request) {
    // a part of the mission cannot be flown alone
    if (isGiven(request.item.param1) || isGiven(request.item.param2)) return MavResult::denied;
    return enter(Mode::automatic);
}

uint8_t setCurrentItem(Link& link, CommandRequest& request) {
    const uint16_t index =
        request.item.param1 == -1 ? missionCurrent() : number(request.item.param1);
    if (index >= missionCount()) return MavResult::denied;
    if (number(request.item.param2) == 1) missionRestart();  // with the counts of its jumps
    if (!missionSetCurrent(index)) return MavResult::denied;
    requestOnce(link, mavlink::Wire<mavlink::MissionCurrent>::id);
    return MavResult::accepted;
}

// NaN, and INT32_MAX of a place, leave things as they are.
uint8_t reposition(Link&, CommandRequest& request) {
    constexpr uint8_t kChangeMode = 1;  // MAV_DO_REPOSITION_FLAGS
    constexpr float kFastest_mps = 200;
    const float speed_mps = request.item.param1;
    if (speed_mps > kFastest_mps) return MavResult::denied;
    if (vehicle.mode != Mode::guided && (number(request.item.param2) & kChangeMode) == 0)
        return MavResult::temporarily_rejected;
    request.item.command = mavlink::MavCmd::nav_waypoint;
    const MissionResult result = guideTo(request.item);
    if (result == MissionResult::accepted && speed_mps > 0)
        setGroundSpeed(core::inHundredths(speed_mps));
    return answer(result);
}

uint8_t changeAltitude(Link&, CommandRequest& request) {
    const uint16_t frame = number(request.item.param2);
    if (frame > 0xFF) return MavResult::denied;
    MissionItem& target = request.item;
    target.command = mavlink::MavCmd::nav_waypoint;
    target.frame = static_cast<uint8_t>(frame);
    target.z = target.param1;
    return answer(guideToHeight(target));
}

uint8_t actNow(Link&, CommandRequest& request) {
    request.item.frame = MavFrame::mission;  // none of them has a place
    return answer(missionAct(request.item));
}

uint8_t changeSpeedNow(Link& link, CommandRequest& request) {
    if (number(request.item.param1) == 1 && !followsGroundSpeed())
        return MavResult::temporarily_rejected;
    return actNow(link, request);
}

// The acceleration is not ours to choose.
uint8_t guidedSpeed(Link& link, CommandRequest& request) {
    if (vehicle.mode != Mode::guided) return MavResult::temporarily_rejected;
    request.item.command = mavlink::MavCmd::do_change_speed;
    request.item.param3 = -1;  // the throttle
    request.item.param4 = 0;
    return changeSpeedNow(link, request);
}

// Nor is the rate of climb.
uint8_t guidedAltitude(Link&, CommandRequest& request) {
    if (vehicle.mode != Mode::guided) return MavResult::temporarily_rejected;
    request.item.command = mavlink::MavCmd::nav_waypoint;
    return answer(guideToHeight(request.item));
}

// Of the course over the ground alone; the acceleration is ours to choose.
uint8_t guidedHeading(Link&, CommandRequest& request) {
    constexpr uint16_t kCourseOverGround = 0;  // HEADING_TYPE
    const float course_deg = request.item.param2;
    if (number(request.item.param1) != kCourseOverGround || !(course_deg >= 0 && course_deg <= 360))
        return MavResult::denied;
    return whenTrue(guideAlong(core::radians(course_deg)), MavResult::temporarily_rejected);
}

uint8_t enableAutotune(Link&, CommandRequest& request) {
    if (number(request.item.param1) == 1) return enter(Mode::autotune);
    if (vehicle.mode == Mode::autotune) return enter(Mode::fbwa);
    return MavResult::accepted;
}

// A COMMAND_LONG has no frame; ground stations give the height above home.
uint8_t takeOffNow(Link&, CommandRequest& request) {
    if (!request.has_frame) request.item.frame = MavFrame::global_relative_alt;
    return answer(takeOff(request.item));
}

uint8_t enableFence(Link&, CommandRequest& request) {
    return whenTrue(fenceEnable(number(request.item.param1)), MavResult::denied);
}

// Param 1 is 1; 0, which takes it back, comes too late.
uint8_t terminate(Link&, CommandRequest& request) {
    return whenTrue(number(request.item.param1) == 1 && terminateFlight(), MavResult::denied);
}

uint8_t startLanding(Link&, CommandRequest&) {
    if (!vehicle.estimate.flying) return MavResult::temporarily_rejected;
    return whenTrue(missionLand(), MavResult::denied);
}

uint8_t goAround(Link&, CommandRequest& request) {
    return whenTrue(missionGoAround(request.item.param1), MavResult::temporarily_rejected);
}

uint8_t armOrDisarm(Link& link, CommandRequest& request) {
    constexpr uint16_t kForceArm = 2989, kForceDisarm = 21196;  // as MAVLink documents them
    const uint16_t action = number(request.item.param1), magic = number(request.item.param2);
    const bool force = magic == kForceDisarm || (action == 1 && magic == kForceArm);
    if (force && !mayForce(link)) return MavResult::denied;
    switch (action) {
        case 0:
            return whenTrue(disarm(ArmReason::ground, force), MavResult::failed);
        case 1:
            return whenTrue(arm(ArmReason::ground, force), MavResult::failed);
        default:
            return MavResult::denied;
    }
}

uint8_t runPrearmChecks(Link&, CommandRequest&) {
    return whenTrue(!reportPrearmFailure(Severity::error), MavResult::failed);
}

// MAVLink leaves roll, pitch and yaw of the ground there to whoever has use for them.
uint8_t doSetHome(Link&, CommandRequest& request) {
    MissionItem& item = core::based(request.item);
    if (number(item.param1) == 1) return whenTrue(setHomeHere(), MavResult::temporarily_rejected);
    // 0, 0 is what a client sends that has no place to give
    if (item.x == 0 && item.y == 0) return MavResult::denied;
    if (item.frame == MavFrame::global_relative_alt ||
        item.frame == MavFrame::global_relative_alt_int) {
        if (!vehicle.home.set) return MavResult::temporarily_rejected;
        item.z += core::hundredths(vehicle.home.altitude_cm);
        item.frame = MavFrame::global;
    }
    return answer(missionAct(item));
}

}  // namespace gcs
}  // namespace firmware

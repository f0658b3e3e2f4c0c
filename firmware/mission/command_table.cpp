// SPDX-License-Identifier: GPL-3.0-or-later
// Every mission command of both sets: one row each, or one for both where they mean the same.
// Behind them those that neither set's document has, and ArduPlane's missions of this board do.
#include "firmware/mission/command_table.hpp"

#include "firmware/mission/handlers.hpp"
#include "firmware/mission/item.hpp"

namespace firmware {
namespace mission {

namespace {

using ::mission::action;
using ::mission::beyond;
using ::mission::condition;
using ::mission::jump;
using ::mission::nav;
using F = Form;
constexpr uint8_t none = ::mission::kNoId;
constexpr uint8_t kPlaced = ::mission::kPlaced;
constexpr uint8_t kEndsNowhere = ::mission::kEndsNowhere;
constexpr uint8_t kEndsFlight = ::mission::kEndsFlight;
constexpr uint8_t kTakeoff = ::mission::kEndsNowhere | ::mission::kBeginsFlight;

// Names are for people: no image of the board holds them.
struct Named {
    char name[20];
    ::mission::Row row;
};

// clang-format off
constexpr Named kNamed[] ROM = {
    // name               APM 1.0, 2.0           form          in range                start                finished
    {"WAYPOINT",            nav(      0x10, 0x10, F::waypoint,  placeInRange,           startWaypoint,       waypointDone,       kPlaced)},
    {"LOITER_UNLIM",        nav(      0x11, 0x11, F::unlimited, placeInRange,           startCircle,         never,              kPlaced)},
    {"LOITER_TURNS",        nav(      0x12, 0x12, F::turns,     placeInRange,           startCircle,         turnsDone,          kPlaced)},
    {"LOITER_TIME",         nav(      0x13, 0x13, F::time,      placeInRange,           startCircle,         timeDone,           kPlaced)},
    {"RETURN_TO_LAUNCH",    nav(      0x14, 0x14, F::place,     placeInRange,           startReturn,         returnDone,         0)},
    {"LAND",                nav(      0x15, 0x15, F::place,     placeInRange,           startLand,           landDone,           kPlaced | kEndsFlight)},
    {"TAKEOFF",             nav(      0x16, 0x16, F::takeoff,   takeoffInRange,         startTakeoff,        takeoffDone,        kTakeoff)},
    {"TARGET",              nav(      none, 0x17, F::waypoint,  placeInRange,           startWaypoint,       waypointDone,       kPlaced)},

    {"DELAY",               condition(0x20, none, F::none,      anything,               startDelay,          delayDoneP1)},
    {"DELAY",               condition(none, 0x70, F::seconds,   delayInRange,           startDelay,          delayDoneP3)},
    {"CHANGE_ALT",          condition(0x21, 0x71, F::climb,     changeAltitudeInRange,  startChangeAltitude, changeAltitudeDone)},
    {"DISTANCE",            condition(none, 0x72, F::seconds,   distanceInRange,        startDistance,       distanceDone)},

    {"JUMP",                jump(     none, 0xB1, F::jump,      jumpInRange,            jumpCounted)},
    {"CHANGE_SPEED",        action(   none, 0xB2, F::speed,     changeSpeedInRange,     changeSpeed)},
    {"SET_HOME",            action(   none, 0xB3, F::place_p1,    setHomeInRange,         setHomeAction)},
    {"SET_PARAMETER",       action(   none, 0xB4, F::parameter, setParameterInRange,    setParameterAction)},
    {"SET_RELAY",           action(   none, 0xB5, F::p1_p2,       setRelayInRange,        setRelay)},
    {"REPEAT_RELAY",        action(   none, 0xB6, F::p1_p2_p3,     repeatRelayInRange,     repeatRelay)},
    {"SET_SERVO",           action(   none, 0xB7, F::p1_p2,       setServoInRange,        setServo)},
    {"REPEAT_SERVO",        action(   none, 0xB8, F::repeat,    repeatServoInRange,     repeatServo)},

    {"CHANGE_MODE",         action(   0x30, none, F::none,      modeInRange,            changeMode)},
    {"RESET_INDEX",         jump(     0x31, none, F::none,      firstInRange,           jumpToFirst)},
    {"QUERY_VARIABLE",      action(   0x32, none, F::none,      variableInRange,        queryVariable)},
    {"BROADCAST_VARIABLE",  action(   0x33, none, F::none,      variableInRange,        broadcastVariable)},
    {"RADIO",               action(   0x34, none, F::none,      onOffInRange,           switchRadio)},
    {"CRUISE_AIRSPEED",     action(   0x40, none, F::none,      cruiseSpeedInRange,     cruiseSpeed)},
    {"CRUISE_THROTTLE",     action(   0x41, none, F::none,      cruiseThrottleInRange,  cruiseThrottle)},
    {"RESET_HOME",          action(   0x42, none, F::place_p1,    resetHomeInRange,       resetHome)},
    {"SET_KP",              action(   0x60, none, F::none,      gainInRange,            setGain)},
    {"SET_KI",              action(   0x61, none, F::none,      gainInRange,            setGain)},
    {"SET_KD",              action(   0x62, none, F::none,      gainInRange,            setGain)},
    {"SET_INTEGRATOR_MAX",  action(   0x63, none, F::none,      gainInRange,            setGain)},
    {"SET_KFF",             action(   0x64, none, F::none,      gainInRange,            setGain)},
    {"CHANNEL_TRIM",        action(   0x70, none, F::none,      channelInRange,         setChannel)},
    {"CHANNEL_MAX",         action(   0x71, none, F::none,      channelInRange,         setChannel)},
    {"CHANNEL_MIN",         action(   0x72, none, F::none,      channelInRange,         setChannel)},
    {"OTHER_RADIO",         action(   0x73, none, F::none,      otherRadioInRange,      setOtherRadio)},
    {"SET_INDEX",           jump(     0x75, none, F::none,      indexInRange,           jumpToIndex)},
    {"REPEAT_EVENT",        action(   0x80, none, F::none,      eventInRange,           repeatEvent)},
    {"SET_RELAY",           action(   0x81, none, F::none,      onOffInRange,           setRelayP1)},
    {"SET_SERVO",           action(   0x82, none, F::none,      pulseInRange,           setPulse)},

    {"CONTINUE_CHANGE_ALT", beyond(nav(      none, 0x1E, F::place_p1,    continueInRange,        startContinue,       continueDone,       kEndsNowhere))},
    {"LOITER_TO_ALT",       beyond(nav(      none, 0x1F, F::to_height, toHeightInRange,        startCircle,         toHeightDone,       kPlaced))},
    {"LAND_START",          beyond(action(   none, 0xBD, F::place,     placeInRange,           nothingToDo))},
    {"SET_ROI",             beyond(action(   none, 0xC9, F::place_p1,    interestInRange,        nothingToDo))},
    {"DIGICAM_CONTROL",     beyond(action(   none, 0xCB, F::p1_to_p4,      anything,               triggerCamera))},
    {"MOUNT_CONTROL",       beyond(action(   none, 0xCD, F::mount,     mountInRange,           nothingToDo))},
    {"SET_CAM_TRIGG_DIST",  beyond(action(   none, 0xCE, F::distance,  triggerDistanceInRange,    triggerByDistance))},
    {"FENCE_ENABLE",        beyond(action(   none, 0xCF, F::p1,       fenceInRange,           enableFence))},
    {"INVERTED_FLIGHT",     beyond(action(   none, 0xD2, F::p1,       onOffInRange,           flyInverted))},

    {"NAV_DELAY",           beyond(action(   none, 0x5D, F::seconds,   anything,               nothingToDo))},
    {"YAW",                 beyond(condition(none, 0x73, F::mount,     anything,               nothingToDo,         done))},
    {"GO_AROUND",           beyond(action(   none, 0xBF, F::seconds,   anything,               nothingToDo))},
    {"SET_ROI_LOCATION",    beyond(action(   none, 0xC3, F::place,     placeInRange,           nothingToDo))},
    {"SET_ROI_NONE",        beyond(action(   none, 0xC5, F::none,      anything,               nothingToDo))},
    {"AUTOTUNE_ENABLE",     beyond(action(   none, 0xD4, F::p1,       onOffInRange,           nothingToDo))},
    {"SET_CAMERA_MODE",     beyond(action(   none, 0xF0, F::p1_p2,       anything,               nothingToDo))},
    {"IMAGE_START_CAPTURE", beyond(action(   none, 0xF1, F::p1_p2_p3,     oneImageInRange,      triggerCamera))},
    {"IMAGE_STOP_CAPTURE",  beyond(action(   none, 0xF2, F::p1,       anything,               nothingToDo))},
    {"CAM_TRIGG_INTERVAL",  beyond(action(   none, 0xD6, F::seconds,   anything,               nothingToDo))},
    {"JUMP_TAG",            beyond(action(   none, 0xF3, F::seconds,   anything,               nothingToDo))},
    {"VIDEO_START_CAPTURE", beyond(action(   none, 0xF4, F::p1_p2,       anything,               nothingToDo))},
    {"VIDEO_STOP_CAPTURE",  beyond(action(   none, 0xF5, F::p1,       anything,               nothingToDo))},
};
// clang-format on

constexpr uint8_t kCount = core::count(kNamed);
struct Rows {
    ::mission::Row row[kCount];
};
constexpr Rows withoutNames() {
    Rows rows{};
    for (uint8_t i = 0; i < kCount; ++i) rows.row[i] = kNamed[i].row;
    return rows;
}
constexpr Rows kRows ROM = withoutNames();

static_assert(::mission::idsAreUnique(kRows.row), "two rows of a set answer to the same id");
static_assert(::mission::traitsMakeSense(kRows.row),
              "a row has a trait that its class cannot have");
static_assert(::mission::idsIn(kRows.row, ::mission::Set::apm1, 0) == kApm1Commands,
              "APM 1.0: a row is missing");
static_assert(::mission::idsIn(kRows.row, ::mission::Set::apm2, 0) == kApm2Commands,
              "APM 2.0: a row is missing");
static_assert(::mission::idsIn(kRows.row, ::mission::Set::apm2, ::mission::kArduPlaneExtension) ==
                      kArduPlaneExtensionCommands &&
                  ::mission::idsIn(kRows.row, ::mission::Set::apm1,
                                   ::mission::kArduPlaneExtension) == 0,
              "beyond the documents: a row is missing");

}  // namespace

const ::mission::Table kCommandTable = {kRows.row, kCount};

const char* commandName(uint8_t row) { return kNamed[row].name; }

}  // namespace mission
}  // namespace firmware

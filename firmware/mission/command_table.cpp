// SPDX-License-Identifier: GPL-3.0-or-later
// Every mission command of both sets: one row each, or one for both where they mean the same.
#include "firmware/mission/command_table.hpp"

#include "firmware/mission/handlers.hpp"
#include "firmware/mission/item.hpp"

namespace firmware {
namespace {

using mission::action;
using mission::condition;
using mission::jump;
using mission::nav;
using F = Form;
constexpr uint8_t none = mission::kNoId;
constexpr uint8_t kPlaced = mission::kPlaced;
constexpr uint8_t kEndsFlight = mission::kEndsFlight;
constexpr uint8_t kTakeoff = mission::kEndsNowhere | mission::kBeginsFlight;

// clang-format off
constexpr mission::Row kRows[] ROM = {
    //        APM 1.0 APM 2.0 name                  form         in range               start           finished
    nav(      0x10,   0x10, "WAYPOINT",             F::waypoint,   placeInRange,          startWaypoint,  waypointDone,  kPlaced),
    nav(      0x11,   0x11, "LOITER_UNLIM",         F::unlimited,  placeInRange,          startCircle,    never,         kPlaced),
    nav(      0x12,   0x12, "LOITER_TURNS",         F::turns,      placeInRange,          startCircle,    turnsDone,     kPlaced),
    nav(      0x13,   0x13, "LOITER_TIME",          F::time,       placeInRange,          startCircle,    timeDone,      kPlaced),
    nav(      0x14,   0x14, "RETURN_TO_LAUNCH",     F::place,      placeInRange,          startReturn,    returnDone,    0),
    nav(      0x15,   0x15, "LAND",                 F::place,      placeInRange,          startLand,      landDone,      kPlaced | kEndsFlight),
    nav(      0x16,   0x16, "TAKEOFF",              F::takeoff,    takeoffInRange,        startTakeoff,   takeoffDone,   kTakeoff),
    nav(      none,   0x17, "TARGET",               F::waypoint,   placeInRange,          startWaypoint,  waypointDone,  kPlaced),

    condition(0x20,   none, "DELAY",                F::none,       anything,              startDelay,          delayDoneP1),
    condition(none,   0x70, "DELAY",                F::seconds,    delayInRange,          startDelay,          delayDoneP3),
    condition(0x21,   0x71, "CHANGE_ALT",           F::climb,      changeAltitudeInRange, startChangeAltitude, changeAltitudeDone),
    condition(none,   0x72, "DISTANCE",             F::seconds,    distanceInRange,       startDistance,       distanceDone),

    jump(     none,   0xB1, "JUMP",                 F::jump,       jumpInRange,           jumpCounted),
    action(   none,   0xB2, "CHANGE_SPEED",         F::speed,      changeSpeedInRange,    changeSpeed),
    action(   none,   0xB3, "SET_HOME",             F::home,       setHomeInRange,        setHomeAction),
    action(   none,   0xB4, "SET_PARAMETER",        F::parameter,  setParameterInRange,   setParameterAction),
    action(   none,   0xB5, "SET_RELAY",            F::two,        setRelayInRange,       setRelay),
    action(   none,   0xB6, "REPEAT_RELAY",         F::three,      repeatRelayInRange,    repeatRelay),
    action(   none,   0xB7, "SET_SERVO",            F::two,        setServoInRange,       setServo),
    action(   none,   0xB8, "REPEAT_SERVO",         F::repeat,     repeatServoInRange,    repeatServo),

    action(   0x30,   none, "CHANGE_MODE",          F::none,       modeInRange,           changeMode),
    jump(     0x31,   none, "RESET_INDEX",          F::none,       firstInRange,          jumpToFirst),
    action(   0x32,   none, "QUERY_VARIABLE",       F::none,       variableInRange,       queryVariable),
    action(   0x33,   none, "BROADCAST_VARIABLE",   F::none,       variableInRange,       broadcastVariable),
    action(   0x34,   none, "RADIO",                F::none,       onOffInRange,          switchRadio),
    action(   0x40,   none, "CRUISE_AIRSPEED",      F::none,       cruiseSpeedInRange,    cruiseSpeed),
    action(   0x41,   none, "CRUISE_THROTTLE",      F::none,       cruiseThrottleInRange, cruiseThrottle),
    action(   0x42,   none, "RESET_HOME",           F::home,       resetHomeInRange,      resetHome),
    action(   0x60,   none, "SET_KP",               F::none,       gainInRange,           setGain),
    action(   0x61,   none, "SET_KI",               F::none,       gainInRange,           setGain),
    action(   0x62,   none, "SET_KD",               F::none,       gainInRange,           setGain),
    action(   0x63,   none, "SET_INTEGRATOR_MAX",   F::none,       gainInRange,           setGain),
    action(   0x64,   none, "SET_KFF",              F::none,       gainInRange,           setGain),
    action(   0x70,   none, "CHANNEL_TRIM",         F::none,       channelInRange,        setChannel),
    action(   0x71,   none, "CHANNEL_MAX",          F::none,       channelInRange,        setChannel),
    action(   0x72,   none, "CHANNEL_MIN",          F::none,       channelInRange,        setChannel),
    action(   0x73,   none, "OTHER_RADIO",          F::none,       otherRadioInRange,     setOtherRadio),
    jump(     0x75,   none, "SET_INDEX",            F::none,       indexInRange,          jumpToIndex),
    action(   0x80,   none, "REPEAT_EVENT",         F::none,       eventInRange,          repeatEvent),
    action(   0x81,   none, "SET_RELAY",            F::none,       onOffInRange,          setRelayP1),
    action(   0x82,   none, "SET_SERVO",            F::none,       pulseInRange,          setPulse),
};
// clang-format on

static_assert(mission::idsAreUnique(kRows), "two rows of a set answer to the same id");
static_assert(mission::traitsMakeSense(kRows), "a row has a trait that its class cannot have");
static_assert(mission::idsIn(kRows, mission::Set::apm1) == kApm1Commands,
              "APM 1.0: a row is missing");
static_assert(mission::idsIn(kRows, mission::Set::apm2) == kApm2Commands,
              "APM 2.0: a row is missing");

}  // namespace

const mission::Table kCommandTable = {kRows, static_cast<uint8_t>(core::count(kRows))};

}  // namespace firmware

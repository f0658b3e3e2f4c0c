// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/failsafe_table.hpp"

#include "firmware/safety/failsafe_causes.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace safety {

using namespace notify;
using namespace state;

namespace {

constexpr int8_t kGlides = 2;  // FS_SHORT_ACTN, FS_LONG_ACTN

bool always() { return true; }
bool homeKnown() { return vehicle.home.set && vehicle.estimate.known; }
bool fenceActs() { return fenceTurnsBack() && vehicle.estimate.known; }

bool longGlides() { return parameters.long_action == kGlides; }
bool longReturns() { return parameters.long_action == 1; }
bool homeIfLongReturns() { return longReturns() && homeKnown(); }
// CIRCLE by the short one is not for ever.
bool homeIfShortActed() { return parameters.short_action != 0 && homeKnown(); }

bool shortGlides() { return parameters.short_action == kGlides; }
bool shortCircles() { return parameters.short_action == 1; }

constexpr uint16_t kInertial = bitOf(Cause::inertial), kFence = bitOf(Cause::fence),
                   kBattery = bitOf(Cause::battery), kBlownBack = bitOf(Cause::blown_back),
                   kRadio = bitOf(Cause::radio_long), kGround = bitOf(Cause::ground_long),
                   kShort = bitOf(Cause::radio_short), kNowhere = bitOf(Cause::no_position);

}  // namespace

// clang-format off
const Transition kTransitions[kTransitionCount] ROM = {
    // causes          flown                            guard              action             after
    {kInertial,        kWhatever,                       always,            Action::sticks,    After::back},
    {kFence,           kWhatever,                       fenceActs,         Action::turn_back, After::stay},
    {kBattery,         by_pilot | by_itself | circling, homeKnown,         Action::go_home,   After::stay},
    {kBlownBack,       by_itself,                       homeKnown,         Action::go_home,   After::stay},
    {kRadio | kGround, by_pilot | by_itself | circling, longGlides,        Action::glide,     After::stay},
    {kRadio | kGround, by_pilot | circling,             homeKnown,         Action::go_home,   After::stay},
    {kRadio | kGround, by_itself,                       homeIfLongReturns, Action::go_home,   After::stay},
    {kRadio,           by_itself,                       homeIfShortActed,  Action::go_home,   After::stay},
    {kRadio | kGround, by_pilot,                        always,            Action::circle,    After::back},
    {kRadio | kGround, by_itself,                       longReturns,       Action::circle,    After::back},
    {kShort,           by_pilot | by_itself,            shortGlides,       Action::glide,     After::back},
    {kShort,           by_pilot,                        always,            Action::circle,    After::back},
    {kShort,           by_itself,                       shortCircles,      Action::circle,    After::back},
    {kNowhere,         by_itself | returning,           always,            Action::circle,    After::back},
};

// ERR's subsystems as ArduCopter counts them: 3 compass, 5 radio, 6 battery, 7 failsafe GPS, 8 ground
// station, 9 fence, 11 GPS (2: glitch), 18 barometer, 22 navigation, 26 sensors.
constexpr CauseRow kCauseTable[kCauses] ROM = {
    // holds          severity            ERR    begins                           ends
    {inertialLost,   Severity::emergency, 26, 1, "Inertial sensor lost",          "Inertial back"},
    {fenceBroken,    Severity::critical,   9, 1, "",                              ""},
    {batteryLow,     Severity::critical,   6, 1, "Battery low",                   ""},
    {blownBack,      Severity::critical,  22, 1, "Headwind too strong",           ""},
    {radioLostLong,  Severity::critical,   5, 2, "Radio lost: long failsafe",     ""},
    {groundLostLong, Severity::critical,   8, 1, "Ground station lost: failsafe", "Ground station back"},
    {radioLost,      Severity::warning,    5, 1, "Radio lost: short failsafe",    "Radio back"},
    {positionLost,   Severity::critical,   7, 1, "Position lost",                 ""             },
    {heightLost,     Severity::critical,  18, 2, "Height lost: held by throttle", ""           },
    {gpsLost,        Severity::error,     11, 1, "GPS lost: dead reckoning",      "GPS back"},
    {gpsJumps,       Severity::warning,   11, 2, "GPS jump refused",              ""},
    {barometerLost,  Severity::error,     18, 1, "Barometer lost",                "Barometer back"},
    {airspeedLost,   Severity::error,     26, 2, "Airspeed lost",                 "Airspeed back"},
    {compassLost,    Severity::error,      3, 1, "Compass lost",                  "Compass back"},
};
// clang-format on

uint8_t resolve(uint16_t causes, uint8_t flown) {
    for (uint8_t i = 0; i < kTransitionCount; ++i) {
        const Transition& row = kTransitions[i];
        if ((core::romRead(row.causes) & causes) != 0 && (core::romRead(row.flown) & flown) != 0 &&
            core::romRead(row.guard)())
            return i;
    }
    return kNoTransition;
}

}  // namespace safety
}  // namespace firmware

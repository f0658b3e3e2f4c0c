// SPDX-License-Identifier: GPL-3.0-or-later
// What the fields of each command mean, in words, for docs/mission.md. Numbers are not here: the
// manual's ranges and links are asked of the code.
#pragma once
#include "samples.hpp"

namespace firmware {

struct Meaning {
    ::mission::Set set;
    uint8_t id;
    const char* field[4];  // p1 .. p4; nullptr: not used
    const char* does;
};

// clang-format off
constexpr char kAltitude_[] = "altitude, cm", kLatitude_[] = "latitude", kLongitude_[] = "longitude";
constexpr char kRadius_[] = "acceptance radius, m; 0: `WP_RADIUS`";
constexpr char kPassed[] = "finishes within the radius, or past the line through it across the leg";
constexpr char kEndless[] = "never finishes";
constexpr char kTicks[] = "finishes after that many circles from capture; 0: on capture";
constexpr char kTime[] = "finishes after that time from capture; 0: on capture";
constexpr char kHome[] = "finishes on arrival at home, or at the rally point that is better; that has an altitude of its own, for 0";
constexpr char kDown[] = "finishes when down and disarmed; disarms itself `LAND_DISARMDELAY` seconds after touching down";
constexpr char kUp[] = "finishes within 1 m of the altitude";
constexpr char kWaits[] = "finishes after that time";
constexpr char kClimbs[] = "finishes within 2 m of the altitude, or past it. The demanded height starts at the airplane's and moves at the rate; it stays until the next NAV";
constexpr char kCycles[] = "half of each cycle at the value, half at what was read; replaces what repeats";
constexpr Meaning kMeanings[] = {
    {kSet2, 0x10, {kRadius_, kAltitude_, kLatitude_, kLongitude_}, kPassed},
    {kSet2, 0x11, {nullptr, kAltitude_, kLatitude_, kLongitude_}, kEndless},
    {kSet2, 0x12, {"turns", kAltitude_, kLatitude_, kLongitude_}, kTicks},
    {kSet2, 0x13, {"tens of seconds", kAltitude_, kLatitude_, kLongitude_}, kTime},
    {kSet2, 0x14, {nullptr, "altitude, cm; 0: `ALT_HOLD_RTL`", "latitude, not used", "longitude, not used"}, kHome},
    {kSet2, 0x15, {nullptr, kAltitude_, kLatitude_, kLongitude_}, kDown},
    {kSet2, 0x16, {"pitch, degrees", kAltitude_, nullptr, nullptr}, kUp},
    {kSet2, 0x17, {kRadius_, kAltitude_, kLatitude_, kLongitude_}, kPassed},
    {kSet2, 0x70, {nullptr, nullptr, "seconds", nullptr}, kWaits},
    {kSet2, 0x71, {"rate, cm/s, at most 255", kAltitude_, "exact rate, cm/s; 0: as p1", nullptr}, kClimbs},
    {kSet2, 0x72, {nullptr, nullptr, "metres", nullptr}, "finishes nearer than that to the NAV's place"},
    {kSet2, 0xB1, {"item", nullptr, "repeats; -1: for ever", nullptr}, "at most 15 jumps of a mission may have a count"},
    {kSet2, 0xB2, {"0 air speed, 1 ground speed (to 200 m/s)", "speed, m/s, within `ARSPD_FBW_MIN` and `_MAX`; -1: no change", "throttle, %; -1: no change", "exact speed, cm/s; 0: as p2"}, "until the mission restarts or ends"},
    {kSet2, 0xB3, {"1 here, 0 the place", "altitude above the sea, cm", kLatitude_, kLongitude_}, "moves home"},
    {kSet2, 0xB4, {"slot of the parameter", "value, rounded", "exact value (IEEE-754); 0: as p2", nullptr}, "as PARAM_SET"},
    {kSet2, 0xB5, {"relay", "on", nullptr, nullptr}, "switches it"},
    {kSet2, 0xB6, {"relay", "cycles", "seconds a cycle", nullptr}, "inverts it for half of each cycle; replaces what repeats"},
    {kSet2, 0xB7, {"output", "pulse, us; 1: the channel's maximum, 0: its minimum", nullptr, nullptr}, "held until the mode changes"},
    {kSet2, 0xB8, {"output", "cycles", "seconds a cycle", "pulse, us; 0: the channel's maximum"}, kCycles},
    {kSet2, 0x1E, {"0 either way, 1 climb, 2 descend", kAltitude_, "latitude, not used", "longitude, not used"}, "straight on over the ground; finishes within 5 m of the altitude; with p1 1 or 2 at it (within 1 m) or past it"},
    {kSet2, 0x1F, {"1: leaves on the next leg's course", kAltitude_, kLatitude_, kLongitude_}, "finishes on the circle within 5 m of the altitude; with p1 1 when the course is then within 10 degrees of the one from the circle's centre to the next NAV as they are stored"},
    {kSet2, 0xBD, {nullptr, kAltitude_, "latitude", "longitude"}, "marks where a landing begins, for `RTL_AUTOLAND` and the ground's DO_LAND_START; 0, 0: where the next NAV lies"},
    {kSet2, 0xC9, {"MAV_ROI", kAltitude_, kLatitude_, kLongitude_}, "stored; a text reports at the upload: there is no mount"},
    {kSet2, 0xCB, {"session", "zoom", "zoom step", "focus lock"}, "takes a picture, whatever the numbers are"},
    {kSet2, 0xCD, {"MAV_MOUNT_MODE", "pitch, degrees", "roll, degrees", "yaw, degrees"}, "stored; a text reports at the upload: there is no mount"},
    {kSet2, 0xCE, {nullptr, "metres, rounded", "exact, cm; 0: as p2", nullptr}, "takes a picture whenever so much is flown over the ground; 0 ends that, and so do disarming and a restart of the mission"},
    {kSet2, 0xCF, {"0 off, 1 on, 2 the floor off", nullptr, nullptr, nullptr}, "switches the fence"},
    {kSet2, 0xD2, {"1 inverted, 0 upright", nullptr, nullptr, nullptr}, "upside down until 0 or a change of mode; above 30 m, and upright below 15 m and in take-off and landing"},
    {kSet1, 0x10, {kRadius_, kAltitude_, kLatitude_, kLongitude_}, kPassed},
    {kSet1, 0x11, {nullptr, kAltitude_, kLatitude_, kLongitude_}, kEndless},
    {kSet1, 0x12, {"turns", kAltitude_, kLatitude_, kLongitude_}, kTicks},
    {kSet1, 0x13, {"tens of seconds", kAltitude_, kLatitude_, kLongitude_}, kTime},
    {kSet1, 0x14, {nullptr, "altitude, cm; 0: `ALT_HOLD_RTL`", "latitude, not used", "longitude, not used"}, kHome},
    {kSet1, 0x15, {nullptr, kAltitude_, kLatitude_, kLongitude_}, kDown},
    {kSet1, 0x16, {"pitch, degrees", kAltitude_, nullptr, nullptr}, kUp},
    {kSet1, 0x20, {"seconds", nullptr, nullptr, nullptr}, kWaits},
    {kSet1, 0x21, {"rate, cm/s", kAltitude_, "exact rate, cm/s; 0: as p1", nullptr}, kClimbs},
    {kSet1, 0x30, {"number of the mode", nullptr, nullptr, nullptr}, "changes the mode; AUTO does nothing"},
    {kSet1, 0x31, {nullptr, nullptr, nullptr, nullptr}, "goes on at item 1; cannot be item 1"},
    {kSet1, 0x32, {"slot of the parameter", nullptr, nullptr, nullptr}, "sends it to the ground, on every link"},
    {kSet1, 0x33, {"slot of the parameter", nullptr, nullptr, nullptr}, "sends it on every link and writes it to the log"},
    {kSet1, 0x34, {"0 off, 1 on", nullptr, nullptr, nullptr}, "silences the telemetry ports, never USB, until it is on again or the airplane is spoken to"},
    {kSet1, 0x40, {"m/s, within `ARSPD_FBW_MIN` and `_MAX`", nullptr, nullptr, nullptr}, "until the mission restarts or ends"},
    {kSet1, 0x41, {"%", nullptr, nullptr, nullptr}, "until the mission restarts or ends"},
    {kSet1, 0x42, {nullptr, "altitude above the sea, cm", kLatitude_, kLongitude_}, "moves home; all zero: here"},
    {kSet1, 0x60, {"index", "value × 100,000", nullptr, nullptr}, "sets the parameter below"},
    {kSet1, 0x61, {"index", "value × 100,000", nullptr, nullptr}, "sets the parameter below"},
    {kSet1, 0x62, {"index", "value × 100,000", nullptr, nullptr}, "sets the parameter below"},
    {kSet1, 0x63, {"index", "value × 100,000", nullptr, nullptr}, "sets the parameter below"},
    {kSet1, 0x64, {"index", "value × 100,000", nullptr, nullptr}, "sets the parameter below"},
    {kSet1, 0x70, {"channel less 1", "us", nullptr, nullptr}, "sets `RCn_TRIM`"},
    {kSet1, 0x71, {"channel less 1", "us", nullptr, nullptr}, "sets `RCn_MAX`"},
    {kSet1, 0x72, {"channel less 1", "us", nullptr, nullptr}, "sets `RCn_MIN`"},
    {kSet1, 0x73, {"2: throttle failsafe (0, 1: elevon trims, refused)", "us", nullptr, nullptr}, "sets `THR_FS_VALUE`"},
    {kSet1, 0x75, {"item, where p2 is 0", "item", nullptr, nullptr}, "goes on there"},
    {kSet1, 0x80, {"1 to 5: output 4 to 8, 6: relay; 0 or 10 stops", "pulse, us", "seconds, under 2 counts as 2", "times; 0: for ever"}, "at the value for a second, then back to what was read; replaces what repeats"},
    {kSet1, 0x81, {"on", nullptr, nullptr, nullptr}, "switches it"},
    {kSet1, 0x82, {"output less 1", "pulse, us; 0: none, under 800 counts as 800", nullptr, nullptr}, "held until the mode changes"},
};
// clang-format on

inline const Meaning* meaningOf(::mission::Set set, uint8_t id) {
    for (const Meaning& meaning : kMeanings)
        if (meaning.set == set && meaning.id == id) return &meaning;
    return nullptr;
}

}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// A good record of every command of both sets, what its fields mean in words, and what its row
// takes instead: the ranges as they are found by asking the row itself.
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "firmware/mission/command_table.hpp"

namespace firmware {
using namespace mission;

constexpr ::mission::ItemPosition kSamplePosition = {5, 20};  // item 5 of 20

struct Sample {
    ::mission::Set set;
    ::mission::Record record;
    const char* field[4];  // what p1 .. p4 mean, for docs/mission.md; nullptr: not used
    const char* does;
};

// clang-format off
constexpr ::mission::Set kSet1 = ::mission::Set::apm1, kSet2 = ::mission::Set::apm2;
constexpr int32_t kNorth = 470900000, kEast = 80264000;
constexpr char kAltitude_[] = "altitude, cm", kLatitude_[] = "latitude", kLongitude_[] = "longitude";
constexpr char kRadius_[] = "acceptance radius, m; 0: `WP_RADIUS` or, where that is more, what the turn to the next NAV needs";
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
constexpr char kIdle[] = "stored, has no effect; a text reports at the upload how many there are";
constexpr Sample kSamples[] = {
    {kSet2, {0x10, 1, 25, 12345, kNorth, kEast}, {kRadius_, kAltitude_, kLatitude_, kLongitude_}, kPassed},
    {kSet2, {0x11, 1, 0, 12345, kNorth, kEast}, {nullptr, kAltitude_, kLatitude_, kLongitude_}, kEndless},
    {kSet2, {0x12, 1, 3, 12345, kNorth, kEast}, {"turns", kAltitude_, kLatitude_, kLongitude_}, kTicks},
    {kSet2, {0x13, 1, 12, 12345, kNorth, kEast}, {"tens of seconds", kAltitude_, kLatitude_, kLongitude_}, kTime},
    {kSet2, {0x14, 1, 0, 12345, kNorth, kEast}, {nullptr, "altitude, cm; 0: `ALT_HOLD_RTL`", "latitude, not used", "longitude, not used"}, kHome},
    {kSet2, {0x15, 1, 0, 12345, kNorth, kEast}, {nullptr, kAltitude_, kLatitude_, kLongitude_}, kDown},
    {kSet2, {0x16, 1, 15, 4000, 0, 0}, {"pitch, degrees", kAltitude_, nullptr, nullptr}, kUp},
    {kSet2, {0x17, 1, 7, 12345, kNorth, kEast}, {kRadius_, kAltitude_, kLatitude_, kLongitude_}, kPassed},
    {kSet2, {0x70, 0, 0, 0, 90, 0}, {nullptr, nullptr, "seconds", nullptr}, kWaits},
    {kSet2, {0x71, 1, 200, 8000, 0, 0}, {"rate, cm/s, at most 255", kAltitude_, "exact rate, cm/s; 0: as p1", nullptr}, kClimbs},
    {kSet2, {0x72, 0, 0, 0, 300, 0}, {nullptr, nullptr, "metres", nullptr}, "finishes nearer than that to the NAV's place"},
    {kSet2, {0xB1, 0, 2, 0, 5, 0}, {"item", nullptr, "repeats; -1: for ever", nullptr}, "at most 15 jumps of a mission may have a count"},
    {kSet2, {0xB2, 0, 0, 14, 60, 0}, {"0 air speed, 1 ground speed (to 200 m/s)", "speed, m/s, within `ARSPD_FBW_MIN` and `_MAX`; -1: no change", "throttle, %; -1: no change", "exact speed, cm/s; 0: as p2"}, "until the mission restarts or ends"},
    {kSet2, {0xB3, 0, 0, 50000, kNorth, kEast}, {"1 here, 0 the place", "altitude above the sea, cm", kLatitude_, kLongitude_}, "moves home"},
    {kSet2, {0xB4, 0, 134, 45, 0, 0}, {"slot of the parameter", "value, rounded", "exact value (IEEE-754); 0: as p2", nullptr}, "as PARAM_SET"},
    {kSet2, {0xB5, 0, 0, 1, 0, 0}, {"relay", "on", nullptr, nullptr}, "switches it"},
    {kSet2, {0xB6, 0, 0, 10, 4, 0}, {"relay", "cycles", "seconds a cycle", nullptr}, "inverts it for half of each cycle; replaces what repeats"},
    {kSet2, {0xB7, 0, 6, 1700, 0, 0}, {"output", "pulse, us; 1: the channel's maximum, 0: its minimum", nullptr, nullptr}, "held until the mode changes"},
    {kSet2, {0xB8, 0, 7, 3, 2, 1900}, {"output", "cycles", "seconds a cycle", "pulse, us; 0: the channel's maximum"}, kCycles},
    {kSet2, {0x1E, 1, 2, 12345, kNorth, kEast}, {"0 either way, 1 climb, 2 descend", kAltitude_, "latitude, not used", "longitude, not used"}, "straight on over the ground; finishes within 5 m of the altitude; with p1 1 or 2 at it (within 1 m) or past it"},
    {kSet2, {0x1F, 5, 1, 12345, kNorth, kEast}, {"1: leaves on the next leg's course", kAltitude_, kLatitude_, kLongitude_}, "finishes on the circle within 5 m of the altitude; with p1 1 when the course is then within 10 degrees of the one from the circle's centre to the next NAV as they are stored"},
    {kSet2, {0xBD, 1, 0, 12345, kNorth, kEast}, {nullptr, kAltitude_, "latitude", "longitude"}, "marks where a landing begins, for `RTL_AUTOLAND` and the ground's DO_LAND_START; 0, 0: where the next NAV lies"},
    {kSet2, {0xC9, 1, 3, 12345, kNorth, kEast}, {"MAV_ROI", kAltitude_, kLatitude_, kLongitude_}, kIdle},
    {kSet2, {0xCB, 0, 1, 2, -3, 4}, {"session", "zoom", "zoom step", "focus lock"}, "takes a picture, whatever the numbers are"},
    {kSet2, {0xCD, 0, 2, -45, 10, 180}, {"MAV_MOUNT_MODE", "pitch, degrees", "roll, degrees", "yaw, degrees"}, kIdle},
    {kSet2, {0xCE, 0, 0, 25, 0, 0}, {nullptr, "metres, rounded", "exact, cm; 0: as p2", nullptr}, "takes a picture whenever so much is flown over the ground; 0 ends that, and so do disarming and a restart of the mission"},
    {kSet2, {0xCF, 0, 2, 0, 0, 0}, {"0 off, 1 on, 2 the floor off", nullptr, nullptr, nullptr}, "switches the fence"},
    {kSet2, {0xD2, 0, 1, 0, 0, 0}, {"1 inverted, 0 upright", nullptr, nullptr, nullptr}, "upside down until 0 or a change of mode; above 30 m, and upright below 15 m and in take-off and landing"},
    {kSet2, {0x5D, 0, 0, 0, 30, 0}, {nullptr, nullptr, "seconds", nullptr}, kIdle},
    {kSet2, {0x73, 0, 0, 90, 10, 1}, {"not used", "angle, degrees", "rate, degrees/s", "direction"}, kIdle},
    {kSet2, {0xBF, 0, 0, 0, 40, 0}, {nullptr, nullptr, "height, m", nullptr}, kIdle},
    {kSet2, {0xC3, 1, 0, 12345, kNorth, kEast}, {nullptr, kAltitude_, kLatitude_, kLongitude_}, kIdle},
    {kSet2, {0xC5, 0, 0, 0, 0, 0}, {nullptr, nullptr, nullptr, nullptr}, kIdle},
    {kSet2, {0xD4, 0, 1, 0, 0, 0}, {"on", nullptr, nullptr, nullptr}, kIdle},
    {kSet2, {0xF0, 0, 0, 2, 0, 0}, {"camera", "mode", nullptr, nullptr}, "MAV_CMD 530; stored, has no effect"},
    {kSet2, {0xF1, 0, 0, 0, 1, 0}, {"camera", "seconds", "pictures", nullptr}, "MAV_CMD 2000; takes a picture, one alone"},
    {kSet2, {0xF2, 0, 1, 0, 0, 0}, {"camera", nullptr, nullptr, nullptr}, "MAV_CMD 2001; stored, has no effect"},
    {kSet2, {0xD6, 0, 0, 0, 2000, 0}, {nullptr, nullptr, "milliseconds", nullptr}, kIdle},
    {kSet2, {0xF3, 0, 0, 0, 7, 0}, {nullptr, nullptr, "tag", nullptr}, "MAV_CMD 600; stored, has no effect"},
    {kSet2, {0xF4, 0, 1, 2, 0, 0}, {"stream", "status, Hz", nullptr, nullptr}, "MAV_CMD 2500; stored, has no effect"},
    {kSet2, {0xF5, 0, 1, 0, 0, 0}, {"stream", nullptr, nullptr, nullptr}, "MAV_CMD 2501; stored, has no effect"},
    {kSet1, {0x10, 0, 25, 12345, kNorth, kEast}, {kRadius_, kAltitude_, kLatitude_, kLongitude_}, kPassed},
    {kSet1, {0x11, 0, 0, 12345, kNorth, kEast}, {nullptr, kAltitude_, kLatitude_, kLongitude_}, kEndless},
    {kSet1, {0x12, 0, 3, 12345, kNorth, kEast}, {"turns", kAltitude_, kLatitude_, kLongitude_}, kTicks},
    {kSet1, {0x13, 0, 12, 12345, kNorth, kEast}, {"tens of seconds", kAltitude_, kLatitude_, kLongitude_}, kTime},
    {kSet1, {0x14, 0, 0, 12345, kNorth, kEast}, {nullptr, "altitude, cm; 0: `ALT_HOLD_RTL`", "latitude, not used", "longitude, not used"}, kHome},
    {kSet1, {0x15, 0, 0, 12345, kNorth, kEast}, {nullptr, kAltitude_, kLatitude_, kLongitude_}, kDown},
    {kSet1, {0x16, 0, 15, 4000, 0, 0}, {"pitch, degrees", kAltitude_, nullptr, nullptr}, kUp},
    {kSet1, {0x20, 0, 200, 0, 0, 0}, {"seconds", nullptr, nullptr, nullptr}, kWaits},
    {kSet1, {0x21, 0, 200, 8000, 0, 0}, {"rate, cm/s", kAltitude_, "exact rate, cm/s; 0: as p1", nullptr}, kClimbs},
    {kSet1, {0x30, 0, 5, 0, 0, 0}, {"number of the mode", nullptr, nullptr, nullptr}, "changes the mode; AUTO does nothing"},
    {kSet1, {0x31, 0, 0, 0, 0, 0}, {nullptr, nullptr, nullptr, nullptr}, "goes on at item 1; cannot be item 1"},
    {kSet1, {0x32, 0, 134, 0, 0, 0}, {"slot of the parameter", nullptr, nullptr, nullptr}, "sends it to the ground, on every link"},
    {kSet1, {0x33, 0, 134, 0, 0, 0}, {"slot of the parameter", nullptr, nullptr, nullptr}, "sends it on every link and writes it to the log"},
    {kSet1, {0x34, 0, 1, 0, 0, 0}, {"0 off, 1 on", nullptr, nullptr, nullptr}, "silences the telemetry ports, never USB, until it is on again or the airplane is spoken to"},
    {kSet1, {0x40, 0, 14, 0, 0, 0}, {"m/s, within `ARSPD_FBW_MIN` and `_MAX`", nullptr, nullptr, nullptr}, "until the mission restarts or ends"},
    {kSet1, {0x41, 0, 60, 0, 0, 0}, {"%", nullptr, nullptr, nullptr}, "until the mission restarts or ends"},
    {kSet1, {0x42, 0, 0, 50000, kNorth, kEast}, {nullptr, "altitude above the sea, cm", kLatitude_, kLongitude_}, "moves home; all zero: here"},
    {kSet1, {0x60, 0, 0, 45000, 0, 0}, {"index", "value × 100,000", nullptr, nullptr}, "sets the parameter below"},
    {kSet1, {0x61, 0, 1, 4000, 0, 0}, {"index", "value × 100,000", nullptr, nullptr}, "sets the parameter below"},
    {kSet1, {0x62, 0, 1, 3000, 0, 0}, {"index", "value × 100,000", nullptr, nullptr}, "sets the parameter below"},
    {kSet1, {0x63, 0, 2, 12500000, 0, 0}, {"index", "value × 100,000", nullptr, nullptr}, "sets the parameter below"},
    {kSet1, {0x64, 0, 1, 50000, 0, 0}, {"index", "value × 100,000", nullptr, nullptr}, "sets the parameter below"},
    {kSet1, {0x70, 0, 4, 1510, 0, 0}, {"channel less 1", "us", nullptr, nullptr}, "sets `RCn_TRIM`; while armed of a free channel only"},
    {kSet1, {0x71, 0, 7, 1910, 0, 0}, {"channel less 1", "us", nullptr, nullptr}, "sets `RCn_MAX`; while armed of a free channel only"},
    {kSet1, {0x72, 0, 0, 1090, 0, 0}, {"channel less 1", "us", nullptr, nullptr}, "sets `RCn_MIN`; while armed of a free channel only"},
    {kSet1, {0x73, 0, 2, 960, 0, 0}, {"2: throttle failsafe; 0, 1: trim of elevon 1, 2, where `ELEVON_OUTPUT` is not 0", "us", nullptr, nullptr}, "sets `THR_FS_VALUE`, `RC1_TRIM`, `RC2_TRIM`"},
    {kSet1, {0x75, 0, 0, 3, 0, 0}, {"item, where p2 is 0", "item", nullptr, nullptr}, "goes on there"},
    {kSet1, {0x80, 0, 3, 1800, 5, 10}, {"1 to 5: output 4 to 8, 6: relay; 0 or 10 stops", "pulse, us", "seconds, under 2 counts as 2", "times; 0: for ever"}, "at the value for a second, then back to what was read; replaces what repeats"},
    {kSet1, {0x81, 0, 1, 0, 0, 0}, {"on", nullptr, nullptr, nullptr}, "switches it"},
    {kSet1, {0x82, 0, 6, 1234, 0, 0}, {"output less 1", "pulse, us; 0: none, under 800 counts as 800", nullptr, nullptr}, "held until the mode changes"},
};
// clang-format on

inline Sample commandOf(::mission::Set set, uint8_t id) {
    for (const Sample& sample : kSamples)
        if (sample.set == set && sample.record.id == id) return sample;
    return {};
}

inline ::mission::Record sampleOf(::mission::Set set, uint8_t id) {
    return commandOf(set, id).record;
}

inline ::mission::Record with(::mission::Record record, int field, int32_t value) {
    if (field == 1) record.p1 = static_cast<uint8_t>(value);
    if (field == 2) record.p2 = value;
    if (field == 3) record.p3 = value;
    if (field == 4) record.p4 = value;
    return record;
}

inline uint8_t answerTo(::mission::Set set, const ::mission::Record& record) {
    return kCommandTable.valid(kCommandTable.find(set, record.id), record, kSamplePosition);
}

struct Interval {
    int32_t lowest, highest;
};
using Intervals = std::vector<Interval>;

// What the layout has room for.
inline Interval roomOf(::mission::Set set, int field) {
    if (field == 1) return {0, 255};
    if (field == 2 && set == ::mission::Set::apm2) return {-8388608, 8388607};
    return {std::numeric_limits<int32_t>::min(), std::numeric_limits<int32_t>::max()};
}

// Every value near 0, and the ends of what lies beyond.
inline Intervals rangesOf(::mission::Set set, const ::mission::Record& sample, int field) {
    constexpr int64_t kNear = 40000;
    const Interval room = roomOf(set, field);
    const auto takes = [&](int64_t value) {
        return answerTo(set, with(sample, field, static_cast<int32_t>(value))) == 0;
    };
    std::vector<int64_t> values;
    for (int64_t value = -kNear; value <= kNear; ++value) values.push_back(value);
    for (int64_t value = kNear; value <= room.highest; value += value / 8)
        values.insert(values.end(), {value, -value});
    values.insert(values.end(), {room.lowest, room.highest});
    std::sort(values.begin(), values.end());
    Intervals found;
    bool before = false;
    int64_t last = room.lowest;
    for (const int64_t value : values) {
        if (value < room.lowest || value > room.highest) continue;
        const bool now = takes(value);
        int64_t low = last, high = value;  // the first value that is answered as `value` is
        while (now != before && high - low > 1) {
            const int64_t middle = low + (high - low) / 2;
            (takes(middle) == now ? high : low) = middle;
        }
        const auto end = static_cast<int32_t>(high);
        if (now && !before) found.push_back({end, room.highest});
        if (!now && before) found.back().highest = end - 1;
        before = now;
        last = value;
    }
    return found;
}

inline bool restricted(::mission::Set set, const Intervals& ranges, int field) {
    const Interval room = roomOf(set, field);
    return ranges.size() != 1 || ranges[0].lowest != room.lowest ||
           ranges[0].highest != room.highest;
}

}  // namespace firmware

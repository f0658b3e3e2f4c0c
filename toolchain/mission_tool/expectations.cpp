// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/expectations.hpp"

#include <cstdio>

#include "firmware/mission/command_table.hpp"
#include "firmware/mission/forms.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

using firmware::mission::MissionResult;
using mission::Set;

constexpr uint8_t kEvery = 0;  // command
constexpr Set kApm1 = Set::apm1, kApm2 = Set::apm2;

struct Row {
    Set set;
    uint8_t id;
    int parameter;
    const char* expected;
};

// firmware/mission/ranges.cpp and forms.cpp refuse; this says it in words. A test refuses every
// parameter of every command and finds its words here.
// clang-format off
constexpr Row kRows[] = {
    {kApm2, 0x10,   2, "an acceptance radius of 0 to 255 m"},
    {kApm2, 0x12,   1, "0 to 255 turns"},
    {kApm2, 0x13,   1, "a time of 0 to 2550 s"},
    {kApm2, 0x16,   1, "a pitch of 0 to 60 degrees"},
    {kApm2, 0x17,   2, "an acceptance radius of 0 to 255 m"},
    {kApm2, 0x70,   1, "a delay of 0 to 4000000 s"},
    {kApm2, 0x71,   1, "a rate of 0.11 to 100 m/s"},
    {kApm2, 0x72,   1, "a distance of 0 m or more"},
    {kApm2, 0xB1,   1, "an item of this mission, not home and not itself"},
    {kApm2, 0xB1,   2, "1 to 32767 repeats, or -1 for ever"},
    {kApm2, 0xB2,   1, "0 (air speed) or 1 (ground speed)"},
    {kApm2, 0xB2,   2, "a speed from ARSPD_FBW_MIN to ARSPD_FBW_MAX (ground: to 200 m/s), or -1"},
    {kApm2, 0xB2,   3, "a throttle of 0 to 100 %, or -1"},
    {kApm2, 0xB3,   1, "1 (here) or 0 (the place given)"},
    {kApm2, 0xB4,   1, "the slot of a parameter"},
    {kApm2, 0xB4,   2, "a value in the parameter's range"},
    {kApm2, 0xB5,   1, "relay 0"},
    {kApm2, 0xB5,   2, "0 or 1"},
    {kApm2, 0xB6,   1, "relay 0"},
    {kApm2, 0xB6,   2, "0 to 32767 cycles"},
    {kApm2, 0xB6,   3, "a cycle of 1 to 60 s"},
    {kApm2, 0xB7,   1, "an output of 5 to 8"},
    {kApm2, 0xB7,   2, "0, 1, or a pulse of 800 to 2200 us"},
    {kApm2, 0xB8,   1, "an output of 5 to 8"},
    {kApm2, 0xB8,   2, "0, or a pulse of 800 to 2200 us"},
    {kApm2, 0xB8,   3, "0 to 32767 cycles"},
    {kApm2, 0xB8,   4, "a cycle of 1 to 60 s"},
    {kApm2, 0x1E,   1, "0 (either way), 1 (climb) or 2 (descend)"},
    {kApm2, 0x1F,   1, "0 or 1 (leaves on the next leg's course)"},
    {kApm2, 0x1F,   2, "a radius in metres, negative for counter-clockwise"},
    {kApm2, 0xC9,   1, "a MAV_ROI of 0 to 4"},
    {kApm2, 0xCB,   1, "a session of 0 to 255"},
    {kApm2, 0xCB,   2, "a whole number"},
    {kApm2, 0xCB,   3, "a whole number"},
    {kApm2, 0xCB,   4, "a whole number"},
    {kApm2, 0xCD,   1, "a pitch of -360 to 360 degrees"},
    {kApm2, 0xCD,   2, "a roll of -360 to 360 degrees"},
    {kApm2, 0xCD,   3, "a yaw of -360 to 360 degrees"},
    {kApm2, 0xCD,   7, "a MAV_MOUNT_MODE of 0 to 6"},
    {kApm2, 0xCE,   1, "0, or a distance of 0.01 to 10000 m"},
    {kApm2, 0xCF,   1, "0 (off), 1 (on) or 2 (the floor off)"},
    {kApm2, 0xD2,   1, "0 or 1"},
    {kApm2, 0x5D,   1, "a whole number of seconds"},
    {kApm2, 0x73,   1, "a whole number of degrees"},
    {kApm2, 0x73,   2, "a whole number of degrees/s"},
    {kApm2, 0x73,   3, "a whole number"},
    {kApm2, 0x73,   7, "0 to 255"},
    {kApm2, 0xBF,   1, "a whole number of metres"},
    {kApm2, 0xD4,   1, "0 or 1"},
    {kApm2, 0xF0,   1, "a camera of 0 to 255"},
    {kApm2, 0xF0,   2, "a whole number"},
    {kApm2, 0xF1,   1, "a camera of 0 to 255"},
    {kApm2, 0xF1,   2, "a whole number of seconds"},
    {kApm2, 0xF1,   3, "1: one picture, a series by time there is none"},
    {kApm2, 0xF2,   1, "a camera of 0 to 255"},
    {kApm2, 0xD6,   1, "a whole number of milliseconds"},
    {kApm2, 0xF3,   1, "a tag that is a whole number"},
    {kApm2, 0xF4,   1, "a stream of 0 to 255"},
    {kApm2, 0xF4,   2, "a whole number"},
    {kApm2, 0xF5,   1, "a stream of 0 to 255"},
    {kApm1, 0x16,   1, "a pitch of 0 to 60 degrees"},
    {kApm1, 0x21,   1, "a rate of 11 to 10000 cm/s"},
    {kApm1, 0x30,   1, "the number of a flight mode"},
    {kApm1, 0x32,   1, "the slot of a parameter"},
    {kApm1, 0x33,   1, "the slot of a parameter"},
    {kApm1, 0x34,   1, "0 or 1"},
    {kApm1, 0x40,   1, "a speed from ARSPD_FBW_MIN to ARSPD_FBW_MAX, in m/s"},
    {kApm1, 0x41,   1, "a throttle of 0 to 100 %"},
    {kApm1, 0x60,   1, "the index of a gain that this firmware has"},
    {kApm1, 0x60,   2, "a gain, times 100000, in its parameter's range"},
    {kApm1, 0x61,   1, "the index of a gain that this firmware has"},
    {kApm1, 0x61,   2, "a gain, times 100000, in its parameter's range"},
    {kApm1, 0x62,   1, "the index of a gain that this firmware has"},
    {kApm1, 0x62,   2, "a gain, times 100000, in its parameter's range"},
    {kApm1, 0x63,   1, "the index of a limit that this firmware has"},
    {kApm1, 0x63,   2, "a limit, times 100000, in its parameter's range"},
    {kApm1, 0x64,   1, "the index of a gain that this firmware has"},
    {kApm1, 0x64,   2, "a gain, times 100000, in its parameter's range"},
    {kApm1, 0x70,   1, "0 to 7, for channel 1 to 8"},
    {kApm1, 0x70,   2, "800 to 2200 us"},
    {kApm1, 0x71,   1, "0 to 7, for channel 1 to 8"},
    {kApm1, 0x71,   2, "800 to 2200 us"},
    {kApm1, 0x72,   1, "0 to 7, for channel 1 to 8"},
    {kApm1, 0x72,   2, "800 to 2200 us"},
    {kApm1, 0x73,   1, "2, the throttle failsafe"},
    {kApm1, 0x73,   2, "a pulse in the range of THR_FS_VALUE, in us"},
    {kApm1, 0x75,   2, "an item of this mission, not home and not itself"},
    {kApm1, 0x80,   1, "an event of 1 to 6, or 0 or 10 to stop"},
    {kApm1, 0x80,   2, "a pulse of 800 to 2200 us"},
    {kApm1, 0x80,   3, "a delay of 0 to 65535 s"},
    {kApm1, 0x80,   4, "0 to 32767 times"},
    {kApm1, 0x81,   1, "0 or 1"},
    {kApm1, 0x82,   1, "0 to 7, for output 1 to 8"},
    {kApm1, 0x82,   2, "a pulse of 0 to 2000 us"},
    {kApm2, kEvery, 3, "a radius in metres, negative for counter-clockwise"},
    {kApm2, kEvery, 5, "a latitude of -90 to 90 degrees"},
    {kApm2, kEvery, 6, "a longitude of -180 to 180 degrees"},
    {kApm2, kEvery, 7, "an altitude of -83886.08 to 83886.07 m"},
    {kApm1, kEvery, 5, "a latitude of -900000000 to 900000000"},
    {kApm1, kEvery, 6, "a longitude of -1800000000 to 1800000000"},
    {kApm1, kEvery, 7, "an altitude of -83886 to 83886 m"},
    {kApm1, kEvery, 1, "a whole number of 0 to 255"},
    {kApm1, kEvery, 2, "a whole number that a float carries exactly"},
    {kApm1, kEvery, 3, "a whole number that a float carries exactly"},
    {kApm1, kEvery, 4, "a whole number that a float carries exactly"},
};
// clang-format on

std::string ofParameter(Set set, uint8_t id, int parameter) {
    for (const Row& row : kRows)
        if (row.set == set && (row.id == id || row.id == kEvery) && row.parameter == parameter)
            return row.expected;
    return "param" + std::to_string(parameter) + " in the command's range (docs/mission.md)";
}

}  // namespace

int refusedParameter(MissionResult result) {
    const int number = static_cast<int>(result) - static_cast<int>(MissionResult::invalid_param1);
    return number >= 0 && number < 7 ? number + 1 : 0;
}

std::string expectation(Set set, const Entry& entry) {
    if (const int parameter = refusedParameter(entry.result)) {
        return ofParameter(set, entry.record.id, parameter);
    }
    if (entry.result == MissionResult::unsupported) {
        return std::string("a command of the ") + (set == Set::apm1 ? "APM 1.0" : "APM 2.0") +
               " set";
    }
    if (entry.result == MissionResult::unsupported_frame) {
        return set == Set::apm1 ? "the frame that ALT_ABS asks for: 3 above home, 0 above the sea"
                                : "an altitude above the sea or above home, not above terrain";
    }
    return "a command that can stand here";  // RESET_INDEX as item 1
}

std::string foundInstead(Set set, const Entry& entry) {
    const mission::Record& record = entry.record;
    if (entry.result == MissionResult::unsupported_frame) {
        return "options " + std::to_string(record.options);
    }
    const int parameter = refusedParameter(entry.result);
    if (parameter == 0) {
        char id[8];
        std::snprintf(id, sizeof id, "0x%02X", record.id);
        return id;
    }
    const int32_t fields[] = {record.p1, record.p2, record.p3, record.p4};
    return std::to_string(fields[fieldOf(set, entry.row, parameter) - 1]);
}

void checkAll(Document& document) {
    const size_t count = document.entries.size();
    for (size_t index = 0; index < count; ++index) {
        Entry& entry = document.entries[index];
        if (!entry.good()) continue;  // found already, where it was read
        if (check(document.set, index, count, entry) == MissionResult::accepted) continue;
        entry.problem =
            expected(expectation(document.set, entry), foundInstead(document.set, entry));
    }
}

int fieldOf(Set set, uint8_t row, int parameter) {
    constexpr int kPlaceFields[] = {3, 4, 2};  // x, y, z
    if (parameter >= 5) return kPlaceFields[parameter - 5];
    if (set == Set::apm1 || row == mission::kNoRow) return parameter;
    const firmware::mission::FormRow form =
        firmware::mission::formRow(firmware::mission::kCommandTable.form(row));
    for (int i = 0; i < 4; ++i)
        if (form.from[i] == parameter) return i + 1;
    return parameter;  // a special: it stands where its number says
}

}  // namespace mission_tool

// SPDX-License-Identifier: GPL-3.0-or-later
// Missions of ArduPlane 3.x boards. docs/mission.md, "Images of ArduPlane 3.x", has the layout.
#include <cmath>
#include <cstring>

#include "storage/bytes.hpp"
#include "toolchain/mission_tool/arduplane.hpp"
#include "toolchain/mission_tool/waypoint_form.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

using firmware::mission::MissionItem;
using storage::get16;
using storage::get32;

constexpr size_t kRecordSize = 15, kFirst = 0x500 + 4, kRally = 3786;
constexpr size_t kMax = (kRally - kFirst) / kRecordSize;
constexpr uint8_t kNeverWritten = 0xFF, kNothing = 0;
constexpr uint8_t kAboveSea = 0, kMission = 2, kAboveHome = 3, kAboveTerrain = 10;  // MAV_FRAME

struct Stored {
    uint8_t id;
    uint16_t p1;
    const uint8_t* content;  // 12 bytes
};

float real(const uint8_t* from) {
    float value;
    std::memcpy(&value, from, sizeof value);
    return value;
}
int16_t whole(const uint8_t* from) { return static_cast<int16_t>(get16(from)); }

// Options, altitude, latitude, longitude; the sign of a radius is one of the options.
float place(const Stored& from, MissionItem& item) {
    const uint8_t options = from.content[0];
    item.frame = (options & mission::kAboveTerrain) != 0       ? kAboveTerrain
                 : (options & mission::kRelativeAltitude) != 0 ? kAboveHome
                                                               : kAboveSea;
    item.z = static_cast<float>(static_cast<int32_t>(get32(from.content)) >> 8) / 100;
    item.x = static_cast<int32_t>(get32(from.content + 4));
    item.y = static_cast<int32_t>(get32(from.content + 8));
    return (options & mission::kCounterClockwise) != 0 ? -1 : 0;
}

void placeAlone(const Stored& from, MissionItem& item) { (void)place(from, item); }
void placeP1(const Stored& from, MissionItem& item) {
    (void)place(from, item);
    item.param1 = from.p1;
}
void waypoint(const Stored& from, MissionItem& item) {
    (void)place(from, item);
    item.param2 = static_cast<float>(from.p1 & 0xFF);
}
void loiter(const Stored& from, MissionItem& item) { item.param3 = place(from, item); }
void turns(const Stored& from, MissionItem& item) {
    loiter(from, item);
    item.param1 = static_cast<float>(from.p1 & 0xFF);  // above it the radius
}
void loiterTime(const Stored& from, MissionItem& item) {
    loiter(from, item);
    item.param1 = from.p1;
}
void toHeight(const Stored& from, MissionItem& item) {
    item.param2 = place(from, item);
    item.param1 = from.p1;
}
void height(const Stored& from, MissionItem& item) {
    (void)place(from, item);
    item.x = item.y = 0;
    item.param1 = from.p1;
}
void climb(const Stored& from, MissionItem& item) {
    height(from, item);
    item.param1 = static_cast<float>(get32(from.content + 4)) / 100;
}
void number(const Stored& from, MissionItem& item) { item.param1 = real(from.content); }
void p1Alone(const Stored& from, MissionItem& item) { item.param1 = from.p1; }
void jump(const Stored& from, MissionItem& item) {
    item.param1 = get16(from.content);
    item.param2 = whole(from.content + 2);
}
// What is not more than 0 changes nothing there.
void speed(const Stored& from, MissionItem& item) {
    item.param1 = from.content[0];
    item.param2 = real(from.content + 1) > 0 ? real(from.content + 1) : -1;
    item.param3 = real(from.content + 5) > 0 ? real(from.content + 5) : -1;
}
void relay(const Stored& from, MissionItem& item) {
    item.param1 = from.content[0];
    item.param2 = from.content[1];
}
void repeatRelay(const Stored& from, MissionItem& item) {
    item.param1 = from.content[0];
    item.param2 = whole(from.content + 1);
    item.param3 = real(from.content + 3);
}
void servo(const Stored& from, MissionItem& item) {
    item.param1 = from.content[0];
    item.param2 = get16(from.content + 1);
}
void repeatServo(const Stored& from, MissionItem& item) {
    servo(from, item);
    item.param3 = whole(from.content + 3);
    item.param4 = real(from.content + 5);
}
void nothing(const Stored&, MissionItem&) {}

struct Row {
    uint8_t id;
    void (*read)(const Stored& from, MissionItem& item);
};
constexpr Row kRows[] = {
    {16, waypoint},   {17, loiter},       {18, turns},      {19, loiterTime},   {20, placeAlone},
    {21, placeAlone}, {22, height},       {30, placeAlone}, {31, toHeight},     {112, number},
    {113, climb},     {114, number},      {177, jump},      {178, speed},       {179, placeP1},
    {181, relay},     {182, repeatRelay}, {183, servo},     {184, repeatServo}, {189, placeAlone},
    {201, placeP1},   {206, number},      {207, p1Alone},   {210, p1Alone},
};

MissionItem itemOf(const Stored& from) {
    MissionItem item = {};
    item.command = from.id;
    item.frame = kMission;
    auto read = nothing;
    for (const Row& row : kRows)
        if (row.id == from.id) read = row.read;
    read(from, item);
    return item;
}

}  // namespace

Document readMissionOf3(const Image& image, const std::string& name, size_t count) {
    if (count > kMax)
        throw WrongInput(name + ": --count: expected at most " + std::to_string(kMax));
    std::vector<MissionItem> items;
    for (size_t index = 0; index < (count != 0 ? count : kMax); ++index) {
        const uint8_t* from = image.data() + kFirst + index * kRecordSize;
        const bool written = from[0] != kNeverWritten && from[0] != kNothing;
        if (count == 0 && !written) break;
        items.push_back(itemOf({from[0], get16(from + 1), from + 3}));
    }
    if (items.empty()) throw WrongInput(name + ": no mission in it");
    Document document = parseWaypointFile(itemsAsWaypoints(items), name, mission::Set::apm2);
    for (Entry& entry : document.entries) entry.line = 0;  // there are no lines in an image
    return document;
}

}  // namespace mission_tool

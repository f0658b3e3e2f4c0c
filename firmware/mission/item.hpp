// SPDX-License-Identifier: GPL-3.0-or-later
// Between the ground link's mission items and stored records, both ways. A record read back gives
// the item that would store it again.
#pragma once
#include "firmware/mission/mission.hpp"
#include "mission/command_table.hpp"

namespace firmware {
namespace mission {

// How the parameters of an APM 2.0 command stand in an item. (APM 1.0 commands all travel alike.)
namespace FormOf {
enum Form : uint8_t {
    none,  // not in the set
    waypoint,
    unlimited,
    turns,
    time,
    place,
    takeoff,
    climb,
    seconds,  // or metres
    jump,
    speed,
    place_p1,  // a place with a number
    parameter,
    p1_p2,
    p1_p2_p3,
    repeat,
    p1,
    p1_to_p4,
    to_height,
    mount,
    distance,
    kForms,
};
}
using Form = FormOf::Form;

struct EncodeWarnings {  // what the ground should be sent once an upload
    bool rounded;        // a value was
    bool dropped;        // a parameter has no field, or was not needed
};

// The id that a MAV_CMD has in a record of the 2.0 set; kNoId: none.
uint8_t idOf(uint16_t command);

MissionResult encodeItem(::mission::Set set, ::mission::ItemPosition position,
                         const MissionItem& item, ::mission::Record& record,
                         EncodeWarnings& warnings);
void decodeItem(::mission::Set set, uint8_t index, const ::mission::Record& record,
                MissionItem& item);

}  // namespace mission
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// The three lists of the mission protocol, distinguished by MAV_MISSION_TYPE: the mission, the
// fence, the rally points. The rules are those of mission.hpp.
#pragma once
#include "firmware/mission/lists.hpp"

namespace firmware {
namespace gcs {

bool isMissionType(uint8_t mission_type);
uint8_t itemCount(uint8_t mission_type);
uint32_t itemsId(uint8_t mission_type);  // MAVLink's opaque_id; 0: nothing is stored
MUST_USE core::Status readItem(uint8_t mission_type, uint16_t index, mission::MissionItem& to);

mission::MissionResult uploadBegin(uint8_t mission_type, uint16_t count);
mission::MissionResult uploadBeginPartial(uint8_t mission_type, uint16_t first, uint16_t last);
mission::MissionResult uploadPut(uint8_t mission_type, uint16_t index,
                                 const mission::MissionItem& item);
mission::MissionResult uploadCommit(uint8_t mission_type);
mission::MissionResult clearItems(uint8_t mission_type);  // all of them too; until it is not busy

}  // namespace gcs
}  // namespace firmware

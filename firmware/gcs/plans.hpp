// SPDX-License-Identifier: GPL-3.0-or-later
// The three lists of the mission protocol, distinguished by MAV_MISSION_TYPE: the mission, the
// fence, the rally points. The rules are those of mission.hpp.
#pragma once
#include "firmware/mission/lists.hpp"

namespace firmware {
namespace gcs {

bool isPlan(uint8_t mission_type);
uint8_t planCount(uint8_t mission_type);
uint32_t planId(uint8_t mission_type);  // MAVLink's opaque_id; 0: nothing is stored
MUST_USE core::Status planItem(uint8_t mission_type, uint16_t index, mission::MissionItem& to);

mission::MissionResult planBegin(uint8_t mission_type, uint16_t count);
mission::MissionResult planBeginPartial(uint8_t mission_type, uint16_t first, uint16_t last);
mission::MissionResult planPut(uint8_t mission_type, uint16_t index,
                               const mission::MissionItem& item);
mission::MissionResult planCommit(uint8_t mission_type);
mission::MissionResult planClear(uint8_t mission_type);  // all of them too; until it is not busy

}  // namespace gcs
}  // namespace firmware

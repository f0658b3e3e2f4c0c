// SPDX-License-Identifier: GPL-3.0-or-later
// The records of the fence and of the rally points, and what they are as items of the mission
// protocol. docs/mission.md lists their bytes.
#pragma once
#include <stdint.h>

#include "firmware/mission/lists.hpp"
#include "geo/position.hpp"

namespace firmware {
namespace mission {

constexpr uint8_t kPointSet = 1;  // version of both records

// Where the corners' polygon sends the airplane when it has left it, or one of the corners, which
// follow one another whatever stands between them.
enum class FencePoint : uint8_t { corner, way_back };

void setPlace(uint8_t* record, const geo::Position& place);
geo::Position placeOf(const uint8_t* record);
bool isPlace(const geo::Position& place);  // on the globe, and not 0, 0: that is left blank

void setFencePoint(uint8_t* record, FencePoint kind);
FencePoint fencePoint(const uint8_t* record);

void setRallyHeight(uint8_t* record, float height_m, bool above_home);
float rallyHeight_m(const uint8_t* record);  // above home

// `count`: of the whole list. What this airplane does not fly is refused, the reason reported.
MissionResult pointFromItem(ListKind kind, const MissionItem& item, uint8_t count, uint8_t* record);
void itemFromPoint(ListKind kind, const uint8_t* record, MissionItem& item);

}  // namespace mission
}  // namespace firmware

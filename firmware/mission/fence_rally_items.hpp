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
constexpr float kLargestRadius_m = 10000;

// What a record of the fence is. All `corner`s are one inclusion polygon, as every fence was once;
// a `zone_corner` says itself which it is of a polygon of how many.
enum class FencePoint : uint8_t { corner, way_back, zone_corner, circle };

void setPlace(uint8_t* record, const geo::Position& place);
geo::Position placeOf(const uint8_t* record);
bool isPlace(const geo::Position& place);  // on the globe, and not 0, 0: that is left blank

void setFencePoint(uint8_t* record, FencePoint kind);  // a corner, or the way back
FencePoint fencePoint(const uint8_t* record);
bool excludes(const uint8_t* record);         // of a zone: it must not be entered
uint8_t zoneCorner(const uint8_t* record);    // of a zone_corner: how many stand before it
uint8_t zoneCorners(const uint8_t* record);   // of how many
float circleRadius_m(const uint8_t* record);  // of a circle

void setRallyHeight(uint8_t* record, float height_m, bool above_home);
float rallyHeight_m(const uint8_t* record);  // above home

// What the items of a fence's upload have come to: corners follow one another until their polygon
// is whole, but for a return point between them.
struct FenceUpload {
    uint8_t left;   // corners that are still to come
    uint8_t shape;  // of the last zone: of its corners byte 9, and a bit; 0: there was none yet
};

// `index` of `count`: of the whole list. What this airplane does not fly is refused, the reason
// reported; then neither `record` nor `upload` says anything.
MissionResult pointFromItem(ListKind kind, const MissionItem& item, uint8_t index, uint8_t count,
                            FenceUpload& upload, uint8_t* record);
void itemFromPoint(ListKind kind, const uint8_t* record, MissionItem& item);

}  // namespace mission
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/fence_rally_items.hpp"

#include <math.h>

#include "core/maths.hpp"
#include "firmware/mission/fence_line.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/vehicle.hpp"
#include "mavlink/messages.hpp"
#include "storage/bytes.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;

namespace {

using mavlink::MavCmd;
using mavlink::MavFrame;

// Of a fence's record: 8 what it is, 9 the frame it came in. Of a rally point's: 8, 9 whole metres,
// 10 centimetres and whether they are above home.
constexpr uint8_t kKind = 8, kFrame = 9, kMetres = 8, kRest = 10;
constexpr uint8_t kAboveHome = 0x80;

// The frame without its _INT, which says nothing that the message does not say.
bool plainFrame(uint8_t& frame) {
    if (frame == MavFrame::global_int) frame = MavFrame::global;
    if (frame == MavFrame::global_relative_alt_int) frame = MavFrame::global_relative_alt;
    return frame == MavFrame::global || frame == MavFrame::global_relative_alt;
}

// One polygon, which all but a way back belong to.
MissionResult fenceFromItem(const MissionItem& item, uint8_t count, uint8_t* record) {
    if (item.command == MavCmd::nav_fence_return_point) {
        setFencePoint(record, FencePoint::way_back);
        return MissionResult::accepted;
    }
    const bool ours = item.command == MavCmd::nav_fence_polygon_vertex_inclusion &&
                      (item.param1 == count || item.param1 == count - 1);
    if (!ours) {
        sendStatusText(Severity::warning, STATUS_TEXT("Fence: one inclusion polygon, no more"));
        return MissionResult::unsupported;
    }
    setFencePoint(record, FencePoint::corner);
    return item.param1 >= 3 ? MissionResult::accepted : MissionResult::invalid_param1;
}

MissionResult rallyFromItem(const MissionItem& item, uint8_t frame, uint8_t* record) {
    constexpr MissionResult kAltitudeWrong =
        static_cast<MissionResult>(static_cast<uint8_t>(MissionResult::invalid_param1) + 6);
    if (item.command != MavCmd::nav_rally_point) return MissionResult::unsupported;
    if (!(fabsf(item.z) < 32000)) return kAltitudeWrong;
    setRallyHeight(record, item.z, frame == MavFrame::global_relative_alt);
    return MissionResult::accepted;
}

float storedHeight_m(const uint8_t* record) {
    const int16_t whole_m = static_cast<int16_t>(storage::get16(record + kMetres));
    return whole_m + core::hundredths(record[kRest] & ~kAboveHome & 0xFF);
}

}  // namespace

void setPlace(uint8_t* record, const geo::Position& place) {
    storage::put32(record, static_cast<uint32_t>(place.latitude_e7));
    storage::put32(record + 4, static_cast<uint32_t>(place.longitude_e7));
}

geo::Position placeOf(const uint8_t* record) {
    return {static_cast<int32_t>(storage::get32(record)),
            static_cast<int32_t>(storage::get32(record + 4))};
}

bool isPlace(const geo::Position& place) {
    constexpr int32_t kPole_e7 = 900000000, kHalfTurn_e7 = 1800000000;
    return place.latitude_e7 >= -kPole_e7 && place.latitude_e7 <= kPole_e7 &&
           place.longitude_e7 >= -kHalfTurn_e7 && place.longitude_e7 <= kHalfTurn_e7 &&
           (place.latitude_e7 != 0 || place.longitude_e7 != 0);
}

void setFencePoint(uint8_t* record, FencePoint kind) {
    record[kKind] = static_cast<uint8_t>(kind);
    record[kFrame] = MavFrame::global;
}

FencePoint fencePoint(const uint8_t* record) { return static_cast<FencePoint>(record[kKind]); }

void setRallyHeight(uint8_t* record, float height_m, bool above_home) {
    const int32_t height_cm = core::rounded(height_m * 100);
    const int32_t whole_m = (height_cm + 3200000) / 100 - 32000;  // rounded down
    storage::put16(record + kMetres, static_cast<uint16_t>(whole_m));
    record[kRest] =
        static_cast<uint8_t>((height_cm - 100 * whole_m) | (above_home ? kAboveHome : 0));
}

float rallyHeight_m(const uint8_t* record) {
    const float height_m = storedHeight_m(record);
    if ((record[kRest] & kAboveHome) != 0) return height_m;
    return height_m - core::hundredths(vehicle.home.altitude_cm);
}

MissionResult pointFromItem(ListKind kind, const MissionItem& item, uint8_t count,
                            uint8_t* record) {
    constexpr MissionResult kPlaceWrong =
        static_cast<MissionResult>(static_cast<uint8_t>(MissionResult::invalid_param1) + 4);
    uint8_t frame = item.frame;
    if (!plainFrame(frame)) return MissionResult::unsupported_frame;
    const bool fence = kind == ListKind::fence;
    const MissionResult result =
        fence ? fenceFromItem(item, count, record) : rallyFromItem(item, frame, record);
    if (result != MissionResult::accepted) return result;
    const geo::Position place = {item.x, item.y};
    if (!isPlace(place)) return kPlaceWrong;
    setPlace(record, place);
    if (fence) record[kFrame] = frame;
    return MissionResult::accepted;
}

void itemFromPoint(ListKind kind, const uint8_t* record, MissionItem& item) {
    item = {};
    const geo::Position place = placeOf(record);
    item.x = place.latitude_e7;
    item.y = place.longitude_e7;
    if (kind == ListKind::rally) {
        item.command = MavCmd::nav_rally_point;
        item.frame =
            (record[kRest] & kAboveHome) != 0 ? MavFrame::global_relative_alt : MavFrame::global;
        item.z = storedHeight_m(record);
        return;
    }
    item.frame = record[kFrame];
    if (fencePoint(record) == FencePoint::way_back) {
        item.command = MavCmd::nav_fence_return_point;
        return;
    }
    item.command = MavCmd::nav_fence_polygon_vertex_inclusion;
    item.param1 = fenceCorners();
}

}  // namespace mission
}  // namespace firmware

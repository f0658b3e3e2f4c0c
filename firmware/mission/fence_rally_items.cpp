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

// Of a fence's record: 8 what it is, 9 the frame it came in, and more of a zone. Of a rally
// point's: 8, 9 whole metres, 10 centimetres and whether they are above home.
constexpr uint8_t kKind = 8, kFrame = 9, kMetres = 8, kRest = 10;
constexpr uint8_t kAboveHome = 0x80;

// What byte 8 is from, and bits of byte 9. The frame's lowest bit says which of the two it is.
constexpr uint8_t kZoneCorner = 0x20, kCircle = 0x40;
constexpr uint8_t kFrameBit = 1, kExcludes = 0x80;
constexpr uint8_t kAlone = 1;  // of FenceUpload::shape: its corners are FencePoint::corner
constexpr uint8_t kCornersAt = 2, kRadiusAt = 1;
constexpr uint8_t kCornersMask = 0x1F, kRadiusMask = 0x3F, kRadiusBits = 6;

// Steps of a radius: decimetres up to 250 m, metres beyond.
constexpr float kFine_m = 250;
constexpr int16_t kFineSteps = 2500;
static_assert(kLargestRadius_m + kFineSteps - kFine_m < (0x100 - kCircle) << kRadiusBits,
              "the largest radius has no room in a record");

void setFrame(uint8_t* record, uint8_t frame) {
    const bool circle = fencePoint(record) == FencePoint::circle;
    record[kFrame] = static_cast<uint8_t>(record[kFrame] | (circle ? frame & kFrameBit : frame));
}

// The frame without its _INT, which says nothing that the message does not say.
bool plainFrame(uint8_t& frame) {
    if (frame == MavFrame::global_int) frame = MavFrame::global;
    if (frame == MavFrame::global_relative_alt_int) frame = MavFrame::global_relative_alt;
    return frame == MavFrame::global || frame == MavFrame::global_relative_alt;
}

// The first zone has the form that every fence had once, where there can be no second polygon.
MissionResult cornerFromItem(float param1, uint8_t excluded, uint8_t count, FenceUpload& upload,
                             uint8_t* record) {
    constexpr float kFewest = 3;
    if (!(param1 >= kFewest && param1 <= storage::kFencePoints))
        return MissionResult::invalid_param1;
    const uint8_t corners = static_cast<uint8_t>(param1);
    const uint8_t shape = static_cast<uint8_t>(corners << kCornersAt | excluded);
    if (upload.left == 0) {
        const bool alone = upload.shape == 0 && excluded == 0 && corners + 1 >= count;
        upload.left = corners;
        upload.shape = shape | (alone ? kAlone : 0);
    }
    if ((upload.shape & ~kAlone) != shape || corners != param1)
        return MissionResult::invalid_param1;
    setFencePoint(record, FencePoint::corner);
    if ((upload.shape & kAlone) == 0) {
        record[kKind] = static_cast<uint8_t>(kZoneCorner + corners - upload.left);
        record[kFrame] = shape;
    }
    --upload.left;
    return MissionResult::accepted;
}

MissionResult circleFromItem(float radius_m, uint8_t excluded, FenceUpload& upload,
                             uint8_t* record) {
    const int32_t steps =
        core::rounded(radius_m <= kFine_m ? radius_m * 10 : radius_m + (kFineSteps - kFine_m));
    if (upload.left != 0 || steps <= 0 || !(radius_m <= kLargestRadius_m))
        return MissionResult::invalid_param1;
    upload.shape = kExcludes;
    const uint16_t steps16 = static_cast<uint16_t>(steps);
    record[kKind] = static_cast<uint8_t>(kCircle + (steps16 >> kRadiusBits));
    record[kFrame] = static_cast<uint8_t>((steps16 & kRadiusMask) << kRadiusAt | excluded);
    return MissionResult::accepted;
}

// The four kinds of zones follow the return point: polygon, circle, each to stay in and out of.
MissionResult zoneFromItem(const MissionItem& item, uint8_t count, FenceUpload& upload,
                           uint8_t* record) {
    const uint16_t kind = static_cast<uint16_t>(item.command - MavCmd::nav_fence_return_point);
    if (kind > MavCmd::nav_fence_circle_exclusion - MavCmd::nav_fence_return_point)
        return MissionResult::unsupported;
    setFencePoint(record, FencePoint::way_back);
    if (kind == 0) return MissionResult::accepted;
    const uint8_t excluded = (kind & 1) != 0 ? 0 : kExcludes;
    if (kind >= MavCmd::nav_fence_circle_inclusion - MavCmd::nav_fence_return_point)
        return circleFromItem(item.param1, excluded, upload, record);
    return cornerFromItem(item.param1, excluded, count, upload, record);
}

MissionResult fenceFromItem(const MissionItem& item, uint8_t index, uint8_t count,
                            FenceUpload& upload, uint8_t* record) {
    MissionResult result = zoneFromItem(item, count, upload, record);
    if (result == MissionResult::accepted && upload.left >= count - index)
        result = MissionResult::invalid_param1;
    if (result != MissionResult::accepted)
        sendStatusText(Severity::warning,
                       result == MissionResult::unsupported
                           ? STATUS_TEXT("Item # refused: no part of a fence")
                           : STATUS_TEXT("Item # refused: corners or radius"),
                       index);
    return result;
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
    return core::real(whole_m) + core::hundredths(record[kRest] & ~kAboveHome & 0xFF);
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

FencePoint fencePoint(const uint8_t* record) {
    const uint8_t kind = record[kKind];
    if (kind >= kCircle) return FencePoint::circle;
    return kind >= kZoneCorner ? FencePoint::zone_corner : static_cast<FencePoint>(kind);
}

bool excludes(const uint8_t* record) { return (record[kFrame] & kExcludes) != 0; }
uint8_t zoneCorner(const uint8_t* record) { return record[kKind] & kCornersMask; }
uint8_t zoneCorners(const uint8_t* record) { return record[kFrame] >> kCornersAt & kCornersMask; }

float circleRadius_m(const uint8_t* record) {
    const int16_t steps = static_cast<int16_t>((record[kKind] - kCircle) << kRadiusBits |
                                               (record[kFrame] >> kRadiusAt & kRadiusMask));
    if (steps <= kFineSteps) return core::real(steps) / 10;
    return core::real(steps) - (kFineSteps - kFine_m);
}

void setRallyHeight(uint8_t* record, float height_m, bool above_home) {
    const int32_t height_cm = core::inHundredths(height_m);
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

MissionResult pointFromItem(ListKind kind, const MissionItem& item, uint8_t index, uint8_t count,
                            FenceUpload& upload, uint8_t* record) {
    constexpr MissionResult kPlaceWrong =
        static_cast<MissionResult>(static_cast<uint8_t>(MissionResult::invalid_param1) + 4);
    uint8_t frame = item.frame;
    if (!plainFrame(frame)) return MissionResult::unsupported_frame;
    const bool fence = kind == ListKind::fence;
    const MissionResult result = fence ? fenceFromItem(item, index, count, upload, record)
                                       : rallyFromItem(item, frame, record);
    if (result != MissionResult::accepted) return result;
    const geo::Position place = {item.x, item.y};
    if (!isPlace(place)) return kPlaceWrong;
    setPlace(record, place);
    if (fence) setFrame(record, frame);
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
    item.frame =
        (record[kFrame] & kFrameBit) != 0 ? MavFrame::global_relative_alt : MavFrame::global;
    switch (fencePoint(record)) {
        case FencePoint::way_back:
            item.command = MavCmd::nav_fence_return_point;
            return;
        case FencePoint::circle:
            item.command = MavCmd::nav_fence_circle_inclusion;
            item.param1 = circleRadius_m(record);
            break;
        case FencePoint::zone_corner:
            item.command = MavCmd::nav_fence_polygon_vertex_inclusion;
            item.param1 = zoneCorners(record);
            break;
        case FencePoint::corner:
            item.command = MavCmd::nav_fence_polygon_vertex_inclusion;
            item.param1 = core::real(fenceCorners());
            break;
    }
    if (excludes(record)) ++item.command;  // each exclusion is the next number
}

}  // namespace mission
}  // namespace firmware

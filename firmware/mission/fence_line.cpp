// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/fence_line.hpp"

#include "core/file_state.hpp"
#include "firmware/mission/fence_rally_items.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"
#include "geo/polygon.hpp"
#include "hal/eeprom.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;

namespace {

using core::Status;

// Effort of a call, in edges: enough for most fences to be gone round at once; the largest polygon
// takes three calls, and of circles three fit into one. To go on to another zone costs two more.
constexpr uint8_t kAtOnce = 7, kCircleEffort = 1, kZoneEffort = 2;
constexpr uint8_t kNoWayBack = 0x7F;
// Beyond it no circle reaches, and geo::offset() would work out a scale that nobody else wants.
constexpr int32_t kFarthest_e7 = 910000;

struct FenceLine {
    Line line;
    uint8_t generation;  // of the list that `line` is said of
    uint8_t way_back;    // which record
    bool zones;          // FencePoint::zone_corner or circle
};
core::FileState<FenceLine> fence_line{};
struct Lap {
    geo::Position place;
    uint8_t next;  // point, and the edge that begins there
    bool waits;    // for the EEPROM to be at rest
    bool inside;   // the present zone, as far as has been looked
};
core::FileState<Lap> lap{};

uint8_t points() { return listCount(ListKind::fence); }

// Zones are numbered by their records, without the way back's.
uint8_t zonePoints() { return static_cast<uint8_t>(points() - fenceHasWayBack()); }

Status readZone(uint8_t number, uint8_t* record) {
    const uint8_t index = number < fence_line.way_back ? number : static_cast<uint8_t>(number + 1);
    return listRead(ListKind::fence, index, record);
}

Status readCorner(uint8_t number, geo::Position& to) {
    uint8_t record[storage::kLargestRecord];
    const Status status = readZone(number, record);
    if (status == Status::ok) to = placeOf(record);
    return status;
}

// Who reads while something is being written holds the writing up for a tenth of a second, at every
// byte: many records are read only when nothing is.
bool mayRead() {
    lap.waits = !hal::eepromDrained();
    return !lap.waits;
}

// Edges of the polygon that this corner, lap.next, belongs to; ok: its last was among them.
Status goRound(const uint8_t* corner, uint8_t& effort) {
    const bool alone = fencePoint(corner) == FencePoint::corner;
    const uint8_t first = alone ? 0 : static_cast<uint8_t>(lap.next - zoneCorner(corner));
    const uint8_t end =
        static_cast<uint8_t>(first + (alone ? fenceCorners() : zoneCorners(corner)));
    geo::Position origin, to, from = placeOf(corner);
    Status status = readCorner(first, origin);
    while (effort < kAtOnce && status == Status::ok) {
        const uint8_t next = static_cast<uint8_t>(lap.next + 1);
        status = readCorner(next < end ? next : first, to);
        if (status != Status::ok) break;
        if (geo::crossesEdge(origin, from, to, lap.place)) lap.inside = !lap.inside;
        from = to;
        lap.next = next;
        ++effort;
        if (next == end) return Status::ok;
    }
    return Status::busy;
}

bool within(const uint8_t* circle) {
    const geo::Position centre = placeOf(circle);
    const int32_t up_e7 = lap.place.latitude_e7 - centre.latitude_e7;
    return up_e7 < kFarthest_e7 && up_e7 > -kFarthest_e7 &&
           geo::distance_m(centre, lap.place) < circleRadius_m(circle);
}

// The zone that begins here, or the rest of one; ok: to its end.
Status look(const uint8_t* zone, uint8_t& effort) {
    if (fencePoint(zone) != FencePoint::circle) return goRound(zone, effort);
    lap.inside = within(zone);
    effort = static_cast<uint8_t>(effort + kCircleEffort);
    ++lap.next;
    return Status::ok;
}

// Zone by zone, as far as one call goes.
Side goOn() {
    if (!mayRead()) return Side::unknown;
    for (uint8_t effort = 0; effort < kAtOnce; effort += kZoneEffort) {
        uint8_t zone[storage::kLargestRecord];
        if (readZone(lap.next, zone) != Status::ok || look(zone, effort) != Status::ok)
            return Side::unknown;
        if (lap.inside == excludes(zone)) return Side::outside;
        if (lap.next == zonePoints()) return Side::inside;
        lap.inside = false;
    }
    return Side::unknown;
}

void restart() {
    fence_line.line = Line::unknown;
    fence_line.generation = listGeneration(ListKind::fence);
    fence_line.way_back = kNoWayBack;
    fence_line.zones = false;
    lap.next = 0;
    lap.inside = true;  // here: none is blank, and no more than one the way back
}

void conclude() {
    parameters.fence_total = static_cast<int8_t>(points());
    fence_line.line = Line::unfit;
    if (lap.inside && (fence_line.zones || fenceCorners() >= 3))
        fence_line.line = fenceHasWayBack() ? Line::checking : Line::fit;
    if (points() == 0) fence_line.line = Line::none;
    lap.next = 0;
}

// What the records say by themselves.
void summary() {
    for (uint8_t n = 0; n < kAtOnce && lap.next < points(); ++n) {
        uint8_t record[storage::kLargestRecord];
        if (listRead(ListKind::fence, lap.next, record) != Status::ok) return;
        const FencePoint kind = fencePoint(record);
        const bool is_way_back = kind == FencePoint::way_back;
        if ((is_way_back && fenceHasWayBack()) || !isPlace(placeOf(record))) lap.inside = false;
        if (is_way_back) fence_line.way_back = lap.next;
        if (kind > FencePoint::way_back) fence_line.zones = true;
        ++lap.next;
    }
    if (lap.next == points()) conclude();
}

void check() {
    geo::Position place;
    if (fenceWayBack(place) != Status::ok) return;
    const Side side = fenceSide(place);
    if (side == Side::unknown) return;
    fence_line.line = side == Side::inside ? Line::fit : Line::unfit;
    if (fence_line.line == Line::unfit)
        sendStatusText(Severity::warning, STATUS_TEXT("Fence: return point is outside"));
}

}  // namespace

void fenceLineStart() { restart(); }

void fenceLineFollow() {
    lap.waits = false;
    if (!missionKnown()) return;
    if (fence_line.generation != listGeneration(ListKind::fence)) restart();
    if (fence_line.line == Line::unknown) {
        if (mayRead()) summary();
    } else if (fence_line.line == Line::checking) {
        check();
    }
}

bool fenceLineWaits() { return lap.waits; }

Line fenceLine() {
    return fence_line.generation == listGeneration(ListKind::fence) ? fence_line.line
                                                                    : Line::unknown;
}

Side fenceSide(const geo::Position& place) {
    if (lap.next == 0) {
        lap.place = place;
        lap.inside = false;
    }
    const Side side = goOn();
    if (side != Side::unknown) lap.next = 0;
    return side;
}

uint8_t fenceCorners() { return static_cast<uint8_t>(zonePoints() - fence_line.zones); }

bool fenceHasZones() { return fence_line.zones; }

bool fenceHasWayBack() { return fence_line.way_back != kNoWayBack; }

Status fenceWayBack(geo::Position& to) {
    uint8_t record[storage::kLargestRecord];
    const Status status = listRead(ListKind::fence, fence_line.way_back, record);
    if (status == Status::ok) to = placeOf(record);
    return status;
}

}  // namespace mission
}  // namespace firmware

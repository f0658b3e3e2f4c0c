// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/fence_line.hpp"

#include "firmware/parameters.hpp"
#include "firmware/points.hpp"
#include "firmware/telemetry/text.hpp"
#include "geo/polygon.hpp"

namespace firmware {
namespace {

using core::Status;

// Enough for most fences to be gone round at once; the largest take two calls.
constexpr uint8_t kEdgesAtOnce = 10;
constexpr uint8_t kNoWayBack = 0xFF;

Line line;
uint8_t generation;  // of the list that `line` is said of
uint8_t way_back;    // which record
struct {
    geo::Position place;
    uint8_t next : 7;  // edge
    bool inside : 1;   // as far as has been looked; anew when next is 0
} lap;

uint8_t points() { return listCount(ListKind::fence); }

Status readCorner(uint8_t number, geo::Position& to) {
    uint8_t record[storage::kLargestRecord];
    const uint8_t index = number < way_back ? number : static_cast<uint8_t>(number + 1);
    const Status status = listRead(ListKind::fence, index, record);
    if (status == Status::ok) to = placeOf(record);
    return status;
}

// Some of the edges; ok: that was the last.
Status goOn() {
    geo::Position origin, from, to;
    Status status = readCorner(0, origin);
    if (status == Status::ok) status = readCorner(lap.next, from);
    for (uint8_t n = 0; n < kEdgesAtOnce && status == Status::ok; ++n) {
        const uint8_t end = lap.next + 1 < fenceCorners() ? lap.next + 1 : 0;
        status = readCorner(end, to);
        if (status != Status::ok) break;
        if (geo::crossesEdge(origin, from, to, lap.place)) lap.inside = !lap.inside;
        from = to;
        lap.next = end & 0x7F;
        if (end == 0) return Status::ok;
    }
    return Status::busy;
}

// What the records say by themselves.
Status survey(Line& is) {
    uint8_t found = kNoWayBack, count = points();
    is = count == 0 ? Line::none : Line::fit;
    for (uint8_t index = 0; index < count; ++index) {
        uint8_t record[storage::kLargestRecord];
        const Status status = listRead(ListKind::fence, index, record);
        if (status != Status::ok) return status;
        const bool second = found != kNoWayBack && fencePoint(record) == FencePoint::way_back;
        if (second || !isPlace(placeOf(record))) is = Line::unfit;
        if (fencePoint(record) == FencePoint::way_back) found = index;
    }
    way_back = found;
    if (count != 0 && fenceCorners() < 3) is = Line::unfit;
    return Status::ok;
}

void examine() {
    Line is;
    if (survey(is) != Status::ok) return;
    parameters.fence_total = static_cast<int8_t>(points() == 0 ? 0 : fenceCorners() + 2);
    lap.next = 0;
    line = is == Line::fit && fenceHasWayBack() ? Line::checking : is;
    generation = listGeneration(ListKind::fence);
}

void check() {
    geo::Position place;
    if (fenceWayBack(place) != Status::ok) return;
    const Side side = fenceSide(place);
    if (side == Side::unknown) return;
    line = side == Side::inside ? Line::fit : Line::unfit;
    if (line == Line::unfit) tell(Severity::warning, ROM_TEXT("Fence: return point is outside"));
}

}  // namespace

void fenceLineStart() { line = Line::unknown; }

void fenceLineFollow() {
    if (!missionKnown()) return;
    if (line == Line::unknown || generation != listGeneration(ListKind::fence)) {
        examine();
    } else if (line == Line::checking) {
        check();
    }
}

Line fenceLine() { return generation == listGeneration(ListKind::fence) ? line : Line::unknown; }

Side fenceSide(const geo::Position& place) {
    if (lap.next == 0) {
        lap.place = place;
        lap.inside = false;
    }
    if (goOn() != Status::ok) return Side::unknown;
    return lap.inside ? Side::inside : Side::outside;
}

uint8_t fenceCorners() { return static_cast<uint8_t>(points() - (way_back == kNoWayBack ? 0 : 1)); }

bool fenceHasWayBack() { return way_back != kNoWayBack; }

Status fenceWayBack(geo::Position& to) {
    uint8_t record[storage::kLargestRecord];
    const Status status = listRead(ListKind::fence, way_back, record);
    if (status == Status::ok) to = placeOf(record);
    return status;
}

}  // namespace firmware

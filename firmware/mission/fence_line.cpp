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

// Enough for most fences to be gone round at once; the largest take three calls.
constexpr uint8_t kAtOnce = 7;
constexpr uint8_t kNoWayBack = 0xFF;

struct FenceLine {
    Line line;
    uint8_t generation;  // of the list that `line` is said of
    uint8_t way_back;    // which record
};
core::FileState<FenceLine> fence_line{};
struct Lap {
    geo::Position place;
    uint8_t next : 6;  // edge
    bool waits : 1;    // for the EEPROM to be at rest
    bool inside : 1;   // as far as has been looked; anew when next is 0
};
core::FileState<Lap> lap{};

uint8_t points() { return listCount(ListKind::fence); }

Status readCorner(uint8_t number, geo::Position& to) {
    uint8_t record[storage::kLargestRecord];
    const uint8_t index = number < fence_line.way_back ? number : static_cast<uint8_t>(number + 1);
    const Status status = listRead(ListKind::fence, index, record);
    if (status == Status::ok) to = placeOf(record);
    return status;
}

// Who reads while something is being written holds the writing up for a tenth of a second, at every
// byte: many records are read only when nothing is.
bool mayRead() {
    lap.waits = !hal::eepromDrained();
    return !lap.waits;
}

// Some of the edges; ok: that was the last.
Status goOn() {
    if (!mayRead()) return Status::busy;
    geo::Position origin, from, to;
    Status status = readCorner(0, origin);
    if (status == Status::ok) status = readCorner(lap.next, from);
    for (uint8_t n = 0; n < kAtOnce && status == Status::ok; ++n) {
        const uint8_t end = lap.next + 1 < fenceCorners() ? lap.next + 1 : 0;
        status = readCorner(end, to);
        if (status != Status::ok) break;
        if (geo::crossesEdge(origin, from, to, lap.place)) lap.inside = !lap.inside;
        from = to;
        lap.next = end & 0x3F;
        if (end == 0) return Status::ok;
    }
    return Status::busy;
}

void restart() {
    fence_line.line = Line::unknown;
    fence_line.generation = listGeneration(ListKind::fence);
    fence_line.way_back = kNoWayBack;
    lap.next = 0;
    lap.inside = true;  // here: none is blank, and no more than one the way back
}

void conclude() {
    parameters.fence_total = static_cast<int8_t>(points() == 0 ? 0 : fenceCorners() + 2);
    fence_line.line = Line::unfit;
    if (lap.inside && fenceCorners() >= 3)
        fence_line.line = fenceHasWayBack() ? Line::checking : Line::fit;
    if (points() == 0) fence_line.line = Line::none;
    lap.next = 0;
}

// What the records say by themselves.
void summary() {
    for (uint8_t n = 0; n < kAtOnce && lap.next < points(); ++n) {
        uint8_t record[storage::kLargestRecord];
        if (listRead(ListKind::fence, lap.next, record) != Status::ok) return;
        const bool is_way_back = fencePoint(record) == FencePoint::way_back;
        if ((is_way_back && fenceHasWayBack()) || !isPlace(placeOf(record))) lap.inside = false;
        if (is_way_back) fence_line.way_back = lap.next;
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
    if (goOn() != Status::ok) return Side::unknown;
    return lap.inside ? Side::inside : Side::outside;
}

uint8_t fenceCorners() {
    return static_cast<uint8_t>(points() - (fence_line.way_back == kNoWayBack ? 0 : 1));
}

bool fenceHasWayBack() { return fence_line.way_back != kNoWayBack; }

Status fenceWayBack(geo::Position& to) {
    uint8_t record[storage::kLargestRecord];
    const Status status = listRead(ListKind::fence, fence_line.way_back, record);
    if (status == Status::ok) to = placeOf(record);
    return status;
}

}  // namespace mission
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/legacy_points.hpp"

#include <stddef.h>
#include <string.h>

#include "core/maths.hpp"
#include "firmware/gcs/degrees.hpp"
#include "firmware/gcs/transfer.hpp"
#include "firmware/mission/fence_line.hpp"
#include "firmware/mission/fence_rally_items.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;
using namespace mission;
using namespace safety;

namespace {

using core::Status;

constexpr uint8_t kNoPoint = 0xFF;
constexpr uint8_t kFewestFencePoints = 5;  // a return point and a closed triangle

// The fence by its points: the return point first. bad_argument: there is no such point.
Status readPoint(ListKind kind, uint8_t index, uint8_t* record) {
    if (kind == ListKind::rally) return listRead(kind, index, record);
    const uint8_t count = listCount(kind);
    uint8_t left = index;
    for (uint8_t at = 0; at < count; ++at) {
        const Status status = listRead(kind, at, record);
        if (status != Status::ok) return status;
        const bool way_back = fencePoint(record) == FencePoint::way_back;
        if (index == 0 ? way_back : !way_back && --left == 0) return Status::ok;
    }
    return Status::bad_argument;
}

void blank(ListKind kind, uint8_t index, uint8_t* record) {
    memset(record, 0, storage::kLargestRecord);
    if (kind == ListKind::fence)
        setFencePoint(record, index == 0 ? FencePoint::way_back : FencePoint::corner);
}

// The next record of the list that is being made, changed or as it was.
MissionResult putNext(ListKind kind, uint8_t changed, const uint8_t* change) {
    const uint8_t index = listStaged();
    if (index == changed) return listPut(change);
    uint8_t record[storage::kLargestRecord];
    const Status status = readPoint(kind, index, record);
    if (status == Status::busy) return MissionResult::busy;
    if (status != Status::ok) blank(kind, index, record);
    return listPut(record);
}

MissionResult fill(ListKind kind, uint8_t changed, const uint8_t* change) {
    while (listStaging(kind) && listStaged() < listStagedCount()) {
        const MissionResult result = putNext(kind, changed, change);
        if (result != MissionResult::accepted) return result;
    }
    return listCommit();
}

// The list with one point changed. Called again with the same arguments until it is not busy.
MissionResult rewrite(uint8_t link, Peer peer, ListKind kind, uint8_t count, uint8_t changed,
                      const uint8_t* change) {
    if (transfer.state == Upload::none) {
        const MissionResult begun = listBegin(kind, count, kPointSet);
        if (begun != MissionResult::accepted) return begun;
        transfer.state = Upload::points;
        transfer.type = static_cast<uint8_t>(kind) & 3;
        transfer.link = link;
        transfer.peer = peer;
    } else if (transfer.state != Upload::points || transfer.link != link ||
               transfer.type != static_cast<uint8_t>(kind)) {
        return MissionResult::denied;
    }
    transfer.turns = 0;
    const MissionResult result = fill(kind, changed, change);
    if (result != MissionResult::busy) forgetTransfer();
    return result;
}

// True: done, well or not.
bool change(Link& link, const mavlink::Frame& frame, ListKind kind, uint8_t count, uint8_t index,
            const uint8_t* record) {
    const MissionResult result =
        othersTransfer(link, frame)
            ? MissionResult::denied
            : rewrite(linkNumber(link), peerOf(frame), kind, count, index, record);
    if (result == MissionResult::busy) return false;
    if (result != MissionResult::accepted)
        sendStatusText(Severity::warning, STATUS_TEXT("Point # not stored"), index);
    return true;
}

bool refuse(uint8_t index) {
    sendStatusText(Severity::warning, STATUS_TEXT("Point # refused"), index);
    return true;
}

// These messages cannot say what else a fence may have.
bool refuseFence(uint8_t index) {
    if (!fenceHasZones()) return refuse(index);
    sendStatusText(Severity::warning, STATUS_TEXT("Fence has zones that are no points"));
    return true;
}

// The last point of a fence has no record: it must be the first corner.
bool closes(const geo::Position& place, uint8_t index, bool& busy) {
    uint8_t record[storage::kLargestRecord];
    const Status status = readPoint(ListKind::fence, 1, record);
    busy = status == Status::busy;
    return status == Status::ok && index + 1 == parameters.fence_total && placeOf(record) == place;
}

}  // namespace

bool fenceTakesTotal(uint8_t total) { return total == 0 || total >= kFewestFencePoints; }

Status resizePoints(ListKind kind, uint8_t total) {
    const bool fence = kind == ListKind::fence;
    if (!missionKnown() || (fence && fenceLine() == Line::unknown)) return Status::busy;
    if (fence && fenceHasZones() && total > 0) {
        refuseFence(0);
        return Status::bad_argument;
    }
    const uint8_t present =
        fence && !fenceHasZones() ? static_cast<uint8_t>(parameters.fence_total) : listCount(kind);
    // the list may have been stored, and looked at, since the last call
    const bool under_way = transfer.state == Upload::points && transfer.link == kNoLink;
    if (present == total && !under_way) return Status::ok;
    if (fence && fenceOn() && !under_way) {
        sendStatusText(Severity::warning, STATUS_TEXT("The fence is on"));
        return Status::bad_argument;
    }
    const uint8_t count = fence && total > 0 ? total - 1 : total;
    switch (rewrite(kNoLink, {0, 0}, kind, count, kNoPoint, nullptr)) {
        case MissionResult::accepted:
            return Status::ok;
        case MissionResult::busy:
            return Status::busy;
        default:
            return Status::bad_argument;
    }
}

bool onFencePoint(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::FencePoint>();
    const uint8_t total = static_cast<uint8_t>(parameters.fence_total);
    const geo::Position place = {degreesE7(message.lat), degreesE7(message.lng)};
    if (fenceLine() == Line::unknown) return false;
    if (fenceOn() || message.count != total || message.idx >= total || !isPlace(place))
        return refuseFence(message.idx);
    if (message.idx + 1 == total) {
        bool busy;
        if (closes(place, message.idx, busy)) return true;
        return !busy && refuse(message.idx);
    }
    uint8_t record[storage::kLargestRecord];
    blank(ListKind::fence, message.idx, record);
    setPlace(record, place);
    return change(link, frame, ListKind::fence, static_cast<uint8_t>(total - 1), message.idx,
                  record);
}

bool onFenceFetchPoint(Link& link, const mavlink::Frame& frame) {
    const uint8_t index = frame.read<mavlink::FenceFetchPoint>().idx;
    const uint8_t total = static_cast<uint8_t>(parameters.fence_total);
    if (fenceLine() == Line::unknown) return false;
    if (index >= total) return refuseFence(index);
    uint8_t record[storage::kLargestRecord] = {};
    const Status status = readPoint(ListKind::fence, index + 1 == total ? 1 : index, record);
    if (status == Status::busy) return false;
    mavlink::FencePoint message = {};
    message.target_system = frame.system;
    message.target_component = frame.component;
    message.idx = index;
    message.count = total;
    if (status == Status::ok) {
        message.lat = degreesFromE7(placeOf(record).latitude_e7);
        message.lng = degreesFromE7(placeOf(record).longitude_e7);
    }
    return send(link, message);
}

bool onRallyPoint(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::RallyPoint>();
    const geo::Position place = {message.lat, message.lng};
    const uint8_t total = listCount(ListKind::rally);
    if (message.count != total || message.idx >= total || !isPlace(place))
        return refuse(message.idx);
    uint8_t record[storage::kLargestRecord];
    setPlace(record, place);
    setRallyHeight(record, message.alt, true);
    return change(link, frame, ListKind::rally, total, message.idx, record);
}

bool onRallyFetchPoint(Link& link, const mavlink::Frame& frame) {
    const uint8_t index = frame.read<mavlink::RallyFetchPoint>().idx;
    uint8_t record[storage::kLargestRecord];
    const Status status = readPoint(ListKind::rally, index, record);
    if (status == Status::busy) return false;
    if (status != Status::ok) return refuse(index);
    mavlink::RallyPoint message = {};
    message.lat = placeOf(record).latitude_e7;
    message.lng = placeOf(record).longitude_e7;
    message.alt = static_cast<int16_t>(core::rounded(rallyHeight_m(record)));
    message.target_system = frame.system;
    message.target_component = frame.component;
    message.idx = index;
    message.count = listCount(ListKind::rally);
    return send(link, message);
}

bool refusePoint(Link&, const mavlink::Frame& frame) {
    const bool fence = frame.id == mavlink::Wire<mavlink::FencePoint>::id;
    const uint8_t at =
        fence ? offsetof(mavlink::FencePoint, idx) : offsetof(mavlink::RallyPoint, idx);
    return refuse(at < frame.length ? frame.payload[at] : 0);
}

}  // namespace gcs
}  // namespace firmware

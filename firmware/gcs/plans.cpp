// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/plans.hpp"

#include "firmware/mission/fence_line.hpp"
#include "firmware/mission/points.hpp"
#include "mavlink/messages.hpp"

namespace firmware {
namespace gcs {

using namespace mission;

namespace {

using mavlink::MavMissionType;

static_assert(static_cast<uint8_t>(ListKind::fence) == MavMissionType::fence &&
                  static_cast<uint8_t>(ListKind::rally) == MavMissionType::rally,
              "the kinds are MAVLink's types");
ListKind kindOf(uint8_t mission_type) { return static_cast<ListKind>(mission_type); }

MissionResult keepUpTo(uint8_t index) {
    while (listStaged() < index) {
        const MissionResult result = listKeep();
        if (result != MissionResult::accepted) return result;
    }
    return MissionResult::accepted;
}

MissionResult clearOne(uint8_t type) {
    if (type == MavMissionType::mission) return missionClear();
    return listClear(kindOf(type), kPointSet);
}

MissionResult clearAll() {
    for (uint8_t type = 0; isPlan(type); ++type) {
        if (planCount(type) == 0) continue;
        const MissionResult result = clearOne(type);
        if (result != MissionResult::accepted) return result;
    }
    return MissionResult::accepted;
}

}  // namespace

bool isPlan(uint8_t mission_type) { return mission_type <= MavMissionType::rally; }

uint8_t planCount(uint8_t mission_type) {
    if (mission_type == MavMissionType::mission) return static_cast<uint8_t>(missionCount());
    return listCount(kindOf(mission_type));
}

uint32_t planId(uint8_t mission_type) {
    return isPlan(mission_type) ? listId(kindOf(mission_type)) : 0;
}

core::Status planItem(uint8_t mission_type, uint16_t index, MissionItem& to) {
    if (mission_type == MavMissionType::mission) return missionItem(index, to);
    const ListKind kind = kindOf(mission_type);
    if (kind == ListKind::fence && fenceLine() == Line::unknown) return core::Status::busy;
    if (index >= listCapacity(kind)) return core::Status::bad_argument;
    uint8_t record[storage::kLargestRecord];
    const core::Status status = listRead(kind, static_cast<uint8_t>(index), record);
    if (status == core::Status::ok) itemFromPoint(kind, record, to);
    return status;
}

MissionResult planBegin(uint8_t mission_type, uint16_t count) {
    if (mission_type == MavMissionType::mission) return missionBeginUpload(count);
    return listBegin(kindOf(mission_type), count, kPointSet);
}

MissionResult planBeginPartial(uint8_t mission_type, uint16_t first, uint16_t last) {
    if (mission_type == MavMissionType::mission) return missionBeginPartial(first, last);
    const uint8_t count = planCount(mission_type);
    if (first > last || last >= count) return MissionResult::invalid_sequence;
    return planBegin(mission_type, count);
}

MissionResult planPut(uint8_t mission_type, uint16_t index, const MissionItem& item) {
    if (mission_type == MavMissionType::mission) return missionUploadItem(index, item);
    const MissionResult reached = keepUpTo(static_cast<uint8_t>(index));
    if (reached != MissionResult::accepted) return reached;
    uint8_t record[storage::kLargestRecord];
    const MissionResult result =
        pointFromItem(kindOf(mission_type), item, listStagedCount(), record);
    return result == MissionResult::accepted ? listPut(record) : result;
}

MissionResult planCommit(uint8_t mission_type) {
    if (mission_type == MavMissionType::mission) return missionCommit();
    const ListKind kind = kindOf(mission_type);
    if (listStaging(kind)) {
        const MissionResult reached = keepUpTo(listStagedCount());
        if (reached != MissionResult::accepted) return reached;
    }
    return listCommit();
}

MissionResult planClear(uint8_t mission_type) {
    return mission_type == MavMissionType::all ? clearAll() : clearOne(mission_type);
}

}  // namespace gcs
}  // namespace firmware

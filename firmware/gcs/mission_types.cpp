// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/mission_types.hpp"

#include "core/file_state.hpp"
#include "firmware/mission/fence_line.hpp"
#include "firmware/mission/fence_rally_items.hpp"
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

core::FileState<FenceUpload> fence_upload{};

MissionResult putPoint(ListKind kind, const MissionItem& item) {
    FenceUpload upload = fence_upload;
    uint8_t record[storage::kLargestRecord];
    MissionResult result =
        pointFromItem(kind, item, listStaged(), listStagedCount(), upload, record);
    if (result == MissionResult::accepted) result = listPut(record);
    if (result == MissionResult::accepted) fence_upload = upload;
    return result;
}

// A fence's as if they were sent again, so that a new part fits to what stays.
MissionResult copyPoint(ListKind kind) {
    if (kind != ListKind::fence) return listCopy();
    MissionItem item;
    const core::Status status = readItem(static_cast<uint8_t>(kind), listStaged(), item);
    if (status == core::Status::ok) return putPoint(kind, item);
    return status == core::Status::busy ? MissionResult::busy : MissionResult::error;
}

MissionResult copyUpTo(ListKind kind, uint8_t index) {
    while (listStaged() < index) {
        const MissionResult result = copyPoint(kind);
        if (result != MissionResult::accepted) return result;
    }
    return MissionResult::accepted;
}

MissionResult clearOne(uint8_t type) {
    if (type == MavMissionType::mission) return missionClear();
    return listClear(kindOf(type), kPointSet);
}

MissionResult clearAll() {
    for (uint8_t type = 0; isMissionType(type); ++type) {
        if (itemCount(type) == 0) continue;
        const MissionResult result = clearOne(type);
        if (result != MissionResult::accepted) return result;
    }
    return MissionResult::accepted;
}

}  // namespace

bool isMissionType(uint8_t mission_type) { return mission_type <= MavMissionType::rally; }

uint8_t itemCount(uint8_t mission_type) {
    if (mission_type == MavMissionType::mission) return static_cast<uint8_t>(missionCount());
    return listCount(kindOf(mission_type));
}

uint32_t itemsId(uint8_t mission_type) {
    return isMissionType(mission_type) ? listId(kindOf(mission_type)) : 0;
}

core::Status readItem(uint8_t mission_type, uint16_t index, MissionItem& to) {
    if (mission_type == MavMissionType::mission) return missionItem(index, to);
    const ListKind kind = kindOf(mission_type);
    if (kind == ListKind::fence && fenceLine() == Line::unknown) return core::Status::busy;
    if (index >= listCapacity(kind)) return core::Status::bad_argument;
    uint8_t record[storage::kLargestRecord];
    const core::Status status = listRead(kind, static_cast<uint8_t>(index), record);
    if (status == core::Status::ok) itemFromPoint(kind, record, to);
    return status;
}

MissionResult uploadBegin(uint8_t mission_type, uint16_t count) {
    if (mission_type == MavMissionType::mission) return missionBeginUpload(count);
    fence_upload = {};
    return listBegin(kindOf(mission_type), count, kPointSet);
}

MissionResult uploadBeginPartial(uint8_t mission_type, uint16_t first, uint16_t last) {
    if (mission_type == MavMissionType::mission) return missionBeginPartial(first, last);
    const uint8_t count = itemCount(mission_type);
    if (first > last || last >= count) return MissionResult::invalid_sequence;
    return uploadBegin(mission_type, count);
}

MissionResult uploadPut(uint8_t mission_type, uint16_t index, const MissionItem& item) {
    if (mission_type == MavMissionType::mission) return missionUploadItem(index, item);
    const ListKind kind = kindOf(mission_type);
    const MissionResult reached = copyUpTo(kind, static_cast<uint8_t>(index));
    return reached == MissionResult::accepted ? putPoint(kind, item) : reached;
}

MissionResult uploadCommit(uint8_t mission_type) {
    if (mission_type == MavMissionType::mission) return missionCommit();
    const ListKind kind = kindOf(mission_type);
    if (listStaging(kind)) {
        const MissionResult reached = copyUpTo(kind, listStagedCount());
        if (reached != MissionResult::accepted) return reached;
    }
    return listCommit();
}

MissionResult clearItems(uint8_t mission_type) {
    return mission_type == MavMissionType::all ? clearAll() : clearOne(mission_type);
}

}  // namespace gcs
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// What the ground asks of the lists, and gets of the mission.
#include <stddef.h>
#include <string.h>

#include "core/file_state.hpp"
#include "firmware/gcs/degrees.hpp"
#include "firmware/gcs/mission_transfer.hpp"
#include "firmware/gcs/mission_types.hpp"
#include "firmware/gcs/transfer.hpp"
#include "firmware/notify/status_text.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace mission;

namespace {

struct ItemReport {
    uint16_t reached;
};
core::FileState<ItemReport> item_report{};

// True when the answer is complete: the item is not to be had.
bool refusedRequest(Link& link, const mavlink::Frame& frame, uint8_t type, uint16_t index,
                    core::Status& status, MissionItem& item) {
    MissionResult why = MissionResult::unsupported;
    if (isMissionType(type)) {
        status = readItem(type, index, item);
        if (status == core::Status::ok || status == core::Status::busy) return false;
        why = MissionResult::invalid_sequence;
    }
    answerAck(link, peerOf(frame), why, type);
    return true;
}

// Both kinds of item stand alike, but for the place: whole numbers in one, degrees in the other.
static_assert(sizeof(mavlink::MissionItem) == sizeof(mavlink::MissionItemInt) &&
                  offsetof(mavlink::MissionItem, x) == offsetof(mavlink::MissionItemInt, x) &&
                  offsetof(mavlink::MissionItem, seq) == offsetof(mavlink::MissionItemInt, seq) &&
                  offsetof(mavlink::MissionItem, mission_type) ==
                      offsetof(mavlink::MissionItemInt, mission_type),
              "one is written as the other");

bool giveItem(Link& link, const mavlink::Frame& frame, bool in_degrees, uint8_t type,
              uint16_t index) {
    core::Status status;
    MissionItem item;
    if (refusedRequest(link, frame, type, index, status, item)) return true;
    if (status == core::Status::busy) return false;
    mavlink::MissionItemInt message = {};
    message.target_system = frame.system;
    message.target_component = frame.component;
    message.seq = index;
    message.command = item.command;
    message.frame = item.frame;
    message.param1 = item.param1;
    message.param2 = item.param2;
    message.param3 = item.param3;
    message.param4 = item.param4;
    message.x = item.x;
    message.y = item.y;
    message.z = item.z;
    message.current =
        type == mavlink::MavMissionType::mission && index == missionCurrent() && index != 0;
    message.autocontinue = 1;
    message.mission_type = type;
    if (!in_degrees) return send(link, message);
    const float place[] = {degreesFromE7(item.x), degreesFromE7(item.y)};
    memcpy(&message.x, place, sizeof place);
    return sendAs<mavlink::MissionItem>(link, &message);
}

bool giveCount(Link& link, const mavlink::Frame& frame, uint8_t type, uint16_t count) {
    mavlink::MissionCount message = {};
    message.target_system = frame.system;
    message.target_component = frame.component;
    message.mission_type = type;
    message.count = count;
    message.opaque_id = itemsId(type);
    return send(link, message);
}

}  // namespace

bool onMissionRequestList(Link& link, const mavlink::Frame& frame) {
    const uint8_t type = frame.read<mavlink::MissionRequestList>().mission_type;
    if (!isMissionType(type))
        return answerAck(link, peerOf(frame), MissionResult::unsupported, type);
    return missionKnown() && giveCount(link, frame, type, itemCount(type));
}

// One item is simply sent; of more the number is, and they are asked for as always.
bool onMissionRequestPartialList(Link& link, const mavlink::Frame& frame) {
    const auto asked = frame.read<mavlink::MissionRequestPartialList>();
    const uint8_t type = asked.mission_type;
    if (!isMissionType(type))
        return answerAck(link, peerOf(frame), MissionResult::unsupported, type);
    if (!missionKnown()) return false;
    const int16_t count = itemCount(type);
    const int16_t last = asked.end_index < 0 ? count - 1 : asked.end_index;
    if (asked.start_index < 0 || last < asked.start_index || last >= count)
        return answerAck(link, peerOf(frame), MissionResult::invalid_sequence, type);
    const uint16_t first = static_cast<uint16_t>(asked.start_index);
    if (last == asked.start_index) return giveItem(link, frame, false, type, first);
    return giveCount(link, frame, type, static_cast<uint16_t>(last + 1 - asked.start_index));
}

// Both kinds of request stand alike, too.
bool onMissionRequest(Link& link, const mavlink::Frame& frame) {
    const auto asked = frame.read<mavlink::MissionRequest>();
    const bool in_degrees = frame.id == mavlink::Wire<mavlink::MissionRequest>::id;
    return giveItem(link, frame, in_degrees, asked.mission_type, asked.seq);
}

bool onMissionSetCurrent(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionSetCurrent>();
    // MAVSDK takes MISSION_CURRENT with another item for a lost order and sends it again, for ever
    if (missionSetCurrent(message.seq))
        requestOnce(link, mavlink::Wire<mavlink::MissionCurrent>::id);
    else
        sendStatusText(Severity::warning, STATUS_TEXT("No mission item #"),
                       static_cast<int32_t>(message.seq));
    return true;
}

bool refuseMission(Link& link, const mavlink::Frame& frame) {
    uint8_t type_at = offsetof(mavlink::MissionCount, mission_type);  // and of a request
    if (frame.id == mavlink::Wire<mavlink::MissionClearAll>::id)
        type_at = offsetof(mavlink::MissionClearAll, mission_type);
    if (frame.id <= mavlink::Wire<mavlink::MissionWritePartialList>::id)
        type_at = offsetof(mavlink::MissionWritePartialList, mission_type);
    const uint8_t type = type_at < frame.length ? frame.payload[type_at] : 0;
    return answerAck(link, peerOf(frame), MissionResult::error, type);
}

void reportReached() {
    const uint16_t id = mavlink::Wire<mavlink::MissionItemReached>::id;
    for (const Link& link : links)
        if (isDue(link, id)) return;
    if (!takeReached(item_report.reached)) return;
    for (Link& link : links) requestOnce(link, id);
}

uint16_t lastReached() { return item_report.reached; }

}  // namespace gcs
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// How a change of a list begins, and how the ground takes it back.
#include "firmware/gcs/mission_transfer.hpp"
#include "firmware/gcs/mission_types.hpp"
#include "firmware/gcs/transfer.hpp"

namespace firmware {
namespace gcs {

using namespace mission;

namespace {

// What both ways of beginning an upload have in common; `result` is the list's own answer.
bool begin(Link& link, const mavlink::Frame& frame, uint8_t type, MissionResult result,
           uint16_t first, uint16_t last) {
    if (result == MissionResult::busy) return false;
    if (result != MissionResult::accepted) return answerAck(link, peerOf(frame), result, type);
    transfer = {};
    transfer.state = Upload::items;
    transfer.type = type & 3;
    transfer.link = linkNumber(link);
    transfer.peer = peerOf(frame);
    transfer.next = static_cast<uint8_t>(first);  // no list is longer
    transfer.last = static_cast<uint8_t>(last);
    return ask();
}

// What may not begin now is answered, and that is that.
bool refusedBeginning(Link& link, const mavlink::Frame& frame, uint8_t type) {
    MissionResult why = MissionResult::denied;
    if (!isMissionType(type)) {
        why = MissionResult::unsupported;
    } else if (!othersTransfer(link, frame)) {
        return false;
    }
    answerAck(link, peerOf(frame), why, type);
    return true;
}

bool clearInstead(Link& link, const mavlink::Frame& frame, uint8_t type) {
    const MissionResult result = clearItems(type);
    return result != MissionResult::busy && answerAck(link, peerOf(frame), result, type);
}

}  // namespace

bool onMissionCount(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionCount>();
    const uint8_t type = message.mission_type;
    if (refusedBeginning(link, frame, type)) return true;
    if (transfer.state == Upload::items && isOwner(link, frame) && transfer.type == type &&
        transfer.next == 0 && transfer.last + 1U == message.count)
        return ask();  // said twice
    takeOver(link, frame);
    if (message.count == 0) return clearInstead(link, frame, type);
    return begin(link, frame, type, uploadBegin(type, message.count), 0,
                 static_cast<uint16_t>(message.count - 1));
}

bool onMissionWritePartialList(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionWritePartialList>();
    const uint8_t type = message.mission_type;
    if (refusedBeginning(link, frame, type)) return true;
    const int16_t last =
        message.end_index < 0 ? static_cast<int16_t>(itemCount(type) - 1) : message.end_index;
    if (message.start_index < 0 || last < message.start_index)
        return answerAck(link, peerOf(frame), MissionResult::invalid_sequence, type);
    takeOver(link, frame);
    const uint16_t from = static_cast<uint16_t>(message.start_index);
    const uint16_t to = static_cast<uint16_t>(last);
    return begin(link, frame, type, uploadBeginPartial(type, from, to), from, to);
}

bool onMissionAck(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionAck>();
    if (transfer.state == Upload::items && isOwner(link, frame) &&
        message.type != static_cast<uint8_t>(MissionResult::accepted))
        forgetTransfer();
    return true;
}

bool onMissionClearAll(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionClearAll>();
    const uint8_t type = message.mission_type;
    if (type != mavlink::MavMissionType::all && !isMissionType(type))
        return answerAck(link, peerOf(frame), MissionResult::unsupported, type);
    if (othersTransfer(link, frame))
        return answerAck(link, peerOf(frame), MissionResult::denied, type);
    const MissionResult result = clearItems(type);
    if (result == MissionResult::busy) return false;
    transfer.state = Upload::none;
    return answerAck(link, peerOf(frame), result, type);
}

}  // namespace gcs
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/telemetry/mission_transfer.hpp"

#include "firmware/mission/mission.hpp"
#include "firmware/modes/guided.hpp"
#include "firmware/telemetry/degrees.hpp"
#include "firmware/telemetry/link.hpp"
#include "firmware/telemetry/text.hpp"

namespace firmware {
namespace {

using mavlink::MavMissionType;

struct Peer {
    uint8_t system, component;
};
Peer peerOf(const mavlink::Frame& frame) { return {frame.system, frame.component}; }

enum class Upload : uint8_t { none, items, commit };
struct {
    Upload state;
    uint8_t link;
    Peer peer;
    bool whole_degrees;  // asks with MISSION_REQUEST, for MISSION_ITEM
    uint16_t next, last;
    uint8_t turns;  // since the last question
    uint8_t tries;
} upload;

uint16_t reached;

// A question that was lost is asked again after 0.3 s, alternately of both kinds, for 9 s: so that
// a link on which every second frame is damaged brings a long mission up, and no longer than
// MAVProxy is ready to answer.
constexpr uint8_t kAskAgainTurns = 15;
constexpr uint8_t kTries = 30;

bool acknowledge(Link& link, Peer peer, MissionResult result,
                 uint8_t mission_type = MavMissionType::mission) {
    mavlink::MissionAck message = {};
    message.target_system = peer.system;
    message.target_component = peer.component;
    message.type = static_cast<uint8_t>(result);
    message.mission_type = mission_type;
    return send(link, message);
}

template <class Message>
bool sendRequest(Link& link) {
    Message message = {};
    message.target_system = upload.peer.system;
    message.target_component = upload.peer.component;
    message.seq = upload.next;
    return send(link, message);
}

bool ask() {
    upload.turns = 0;
    Link& link = links[upload.link];
    return upload.whole_degrees ? sendRequest<mavlink::MissionRequest>(link)
                                : sendRequest<mavlink::MissionRequestInt>(link);
}

bool endUpload(MissionResult result) {
    if (!acknowledge(links[upload.link], upload.peer, result)) return false;
    if (result != MissionResult::accepted) missionAbort();
    upload.state = Upload::none;
    return true;
}

// What both ways of beginning an upload have in common; `result` is the mission's own answer.
bool begin(Link& link, const mavlink::Frame& frame, MissionResult result, uint16_t first,
           uint16_t last) {
    if (result == MissionResult::busy) return false;
    if (result != MissionResult::accepted) return acknowledge(link, peerOf(frame), result);
    const bool empty = last < first;
    upload.state = empty ? Upload::commit : Upload::items;
    upload.link = linkNumber(link);
    upload.peer = peerOf(frame);
    upload.whole_degrees = false;
    upload.next = first;
    upload.last = last;
    upload.tries = 0;
    return empty || ask();
}

bool uploadElsewhere(const Link& link) {
    return upload.state != Upload::none && upload.link != linkNumber(link);
}

// Not an item but an order: 2 is a place to fly to, 3 a height.
MissionResult guide(uint8_t current, MissionItem& item) {
    item.param3 = 0;  // an item's is no radius
    if (current == 2) return guideTo(item);
    return current == 3 ? guideToHeight(item) : MissionResult::unsupported;
}

bool takeItem(Link& link, const mavlink::Frame& frame, uint16_t index, uint8_t current,
              MissionItem& item) {
    if (current > 1) return acknowledge(link, peerOf(frame), guide(current, item));
    if (upload.state != Upload::items || upload.link != linkNumber(link))
        return upload.state == Upload::commit ||
               acknowledge(link, peerOf(frame), MissionResult::error);
    // come twice: the next has been asked for, and asking again would double all that follow
    if (index + 1 == upload.next) return true;
    if (index != upload.next) return ask();
    const MissionResult result = missionUploadItem(index, item);
    if (result == MissionResult::busy) return false;
    if (result != MissionResult::accepted) return endUpload(result);
    upload.tries = 0;
    if (upload.next == upload.last) {
        upload.state = Upload::commit;
        missionTransferTurn();
        return true;
    }
    ++upload.next;
    return ask();
}

template <class Message>
MissionItem common(const Message& from) {
    MissionItem item;
    item.command = from.command;
    item.frame = from.frame;
    item.param1 = from.param1;
    item.param2 = from.param2;
    item.param3 = from.param3;
    item.param4 = from.param4;
    item.z = from.z;
    return item;
}

template <class Message>
bool sendItem(Link& link, const mavlink::Frame& frame, uint16_t index, const MissionItem& item,
              Message& message) {
    message.target_system = frame.system;
    message.target_component = frame.component;
    message.seq = index;
    message.command = item.command;
    message.frame = item.frame;
    message.param1 = item.param1;
    message.param2 = item.param2;
    message.param3 = item.param3;
    message.param4 = item.param4;
    message.z = item.z;
    message.current = index == missionCurrent() && index != 0;
    message.autocontinue = 1;
    return send(link, message);
}

// True when the answer is complete: the item is not to be had.
bool refusedRequest(Link& link, const mavlink::Frame& frame, const mavlink::MissionRequest& asked,
                    core::Status& status, MissionItem& item) {
    if (asked.mission_type != MavMissionType::mission) {
        acknowledge(link, peerOf(frame), MissionResult::unsupported, asked.mission_type);
        return true;
    }
    status = missionItem(asked.seq, item);
    if (status == core::Status::ok || status == core::Status::busy) return false;
    acknowledge(link, peerOf(frame), MissionResult::invalid_sequence);
    return true;
}

void turnUpload() {
    if (upload.state == Upload::commit) {
        const MissionResult result = missionCommit();
        if (result == MissionResult::busy) return;
        if (!endUpload(result)) return;
        if (result == MissionResult::accepted)
            tell(Severity::info, ROM_TEXT("Mission stored: # items"),
                 static_cast<int32_t>(missionCount()));
        return;
    }
    if (++upload.turns < kAskAgainTurns) return;
    if (upload.tries >= kTries) {
        if (endUpload(MissionResult::cancelled))
            tell(Severity::warning, ROM_TEXT("Mission upload given up at item #"),
                 static_cast<int32_t>(upload.next));
        return;
    }
    upload.whole_degrees = !upload.whole_degrees;
    if (ask()) ++upload.tries;
}

void tellReached() {
    const uint16_t id = mavlink::Wire<mavlink::MissionItemReached>::id;
    for (const Link& link : links)
        if (isDue(link, id)) return;
    if (!takeReached(reached)) return;
    for (Link& link : links) requestOnce(link, id);
}

}  // namespace

bool onMissionCount(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionCount>();
    if (message.mission_type != MavMissionType::mission)
        return acknowledge(link, peerOf(frame), MissionResult::unsupported, message.mission_type);
    if (uploadElsewhere(link)) return acknowledge(link, peerOf(frame), MissionResult::denied);
    if (upload.state == Upload::items && upload.next == 0 && upload.last + 1 == message.count)
        return ask();  // said twice
    if (upload.state != Upload::none) missionAbort();
    upload.state = Upload::none;
    if (message.count == 0) {
        const MissionResult result = missionClear();
        return result != MissionResult::busy && acknowledge(link, peerOf(frame), result);
    }
    return begin(link, frame, missionBeginUpload(message.count), 0,
                 static_cast<uint16_t>(message.count - 1));
}

bool onMissionWritePartialList(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionWritePartialList>();
    if (message.mission_type != MavMissionType::mission)
        return acknowledge(link, peerOf(frame), MissionResult::unsupported, message.mission_type);
    if (uploadElsewhere(link)) return acknowledge(link, peerOf(frame), MissionResult::denied);
    const int16_t last =
        message.end_index < 0 ? static_cast<int16_t>(missionCount() - 1) : message.end_index;
    if (message.start_index < 0 || last < message.start_index)
        return acknowledge(link, peerOf(frame), MissionResult::invalid_sequence);
    if (upload.state != Upload::none) missionAbort();
    upload.state = Upload::none;
    const uint16_t from = static_cast<uint16_t>(message.start_index);
    const uint16_t to = static_cast<uint16_t>(last);
    return begin(link, frame, missionBeginPartial(from, to), from, to);
}

bool onMissionItem(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionItem>();
    MissionItem item = common(message);
    item.x = degreesE7(message.x);
    item.y = degreesE7(message.y);
    return takeItem(link, frame, message.seq, message.current, item);
}

bool onMissionItemInt(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionItemInt>();
    MissionItem item = common(message);
    item.x = message.x;
    item.y = message.y;
    return takeItem(link, frame, message.seq, message.current, item);
}

bool onMissionAck(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionAck>();
    if (upload.state != Upload::items || upload.link != linkNumber(link) ||
        message.type == static_cast<uint8_t>(MissionResult::accepted))
        return true;
    missionAbort();
    upload.state = Upload::none;
    return true;
}

bool onMissionRequestList(Link& link, const mavlink::Frame& frame) {
    const auto asked = frame.read<mavlink::MissionRequestList>();
    mavlink::MissionCount message = {};
    message.target_system = frame.system;
    message.target_component = frame.component;
    message.mission_type = asked.mission_type;
    if (!missionKnown()) return false;
    if (asked.mission_type == MavMissionType::mission) message.count = missionCount();
    return send(link, message);
}

bool onMissionRequest(Link& link, const mavlink::Frame& frame) {
    const auto asked = frame.read<mavlink::MissionRequest>();
    core::Status status;
    MissionItem item;
    if (refusedRequest(link, frame, asked, status, item)) return true;
    if (status == core::Status::busy) return false;
    mavlink::MissionItem message = {};
    message.x = degreesFromE7(item.x);
    message.y = degreesFromE7(item.y);
    return sendItem(link, frame, asked.seq, item, message);
}

bool onMissionRequestInt(Link& link, const mavlink::Frame& frame) {
    // the two requests are alike to the last byte
    const auto asked = frame.read<mavlink::MissionRequest>();
    core::Status status;
    MissionItem item;
    if (refusedRequest(link, frame, asked, status, item)) return true;
    if (status == core::Status::busy) return false;
    mavlink::MissionItemInt message = {};
    message.x = item.x;
    message.y = item.y;
    return sendItem(link, frame, asked.seq, item, message);
}

bool onMissionClearAll(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionClearAll>();
    if (message.mission_type != MavMissionType::mission &&
        message.mission_type != MavMissionType::all)
        return acknowledge(link, peerOf(frame), MissionResult::unsupported, message.mission_type);
    if (uploadElsewhere(link)) return acknowledge(link, peerOf(frame), MissionResult::denied);
    const MissionResult result = missionClear();
    if (result == MissionResult::busy) return false;
    upload.state = Upload::none;
    return acknowledge(link, peerOf(frame), result, message.mission_type);
}

bool onMissionSetCurrent(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionSetCurrent>();
    if (!missionSetCurrent(message.seq))
        tell(Severity::warning, ROM_TEXT("No mission item #"), static_cast<int32_t>(message.seq));
    requestOnce(link, mavlink::Wire<mavlink::MissionCurrent>::id);
    return true;
}

bool refuseMission(Link& link, const mavlink::Frame& frame) {
    return acknowledge(link, peerOf(frame), MissionResult::error);
}

void missionTransferStart() { upload.state = Upload::none; }

void missionTransferTurn() {
    if (upload.state != Upload::none) turnUpload();
    tellReached();
}

uint16_t lastReached() { return reached; }

}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
// Uploads, item by item.
#include "firmware/gcs/mission_transfer.hpp"

#include <string.h>

#include "firmware/gcs/degrees.hpp"
#include "firmware/gcs/mission_types.hpp"
#include "firmware/gcs/transfer.hpp"
#include "firmware/modes/guided.hpp"
#include "firmware/notify/status_text.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace mission;
using namespace modes;

core::FileState<Transfer> transfer{};

namespace {

// A question that was lost is asked again after 0.3 s, alternately of both kinds, for 9 s: so that
// a link on which every second frame is damaged brings a long mission up, and no longer than
// MAVProxy is ready to answer.
constexpr uint8_t kAskAgainTurns = 15;
constexpr uint8_t kTries = 30;

// The one in floats stands as the one in whole numbers.
bool sendRequest(Link& link) {
    mavlink::MissionRequestInt message = {};
    message.target_system = transfer.peer.system;
    message.target_component = transfer.peer.component;
    message.seq = transfer.next;
    message.mission_type = transfer.type;
    return transfer.whole_degrees ? sendAs<mavlink::MissionRequest>(link, &message)
                                  : send(link, message);
}

bool endUpload(MissionResult result) {
    if (!answerAck(links[transfer.link], transfer.peer, result, transfer.type)) return false;
    if (result != MissionResult::accepted) missionAbort();
    transfer.state = Upload::none;
    return true;
}

// Not an item but an order: 2 is a place to fly to, 3 a height.
MissionResult guide(uint8_t current, MissionItem& item) {
    item.param3 = 0;  // an item's is no radius
    if (current == 2) return guideTo(item);
    return current == 3 ? guideToHeight(item) : MissionResult::unsupported;
}

bool takeItem(Link& link, const mavlink::Frame& frame, uint16_t index, uint8_t current,
              uint8_t type, MissionItem& item) {
    if (current > 1) return answerAck(link, peerOf(frame), guide(current, item), type);
    if (othersTransfer(link, frame))
        return answerAck(link, peerOf(frame), MissionResult::denied, type);
    if (transfer.state == Upload::commit) return true;  // the last one come twice
    if (transfer.state != Upload::items || transfer.type != type)
        return answerAck(link, peerOf(frame), MissionResult::error, type);
    // come twice: the next has been asked for, and asking again would double all that follow
    if (index + 1U == transfer.next) return true;
    if (index != transfer.next) return ask();
    const MissionResult result = uploadPut(type, index, item);
    if (result == MissionResult::busy) return false;
    if (result != MissionResult::accepted) return endUpload(result);
    transfer.tries = 0;
    transfer.whole_degrees = false;
    if (transfer.next == transfer.last) {
        transfer.state = Upload::commit;
        missionTransferTick();
        return true;
    }
    ++transfer.next;
    return ask();
}

void reportStored() {
    const int32_t count = itemCount(transfer.type);
    switch (transfer.type) {
        case mavlink::MavMissionType::fence:
            return sendStatusText(Severity::info, STATUS_TEXT("Fence stored: # points"), count);
        case mavlink::MavMissionType::rally:
            return sendStatusText(Severity::info, STATUS_TEXT("Rally stored: # points"), count);
        default:
            return sendStatusText(Severity::info, STATUS_TEXT("Mission stored: # items"), count);
    }
}

void turnCommit() {
    const MissionResult result = uploadCommit(transfer.type);
    if (result == MissionResult::busy) return;
    if (endUpload(result) && result == MissionResult::accepted) reportStored();
}

void turnItems() {
    if (++transfer.turns < kAskAgainTurns) return;
    if (transfer.tries >= kTries) {
        if (endUpload(MissionResult::cancelled))
            sendStatusText(Severity::warning, STATUS_TEXT("Upload given up at item #"),
                           static_cast<int32_t>(transfer.next));
        return;
    }
    transfer.whole_degrees = !transfer.whole_degrees;
    if (ask()) ++transfer.tries;
}

}  // namespace

bool isOwner(const Link& link, const mavlink::Frame& frame) {
    return transfer.link == linkNumber(link) && transfer.peer.system == frame.system &&
           transfer.peer.component == frame.component;
}

bool answerAck(Link& link, Peer peer, MissionResult result, uint8_t mission_type) {
    mavlink::MissionAck message = {};
    message.target_system = peer.system;
    message.target_component = peer.component;
    message.type = static_cast<uint8_t>(result);
    message.mission_type = mission_type;
    if (result == MissionResult::accepted) message.opaque_id = itemsId(mission_type);
    return send(link, message);
}

bool ask() {
    transfer.turns = 0;
    return sendRequest(links[transfer.link]);
}

void forgetTransfer() {
    if (transfer.state != Upload::none) missionAbort();
    transfer.state = Upload::none;
}

void takeOver(const Link& link, const mavlink::Frame& frame) {
    if (transfer.state == Upload::items && !isOwner(link, frame))
        answerAck(links[transfer.link], transfer.peer, MissionResult::cancelled, transfer.type);
    forgetTransfer();
}

// Both kinds stand alike, but for the place: degrees in the one, whole numbers in the other.
bool onMissionItem(Link& link, const mavlink::Frame& frame) {
    const auto message = frame.read<mavlink::MissionItemInt>();
    MissionItem item;
    item.command = message.command;
    item.frame = message.frame;
    item.param1 = message.param1;
    item.param2 = message.param2;
    item.param3 = message.param3;
    item.param4 = message.param4;
    item.x = message.x;
    item.y = message.y;
    item.z = message.z;
    if (frame.id == mavlink::Wire<mavlink::MissionItem>::id) {
        float place[2];
        memcpy(place, &message.x, sizeof place);
        item.x = degreesE7(place[0]);
        item.y = degreesE7(place[1]);
    }
    return takeItem(link, frame, message.seq, message.current, message.mission_type, item);
}

void missionTransferStart() { transfer.state = Upload::none; }

void missionTransferTick() {
    switch (transfer.state) {
        case Upload::items:
            turnItems();
            break;
        case Upload::commit:
            turnCommit();
            break;
        case Upload::none:
            break;
    }
    reportReached();
}

}  // namespace gcs
}  // namespace firmware

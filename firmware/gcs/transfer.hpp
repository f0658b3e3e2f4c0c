// SPDX-License-Identifier: GPL-3.0-or-later
// The one change of a list that may be under way over the links, and whose it is. Shared by the
// files that carry out the mission protocol; nobody else's business.
#pragma once
#include "core/file_state.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/mission/mission.hpp"

namespace firmware {
namespace gcs {

struct Peer {
    uint8_t system, component;
};
inline Peer peerOf(const mavlink::Frame& frame) { return {frame.system, frame.component}; }

enum class Upload : uint8_t {
    none,
    items,   // they come one by one
    commit,  // all are here and being stored
};

struct Transfer {
    Upload state;
    uint8_t type;        // MAV_MISSION_TYPE
    bool whole_degrees;  // asks with MISSION_REQUEST, for MISSION_ITEM
    uint8_t link;
    Peer peer;
    uint8_t next, last;
    uint8_t turns;  // since the last question
    uint8_t tries;
};
extern core::FileState<Transfer> transfer;

// Questions without an answer, 0.3 s apart, after which another station may begin: nobody holds up
// the others by answering seldom.
constexpr uint8_t kPatientTries = 7;

bool isOwner(const Link& link, const mavlink::Frame& frame);
// Somebody else has a change under way, and is heard.
inline bool othersTransfer(const Link& link, const mavlink::Frame& frame) {
    const bool silent = transfer.state == Upload::items && transfer.tries >= kPatientTries;
    return transfer.state != Upload::none && !silent && !isOwner(link, frame);
}

bool ask();             // for the item that is due
void forgetTransfer();  // and what it has staged
void takeOver(const Link& link,
              const mavlink::Frame& frame);  // its owner gets MISSION_ACK, cancelled

void reportReached();

bool answerAck(Link& link, Peer peer, mission::MissionResult result, uint8_t mission_type);

}  // namespace gcs
}  // namespace firmware

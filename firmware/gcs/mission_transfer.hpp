// SPDX-License-Identifier: GPL-3.0-or-later
// The mission protocol, for the mission, the fence and the rally points: up, down, in part, clear,
// set current. https://mavlink.io/en/services/mission.html
// One upload at a time, whichever list, link or ground station; others are denied theirs. Until
// its last item has been stored the old list stays.
#pragma once
#include "mavlink/frame.hpp"

namespace firmware {
namespace gcs {

struct Link;

bool onMissionCount(Link& link, const mavlink::Frame& frame);
bool onMissionWritePartialList(Link& link, const mavlink::Frame& frame);
bool onMissionItem(Link& link, const mavlink::Frame& frame);
bool onMissionAck(Link& link, const mavlink::Frame& frame);  // the ground station gives up
bool onMissionRequestList(Link& link, const mavlink::Frame& frame);
bool onMissionRequestPartialList(Link& link, const mavlink::Frame& frame);
bool onMissionRequest(Link& link, const mavlink::Frame& frame);
bool onMissionClearAll(Link& link, const mavlink::Frame& frame);
bool onMissionSetCurrent(Link& link, const mavlink::Frame& frame);

bool refuseMission(Link& link, const mavlink::Frame& frame);  // the store stayed busy

void missionTransferStart();
void missionTransferTick();  // asks again, gives up, stores, reports what was reached
uint16_t lastReached();      // the item of MISSION_ITEM_REACHED

}  // namespace gcs
}  // namespace firmware

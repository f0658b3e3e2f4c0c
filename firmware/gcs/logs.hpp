// SPDX-License-Identifier: GPL-3.0-or-later
// The flight logs over the link: list, download, erase (LOG_REQUEST_...). One at a time, on either
// link; a log goes out as fast as the link takes it, behind the heartbeat and beside the streams.
// Data are sent on the ground only. https://ardupilot.org: logs are plain .bin files; the heads of
// the chip's pages are not part of them.
#pragma once
#include "mavlink/frame.hpp"
#include "mavlink/messages.hpp"

namespace firmware {
namespace gcs {

struct Link;

bool onLogRequestList(Link& link, const mavlink::Frame& frame);
bool onLogRequestData(Link& link, const mavlink::Frame& frame);
bool onLogErase(Link& link, const mavlink::Frame& frame);
bool onLogRequestEnd(Link& link, const mavlink::Frame& frame);

// Room for one message of a log, without its signature.
constexpr uint8_t kLogFrame = mavlink::kHeaderV2 + sizeof(mavlink::LogData) + mavlink::kChecksum;

void logsStart();
bool logsWait(const Link& link);  // something is to be sent on it
bool logsSend(Link& link);        // one step towards it; false: it has to wait

}  // namespace gcs
}  // namespace firmware

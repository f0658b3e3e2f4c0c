// SPDX-License-Identifier: GPL-3.0-or-later
// MAVLink FTP, read-only: all parameters as the file @PARAM/param.pck, which a ground station gets
// in less than half of the time of PARAM_REQUEST_LIST, and the figures of system_files.hpp as
// @SYS/tasks.txt, memory.txt and errors.txt. One session at a time. A file is read by
// ReadFile or BurstReadFile, kFtpData bytes a message or fewer if asked for (0: kFtpData); what
// follows a '?' in its path is ignored. https://mavlink.io/en/services/ftp.html
#pragma once
#include "firmware/gcs/logs.hpp"
#include "mavlink/frame.hpp"
#include "mavlink/messages.hpp"

namespace firmware {
namespace gcs {

struct Link;

// The payload of FILE_TRANSFER_PROTOCOL, without the data.
struct __attribute__((packed)) FtpHeader {
    uint8_t target_network, target_system, target_component;
    uint16_t sequence;
    uint8_t session;
    uint8_t opcode;
    uint8_t size;  // of the data; in a request to read, of those wanted
    uint8_t requested_opcode;
    uint8_t burst_complete;
    uint8_t padding;
    uint32_t offset;
};
static_assert(sizeof(FtpHeader) == 3 + 12, "as MAVLink has it");

// As much of one as the parser has room for: a path of 38 letters.
struct __attribute__((packed)) FtpRequest {
    FtpHeader header;
    uint8_t data[38];
};

// What Mission Planner asks for; MAVProxy asks for 80, QGroundControl for the 239 there can be.
constexpr uint8_t kFtpData = 110;
constexpr uint8_t kFtpFrame =
    mavlink::kHeaderV2 + sizeof(FtpHeader) + kFtpData + mavlink::kChecksum;

bool onFileTransfer(Link& link, const mavlink::Frame& frame);

bool ftpWaits(const Link& link);  // a file is being sent on it
bool ftpSend(Link& link);         // one step towards it; false: it has to wait

inline bool downloadWaits(const Link& link) { return ftpWaits(link) || logsWait(link); }

}  // namespace gcs
}  // namespace firmware

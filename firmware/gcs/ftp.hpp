// SPDX-License-Identifier: GPL-3.0-or-later
// MAVLink FTP, read-only: all parameters as the file @PARAM/param.pck, which a ground station gets
// several times faster than by PARAM_REQUEST_LIST. One session at a time. The file is read by
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

// Not longer than a message of a log, so that whatever is downloaded waits for the same room.
constexpr uint8_t kFtpData = sizeof(mavlink::LogData) - sizeof(FtpHeader);

bool onFileTransfer(Link& link, const mavlink::Frame& frame);

bool ftpWaits(const Link& link);  // a file is being sent on it
bool ftpSend(Link& link);         // one step towards it; false: it has to wait

inline bool downloadWaits(const Link& link) { return ftpWaits(link) || logsWait(link); }

}  // namespace gcs
}  // namespace firmware

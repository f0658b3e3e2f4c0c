// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/ftp.hpp"

#include <string.h>

#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/system_files.hpp"
#include "firmware/gcs/transfer.hpp"
#include "firmware/state/parameter_file.hpp"

namespace firmware {
namespace gcs {

namespace {

using mavlink::MavFtpErr;
using Opcode = mavlink::MavFtpOpcode;

struct __attribute__((packed)) Answer {
    FtpHeader header;
    uint8_t data[kFtpData];
};

enum class Sending : uint8_t { nothing, once, burst };

struct Session {
    bool open;
    uint8_t number;  // the client's choice
    uint8_t link;
    Peer peer;
    uint8_t file;  // of kPaths
    Sending sending;
    uint16_t sequence;              // of the next message
    uint16_t offset;                // of its data
    uint8_t chunk;                  // bytes at most
    parameters::FileCursor cursor;  // of the parameters
};
core::FileState<Session> session{};

// FTP is MAVLink 2's alone here, which leaves out the zeros behind the data.
constexpr mavlink::Layout kAnswer ROM = {mavlink::Wire<mavlink::FileTransferProtocol>::id,
                                         sizeof(Answer), sizeof(Answer),
                                         mavlink::Wire<mavlink::FileTransferProtocol>::crc_extra};

bool ack(Link& link, Answer& answer, uint8_t size) {
    answer.header.opcode = Opcode::ack;
    answer.header.size = size;
    return sendPayload(link, &answer, kAnswer);
}

bool nak(Link& link, Answer& answer, uint8_t error) {
    answer.header.opcode = Opcode::nak;
    answer.header.size = 1;
    answer.data[0] = error;
    return sendPayload(link, &answer, kAnswer);
}

Answer answerTo(const FtpHeader& asked, Peer peer) {
    Answer answer = {};
    answer.header = asked;
    answer.header.target_system = peer.system;
    answer.header.target_component = peer.component;
    answer.header.requested_opcode = asked.opcode;
    ++answer.header.sequence;
    return answer;
}

// The last ones are those of SystemFile, in its order.
constexpr char kPaths[][17] ROM = {"@PARAM/param.pck", "@SYS/tasks.txt", "@SYS/memory.txt",
                                   "@SYS/errors.txt"};
constexpr uint8_t kParameters = 0, kFirstSystemFile = 1;

bool isPath(const char (&in_flash)[17], const uint8_t* path, uint8_t size) {
    uint8_t i = 0;
    for (; i < size && path[i] != 0 && path[i] != '?'; ++i)
        if (core::romRead(in_flash[i]) != static_cast<char>(path[i])) return false;
    return core::romRead(in_flash[i]) == 0;
}

// core::count(kPaths): there is none.
uint8_t findFile(const uint8_t* path, uint8_t size) {
    uint8_t file = 0;
    while (file < core::count(kPaths) && !isPath(kPaths[file], path, size)) ++file;
    return file;
}

SystemFile systemFile(uint8_t file) { return static_cast<SystemFile>(file - kFirstSystemFile); }

uint16_t fileSize() {
    return session.file == kParameters ? state::parameterFileSize()
                                       : systemFileSize(systemFile(session.file));
}

// busy: call again.
core::Status readFile(uint8_t* to, uint8_t& size) {
    if (session.file == kParameters)
        return state::parameterFileRead(session.cursor, session.offset, to, size);
    size = systemFileRead(systemFile(session.file), session.offset, to, size);
    return core::Status::ok;
}

bool open(Link& link, const FtpRequest& asked, Peer peer, Answer& answer) {
    const uint8_t file = findFile(asked.data, asked.header.size);
    if (file == core::count(kPaths)) return nak(link, answer, MavFtpErr::filenotfound);
    if (session.sending != Sending::nothing && session.link != linkNumber(link))
        return nak(link, answer, MavFtpErr::nosessionsavailable);
    session = {};
    session.open = true;
    session.number = asked.header.session;
    session.link = linkNumber(link);
    session.peer = peer;
    session.file = file;
    const uint32_t size = fileSize();
    memcpy(answer.data, &size, sizeof size);
    return ack(link, answer, sizeof size);
}

bool beginToSend(Link& link, const FtpHeader& asked, Answer& answer) {
    if (!session.open || session.number != asked.session || session.link != linkNumber(link))
        return nak(link, answer, MavFtpErr::invalidsession);
    if (asked.offset >= fileSize()) return nak(link, answer, MavFtpErr::eof);
    session.sequence = answer.header.sequence;
    session.offset = static_cast<uint16_t>(asked.offset);
    session.chunk = asked.size == 0 || asked.size > kFtpData ? kFtpData : asked.size;
    session.sending = asked.opcode == Opcode::readfile ? Sending::once : Sending::burst;
    return true;
}

}  // namespace

bool onFileTransfer(Link& link, const mavlink::Frame& frame) {
    FtpRequest asked;
    frame.copyPayload(&asked, sizeof asked);
    const Peer peer = peerOf(frame);
    Answer answer = answerTo(asked.header, peer);
    switch (asked.header.opcode) {
        case Opcode::openfilero:
            return open(link, asked, peer, answer);
        case Opcode::readfile:
        case Opcode::burstreadfile:
            return beginToSend(link, asked.header, answer);
        case Opcode::terminatesession:
        case Opcode::resetsession:
            if (session.link == linkNumber(link)) session = {};
            return ack(link, answer, 0);
        default:
            return nak(link, answer, MavFtpErr::unknowncommand);
    }
}

bool ftpWaits(const Link& link) {
    return session.sending != Sending::nothing && session.link == linkNumber(link);
}

// Inlined, its message burdens every look whether a file waits, as that of logsSend() would.
__attribute__((noinline)) bool ftpSend(Link& link) {
    if (!ftpWaits(link) || !hasRoom(link, signedSize(link, kFtpFrame))) return false;
    if (link.framing != mavlink::Framing::v2) {  // opened anew, for somebody else
        session = {};
        return false;
    }
    FtpHeader asked = {};
    asked.sequence = static_cast<uint16_t>(session.sequence - 1);
    asked.session = session.number;
    asked.offset = session.offset;
    const bool burst = session.sending == Sending::burst;
    asked.opcode = burst ? Opcode::burstreadfile : Opcode::readfile;
    Answer answer = answerTo(asked, session.peer);
    uint8_t size = session.chunk;
    if (readFile(answer.data, size) != core::Status::ok)
        return true;  // it is nearer by some entries
    if (!burst || size == 0) session.sending = Sending::nothing;
    ++session.sequence;
    session.offset = static_cast<uint16_t>(session.offset + size);
    return size == 0 ? nak(link, answer, MavFtpErr::eof) : ack(link, answer, size);
}

}  // namespace gcs
}  // namespace firmware

// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/telemetry/logs.hpp"

#include <string.h>

#include "firmware/log/log.hpp"
#include "firmware/log/records.hpp"
#include "firmware/telemetry/link.hpp"
#include "firmware/telemetry/text.hpp"
#include "firmware/vehicle.hpp"
#include "hal/clock.hpp"
#include "logging/reader.hpp"

namespace firmware {
namespace {

using core::Status;
using mavlink::LogData;
using mavlink::LogEntry;

enum class Doing : uint8_t { nothing, list, measure, data };

constexpr logging::Formats kFormatsInFront = {kFormatTable, kFormats};

Doing doing;
uint8_t to_link;
bool shorter;  // the log ends before what was asked for
logging::Reader reader;
uint32_t offset;  // of the next byte
uint32_t left;    // bytes; of a list: the last log

bool anyLogs() { return flight_logs.ready() && !flight_logs.erasing() && flight_logs.last() != 0; }

void begin(const Link& link, Doing what, uint16_t log) {
    doing = what;
    to_link = linkNumber(link);
    reader.open(flight_logs, log);
}

bool sendEnd(Link& link, uint16_t log, uint32_t at) {
    LogData message = {};
    message.id = log;
    message.ofs = at;
    return send(link, message);
}

bool listStep(Link& link) {
    uint32_t size = 0;
    logging::Key oldest;
    const Status status = reader.size(flight_logs, kFormatsInFront, size);
    if (status == Status::busy || logging::oldestKey(flight_logs, oldest) != Status::ok)
        return false;
    LogEntry entry = {};
    entry.size = size;
    entry.id = reader.log();
    entry.last_log_num = flight_logs.last();
    entry.num_logs = static_cast<uint16_t>(entry.last_log_num - oldest.log + 1);
    const bool sent = send(link, entry);
    const bool more = entry.id < static_cast<uint16_t>(left);
    reader.open(flight_logs, static_cast<uint16_t>(entry.id + (sent && more ? 1 : 0)));
    if (sent && !more) doing = Doing::nothing;
    return sent;
}

bool measureStep() {
    uint32_t size = 0;
    const Status status = reader.size(flight_logs, kFormatsInFront, size);
    if (status == Status::busy) return false;
    const uint32_t rest = offset < size ? size - offset : 0;
    shorter = left > rest;
    if (shorter) left = rest;
    doing = Doing::data;
    return true;
}

// A message is filled up over the end of a page: one that is not full is the last.
bool dataStep(Link& link) {
    LogData message;
    message.id = reader.log();
    message.ofs = offset;
    message.count = 0;
    while (message.count < sizeof message.data && message.count < left) {
        const uint32_t rest = left - message.count;
        uint8_t size = sizeof message.data - message.count;
        if (size > rest) size = static_cast<uint8_t>(rest);
        if (reader.read(flight_logs, kFormatsInFront, offset + message.count,
                        message.data + message.count, size) != Status::ok)
            return false;
        message.count += size;
    }
    memset(message.data + message.count, 0, sizeof message.data - message.count);
    if (!send(link, message)) return false;
    offset += message.count;
    left -= message.count;
    if (left == 0 && !(shorter && message.count == sizeof message.data)) doing = Doing::nothing;
    return true;
}

// A radio that is slowed down gets its share of the time.
bool mayTalk(const Link& link) {
    return static_cast<uint8_t>(hal::now_ms()) % 100 >= link.slowdown_pct;
}

}  // namespace

void logsStart() { doing = Doing::nothing; }

bool onLogRequestList(Link& link, const mavlink::Frame& frame) {
    const auto asked = frame.read<mavlink::LogRequestList>();
    if (!flight_logs.ready() && flight_logs.usable()) return false;  // being looked for
    logging::Key oldest = {};
    const Status status = anyLogs() ? logging::oldestKey(flight_logs, oldest) : Status::corrupt;
    if (status == Status::busy) return false;
    const uint16_t last = flight_logs.last();
    const uint16_t first = asked.start > oldest.log ? asked.start : oldest.log;
    left = asked.end < last ? asked.end : last;
    if (status != Status::ok || first > left) {
        const LogEntry none = {};
        return send(link, none);
    }
    begin(link, Doing::list, first);
    return true;
}

bool onLogRequestData(Link& link, const mavlink::Frame& frame) {
    const auto asked = frame.read<mavlink::LogRequestData>();
    if (vehicle.armed) {
        tell(Severity::notice, ROM_TEXT("Logs are sent when disarmed"));
        return sendEnd(link, asked.id, asked.ofs);
    }
    logPause(true);
    if (flight_logs.writing()) return false;  // ends first
    if (!anyLogs()) return sendEnd(link, asked.id, asked.ofs);
    offset = asked.ofs;
    left = asked.count;
    begin(link, Doing::measure, asked.id);
    return true;
}

bool onLogErase(Link&, const mavlink::Frame&) {
    doing = Doing::nothing;
    logErase();
    return true;
}

bool onLogRequestEnd(Link&, const mavlink::Frame&) {
    doing = Doing::nothing;
    logPause(false);
    return true;
}

bool logsWait(const Link& link) { return doing != Doing::nothing && to_link == linkNumber(link); }

bool logsSend(Link& link) {
    if (!logsWait(link) || !mayTalk(link) || !hasRoom(link, kLogFrame)) return false;
    if (doing != Doing::list && vehicle.armed) doing = Doing::nothing;
    switch (doing) {
        case Doing::list:
            return listStep(link);
        case Doing::measure:
            return measureStep();
        case Doing::data:
            return dataStep(link);
        default:
            return false;
    }
}

}  // namespace firmware

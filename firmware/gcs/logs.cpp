// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/logs.hpp"

#include <string.h>

#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/gcs/gps_time.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/logger/log.hpp"
#include "firmware/logger/records.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"
#include "logging/reader.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;
using namespace logger;

namespace {

using core::Status;
using mavlink::LogData;
using mavlink::LogEntry;

enum class Doing : uint8_t { nothing, list, date, measure, data };

constexpr logging::Formats kFormatsInFront = {spellFormat, kFormats};

struct Download {
    Doing doing;
    uint8_t to_link;
    bool shorter;  // the log ends before what was asked for
    logging::Reader reader;
    uint32_t offset;    // of the next byte; of a list: the log's size
    uint32_t left;      // bytes; of a list: the last log
    uint16_t searched;  // of a list: the log's bytes in which there was no date
};
core::FileState<Download> download{};

bool anyLogs() { return flight_logs.ready() && !flight_logs.erasing() && flight_logs.last() != 0; }

void begin(const Link& link, Doing what, uint16_t log) {
    download.doing = what;
    download.to_link = linkNumber(link);
    download.reader.open(flight_logs, log);
}

bool sendEnd(Link& link, uint16_t log, uint32_t at) {
    LogData message = {};
    message.id = log;
    message.ofs = at;
    return send(link, message);
}

bool sizeStep() {
    download.offset = 0;
    if (download.reader.size(flight_logs, kFormatsInFront, download.offset) == Status::busy)
        return false;
    download.searched = kFormats * sizeof(logging::FormatRecord);
    download.doing = Doing::date;
    return true;
}

bool entryStep(Link& link, uint32_t time_utc) {
    logging::Key oldest;
    if (logging::oldestKey(flight_logs, oldest) != Status::ok) return false;
    LogEntry entry = {};
    entry.time_utc = time_utc;
    entry.size = download.offset;
    entry.id = download.reader.log();
    entry.last_log_num = flight_logs.last();
    const bool round = entry.last_log_num < oldest.log;  // no log has number 0
    entry.num_logs = static_cast<uint16_t>(entry.last_log_num - oldest.log + 1 - round);
    if (!send(link, entry)) return false;
    const bool more = entry.id != static_cast<uint16_t>(download.left);
    download.doing = more ? Doing::list : Doing::nothing;
    download.reader.open(flight_logs, more ? logging::following(entry.id) : entry.id);
    return true;
}

// 0: not a record.
uint8_t lengthOf(const logging::RecordHead& head) {
    if (head.head1 != logging::kHead1 || head.head2 != logging::kHead2) return 0;
    return lengthOfRecord(head.type);
}

// Of a record with the time that a receiver sent.
uint32_t utc_s(const GpsRecord& record) {
    if (record.head.type != static_cast<uint8_t>(RecordType::gps) || record.week == 0) return 0;
    return weekBegan_utc_s(record.week) + record.time_ms / 1000;
}

// A record each call, until one has the date or the log's beginning is over.
bool dateStep(Link& link) {
    constexpr uint16_t kBeginning = 8000;
    if (download.searched >= kBeginning || download.searched >= download.offset)
        return entryStep(link, 0);
    GpsRecord record = {};
    uint8_t size = sizeof record;
    const Status status = download.reader.read(flight_logs, kFormatsInFront, download.searched,
                                               reinterpret_cast<uint8_t*>(&record), size);
    if (status == Status::busy) return false;
    const uint8_t length = status == Status::ok ? lengthOf(record.head) : 0;
    const uint32_t time_utc = utc_s(record);
    if (length == 0 || time_utc != 0) return entryStep(link, time_utc);
    download.searched += length;
    return true;
}

bool measureStep() {
    uint32_t size = 0;
    const Status status = download.reader.size(flight_logs, kFormatsInFront, size);
    if (status == Status::busy) return false;
    const uint32_t rest = download.offset < size ? size - download.offset : 0;
    download.shorter = download.left > rest;
    if (download.shorter) download.left = rest;
    download.doing = Doing::data;
    return true;
}

// A message is filled up over the end of a page: one that is not full is the last.
bool dataStep(Link& link) {
    LogData message;
    message.id = download.reader.log();
    message.ofs = download.offset;
    message.count = 0;
    while (message.count < sizeof message.data && message.count < download.left) {
        const uint32_t rest = download.left - message.count;
        uint8_t size = sizeof message.data - message.count;
        if (size > rest) size = static_cast<uint8_t>(rest);
        if (download.reader.read(flight_logs, kFormatsInFront, download.offset + message.count,
                                 message.data + message.count, size) != Status::ok)
            return false;
        message.count += size;
    }
    memset(message.data + message.count, 0, sizeof message.data - message.count);
    if (!send(link, message)) return false;
    download.offset += message.count;
    download.left -= message.count;
    if (download.left == 0 && !(download.shorter && message.count == sizeof message.data))
        download.doing = Doing::nothing;
    return true;
}

// A radio that is slowed down gets its share of the time.
bool mayTalk(const Link& link) {
    return static_cast<uint8_t>(hal::now_ms()) % 100 >= link.slowdown_pct;
}

// The first one to be listed; the last one is in download.left. 0: none. While the numbers have
// gone round, from 65535 to 1, all are listed or the one that is asked for.
uint16_t chooseListed(const mavlink::LogRequestList& asked, uint16_t oldest, uint16_t last) {
    download.left = last;
    if (oldest > last && asked.start != asked.end) return oldest;
    if (asked.end < last || oldest > last) download.left = asked.end;
    const uint16_t first = asked.start > oldest || oldest > last ? asked.start : oldest;
    const bool is_there = oldest > last ? first >= oldest || first <= last : first <= download.left;
    return is_there ? first : 0;
}

}  // namespace

void logsStart() { download.doing = Doing::nothing; }

bool onLogRequestList(Link& link, const mavlink::Frame& frame) {
    const auto asked = frame.read<mavlink::LogRequestList>();
    if (!flight_logs.ready() && flight_logs.usable()) return false;  // being looked for
    logging::Key oldest = {};
    const Status status = anyLogs() ? logging::oldestKey(flight_logs, oldest) : Status::corrupt;
    if (status == Status::busy) return false;
    const uint16_t first =
        status == Status::ok ? chooseListed(asked, oldest.log, flight_logs.last()) : 0;
    if (first == 0) {
        const LogEntry none = {};
        return send(link, none);
    }
    begin(link, Doing::list, first);
    return true;
}

bool onLogRequestData(Link& link, const mavlink::Frame& frame) {
    const auto asked = frame.read<mavlink::LogRequestData>();
    if (vehicle.armed) {
        sendStatusText(Severity::notice, STATUS_TEXT("Logs are sent when disarmed"));
        return sendEnd(link, asked.id, asked.ofs);
    }
    logPause(true);
    if (flight_logs.writing()) return false;  // ends first
    if (!anyLogs()) return sendEnd(link, asked.id, asked.ofs);
    download.offset = asked.ofs;
    download.left = asked.count;
    begin(link, Doing::measure, asked.id);
    return true;
}

bool onLogErase(Link&, const mavlink::Frame&) {
    download.doing = Doing::nothing;
    logErase();
    return true;
}

bool onLogRequestEnd(Link&, const mavlink::Frame&) {
    download.doing = Doing::nothing;
    logPause(false);
    return true;
}

bool logsWait(const Link& link) {
    return download.doing != Doing::nothing && download.to_link == linkNumber(link);
}

// Inlined, its record burdens every look whether a log waits: 0.22 % of the processor.
__attribute__((noinline)) bool logsSend(Link& link) {
    if (!logsWait(link) || !mayTalk(link) || !hasRoom(link, signedSize(link, kLogFrame)))
        return false;
    if (download.doing > Doing::date && vehicle.armed) download.doing = Doing::nothing;
    switch (download.doing) {
        case Doing::list:
            return sizeStep();
        case Doing::date:
            return dateStep(link);
        case Doing::measure:
            return measureStep();
        case Doing::data:
            return dataStep(link);
        default:
            return false;
    }
}

}  // namespace gcs
}  // namespace firmware

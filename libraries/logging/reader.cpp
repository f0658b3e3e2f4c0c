// SPDX-License-Identifier: GPL-3.0-or-later
#include "logging/reader.hpp"

#include <string.h>

namespace logging {

using core::Status;

namespace {

uint32_t sizeOf(const Formats& formats) {
    return static_cast<uint32_t>(formats.count * sizeof(FormatRecord));
}

// As much of one FMT record as there is from `at` on.
uint8_t copyFormat(const Formats& formats, uint16_t at, uint8_t* to, uint8_t size) {
    const uint8_t within = static_cast<uint8_t>(at % sizeof(FormatRecord));
    FormatRecord record = {{kHead1, kHead2, kFormatType}, {}};
    formats.spell(static_cast<uint8_t>(at / sizeof(FormatRecord)), record.format);
    const uint8_t rest = static_cast<uint8_t>(sizeof record - within);
    if (size > rest) size = rest;
    memcpy(to, reinterpret_cast<const uint8_t*>(&record) + within, size);
    return size;
}

// Damaged pages in a row that are skipped.
constexpr uint8_t kSpoilt = 2;

bool holds(const PageHead& head, const Key& key) {
    return head.key.log == key.log && key.offset >= head.key.offset &&
           key.offset - head.key.offset < head.used;
}

}  // namespace

Status oldestKey(const LogStore& store, Key& key) {
    PageHead head;
    Status status = Status::corrupt;
    for (uint8_t page = 0; page <= kSpoilt && status == Status::corrupt; ++page)
        status = store.readHead(page, head);
    key = head.key;
    return status;
}

// Of the beginning of this log.
Status Reader::missing(const LogStore& store, uint32_t& bytes) const {
    Key key;
    const Status status = oldestKey(store, key);
    bytes = key.log == log_ ? key.offset : 0;
    return status;
}

Status Reader::size(const LogStore& store, const Formats& formats, uint32_t& bytes) {
    Status status = store.seek({log_, UINT32_MAX}, found_);
    if (status != Status::ok) return status;
    PageHead head;
    uint32_t cut;
    status = store.readHead(found_.first, head);
    if (status == Status::ok) status = missing(store, cut);
    if (status != Status::ok) return status;
    if (head.key.log != log_) return Status::corrupt;
    bytes = head.key.offset + head.used - cut + (cut > 0 ? sizeOf(formats) : 0);
    open(store, log_);
    return Status::ok;
}

// The page that holds this byte, or, where it is lost, the last before it.
Status Reader::findPage(const LogStore& store, uint32_t offset, PageHead& head) {
    const Key key = {log_, offset};
    Status status = store.seek(key, found_);
    if (status != Status::ok) return status;
    status = store.readHead(found_.first, head);
    if (status == Status::busy || (status == Status::ok && holds(head, key))) return status;
    PageHead after;
    Status next = Status::corrupt;
    uint16_t page = found_.first;
    while (next == Status::corrupt && ++page < store.pages() && page <= found_.first + kSpoilt + 1)
        next = store.readHead(page, after);
    if (next == Status::busy) return next;
    if (next == Status::ok && holds(after, key)) {
        found_ = {page, static_cast<uint16_t>(page + 1)};
        head = after;
        return Status::ok;
    }
    // neither: lost, unless this is the page of an earlier question
    const bool lies_between = status == Status::ok && !before(key, head.key) &&
                              (next != Status::ok || before(key, after.key));
    if (lies_between && head.key.log == log_) return Status::ok;
    open(store, log_);
    return Status::busy;
}

Status Reader::read(const LogStore& store, const Formats& formats, uint32_t at, uint8_t* to,
                    uint8_t& size) {
    uint32_t cut;
    Status status = missing(store, cut);
    if (status != Status::ok) return status;
    if (cut > 0) {
        if (at < sizeOf(formats)) {
            size = copyFormat(formats, static_cast<uint16_t>(at), to, size);
            return Status::ok;
        }
        at += cut - sizeOf(formats);
    }
    PageHead head;
    status = findPage(store, at, head);
    if (status != Status::ok) return status;
    const uint32_t from = at - head.key.offset;
    if (from >= head.used) {
        memset(to, 0, size);
        return Status::ok;
    }
    const uint16_t rest = head.used - static_cast<uint16_t>(from);
    if (size > rest) size = static_cast<uint8_t>(rest);
    return store.read(found_.first, static_cast<uint16_t>(from), to, size);
}

}  // namespace logging

// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/mission_store.hpp"

#include <string.h>

#include "core/crc.hpp"
#include "storage/bytes.hpp"

namespace storage {
namespace {

using core::Status;

constexpr uint8_t kHeadMark = 0x4D;
constexpr uint8_t kCheckedPerCall = 16;
constexpr uint8_t kNothing = 0xFF;

// A head: mark, layout version, sequence, first slot, count, set, spare, CRC of the records, spare,
// CRC of the head.
enum Offset : uint8_t {
    kMarkAt = 0,
    kVersionAt = 1,
    kSequenceAt = 2,
    kFirstAt = 4,
    kCountAt = 5,
    kSetAt = 6,
    kRecordsCrcAt = 8,
    kHeadCrcAt = kMissionHeadSize - 2,
};

uint16_t headAddress(uint8_t place) {
    return static_cast<uint16_t>(kMissionHead.begin + place * kMissionHeadSize);
}

bool allOnes(const uint8_t* bytes, uint8_t size) {
    while (size-- > 0)
        if (*bytes++ != 0xFF) return false;
    return true;
}

uint8_t wrapped(uint16_t slot) {
    return static_cast<uint8_t>(slot < kRecordSlots ? slot : slot - kRecordSlots);
}

bool newer(uint16_t a, uint16_t b) { return static_cast<int16_t>(a - b) > 0; }

}  // namespace

Status MissionStore::readSlot(const Extent& extent, uint8_t index, uint8_t* to) {
    if (index >= extent.count) return Status::bad_argument;
    const uint8_t slot = wrapped(static_cast<uint16_t>(extent.first + index));
    return hal::eepromRead(recordAddress(slot), to, kRecordSize);
}

// An unreadable head is given back as an extent of set 0.
Status MissionStore::readHead(uint8_t place, Extent& extent, bool& blank) {
    uint8_t head[kMissionHeadSize];
    const Status status = hal::eepromRead(headAddress(place), head, sizeof head);
    if (status != Status::ok) return status;
    blank = allOnes(head, sizeof head);
    extent = {head[kFirstAt], head[kCountAt], head[kSetAt], get16(head + kSequenceAt),
              get16(head + kRecordsCrcAt)};
    const bool whole = head[kMarkAt] == kHeadMark && head[kVersionAt] == kLayoutVersion &&
                       extent.first < kRecordSlots && extent.count <= kRecordSlots &&
                       get16(head + kHeadCrcAt) == core::crc16(core::kCrcStart, head, kHeadCrcAt);
    if (!whole) extent.set = 0;
    return Status::ok;
}

// Leaves the newer head in staged_ and the older, when there is one, in previous_.
Status MissionStore::findHeads() {
    Extent heads[2];
    bool blank[2];
    for (uint8_t i = 0; i < 2; ++i) {
        const Status status = readHead(i, heads[i], blank[i]);
        if (status != Status::ok) return status;
    }
    const bool both = heads[0].set != 0 && heads[1].set != 0;
    if (heads[0].set == 0 && heads[1].set == 0) {
        settleOn(Extent{});
        return blank[0] && blank[1] ? Status::ok : Status::corrupt;
    }
    place_ = both ? newer(heads[1].sequence, heads[0].sequence) : heads[0].set == 0;
    static_cast<Extent&>(staged_) = heads[place_];
    previous_ = heads[1 - place_];
    other_waits_ = both;
    checked_ = 0;
    crc_ = core::kCrcStart;
    phase_ = Phase::checking;
    return Status::busy;
}

// Sums the records of an extent, a few each call; ok when all are.
Status MissionStore::check(const Extent& extent, bool& matches) {
    for (uint8_t n = 0; n < kCheckedPerCall && checked_ < extent.count; ++n, ++checked_) {
        uint8_t record[kRecordSize];
        const Status status = readSlot(extent, checked_, record);
        if (status != Status::ok) return status;
        crc_ = core::crc16(crc_, record, sizeof record);
    }
    if (checked_ < extent.count) return Status::busy;
    matches = crc_ == extent.crc;
    return Status::ok;
}

Status MissionStore::fallBack() {
    if (!other_waits_) {
        // numbers go on from the head that failed, so that the next one is newer than both
        Extent empty = {};
        empty.sequence = staged_.sequence;
        settleOn(empty);
        return Status::corrupt;
    }
    other_waits_ = false;
    static_cast<Extent&>(staged_) = previous_;
    place_ = 1 - place_;
    checked_ = 0;
    crc_ = core::kCrcStart;
    return Status::busy;
}

Status MissionStore::open() {
    if (phase_ == Phase::closed) {
        const Status status = findHeads();
        if (status != Status::busy) return status;
        if (phase_ == Phase::closed) return Status::busy;
    }
    if (phase_ != Phase::checking) return Status::ok;
    bool matches = false;
    const Status status = check(staged_, matches);
    if (status != Status::ok) return status;
    if (!matches) return fallBack();
    settleOn(staged_);
    return Status::ok;
}

void MissionStore::settleOn(const Extent& extent) {
    previous_ = present_;
    present_ = extent;
    for (Ahead& ahead : ahead_) ahead.index = kNothing;
    phase_ = Phase::idle;
}

Status MissionStore::read(uint8_t index, uint8_t* to) {
    if (index >= present_.count) return Status::bad_argument;
    for (const Ahead& ahead : ahead_) {
        if (ahead.index != index) continue;
        memcpy(to, ahead.record, kRecordSize);
        return Status::ok;
    }
    return readSlot(present_, index, to);
}

void MissionStore::readAhead(uint8_t index) {
    for (uint8_t i = 0; i < kAheads; ++i, ++index) {
        if (index >= present_.count) return;
        Ahead& ahead = ahead_[index % kAheads];
        if (ahead.index == index) continue;
        uint8_t record[kRecordSize];
        if (readSlot(present_, index, record) != Status::ok) return;
        memcpy(ahead.record, record, sizeof record);
        ahead.index = index;
    }
}

Status MissionStore::begin(uint8_t count, uint8_t set) {
    if (phase_ == Phase::filling) abort();
    if (phase_ != Phase::idle) return Status::busy;
    if (set == 0) return Status::bad_argument;
    if (count > kRecordSlots - present_.count) return Status::full;
    staged_.first = wrapped(static_cast<uint16_t>(present_.first + present_.count));
    staged_.count = count;
    staged_.set = set;
    staged_.sequence = static_cast<uint16_t>(present_.sequence + 1);
    staged_.crc = core::kCrcStart;
    staged_.put = 0;
    previous_.count = 0;
    phase_ = Phase::filling;
    return Status::ok;
}

Status MissionStore::put(const uint8_t* record) {
    if (phase_ != Phase::filling || staged_.put >= staged_.count) return Status::bad_argument;
    const uint8_t slot = wrapped(static_cast<uint16_t>(staged_.first + staged_.put));
    const Status status = hal::eepromWrite(recordAddress(slot), record, kRecordSize);
    if (status != Status::ok) return status;
    staged_.crc = core::crc16(staged_.crc, record, kRecordSize);
    ++staged_.put;
    return Status::ok;
}

Status MissionStore::copy() {
    uint8_t record[kRecordSize];
    const Status status = read(staged_.put, record);
    return status == Status::ok ? put(record) : status;
}

Status MissionStore::readStaged(uint8_t index, uint8_t* to) {
    if (phase_ == Phase::idle || index >= staged_.put) return Status::bad_argument;
    return readSlot(staged_, index, to);
}

Status MissionStore::readPrevious(uint8_t index, uint8_t* to) {
    return readSlot(previous_, index, to);
}

void MissionStore::abort() {
    if (phase_ > Phase::idle && phase_ < Phase::heading) phase_ = Phase::idle;
}

Status MissionStore::commit() {
    if (phase_ == Phase::filling) {
        if (staged_.put != staged_.count) return Status::bad_argument;
        phase_ = Phase::draining;
    }
    if (phase_ == Phase::draining) {
        if (!hal::eepromDrained()) return Status::busy;
        checked_ = 0;
        crc_ = core::kCrcStart;
        phase_ = Phase::verifying;
    }
    if (phase_ == Phase::verifying) {
        bool matches = false;
        const Status status = check(staged_, matches);
        if (status != Status::ok) return status;
        if (!matches) {
            phase_ = Phase::idle;
            return Status::corrupt;
        }
        return writeHead();
    }
    if (phase_ != Phase::heading) return Status::bad_argument;
    if (!hal::eepromDrained()) return Status::busy;
    place_ = 1 - place_;
    settleOn(staged_);
    return Status::ok;
}

// The one write that makes the staged mission the present one; it goes over the older head.
Status MissionStore::writeHead() {
    uint8_t head[kMissionHeadSize];
    memset(head, 0, sizeof head);
    head[kMarkAt] = kHeadMark;
    head[kVersionAt] = kLayoutVersion;
    put16(head + kSequenceAt, staged_.sequence);
    head[kFirstAt] = staged_.first;
    head[kCountAt] = staged_.count;
    head[kSetAt] = staged_.set;
    put16(head + kRecordsCrcAt, staged_.crc);
    put16(head + kHeadCrcAt, core::crc16(core::kCrcStart, head, kHeadCrcAt));
    const uint8_t place = static_cast<uint8_t>(1 - place_);
    if (hal::eepromWrite(headAddress(place), head, sizeof head) == Status::ok)
        phase_ = Phase::heading;
    return Status::busy;
}

}  // namespace storage

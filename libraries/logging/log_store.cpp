// SPDX-License-Identifier: GPL-3.0-or-later
#include "logging/log_store.hpp"

#include "hal/page_flash.hpp"

namespace logging {

using core::Status;
using hal::FlashUser;

namespace {

constexpr uint8_t kPagesPerBlock = 8;
constexpr uint8_t kCheckedAtOnce = 32;

uint16_t pageSize() { return hal::flashShape().page_size; }

}  // namespace

void LogStore::start(uint16_t base) {
    state_ = State::asking;
    key_ = {};
    last_ = next_ = 0;
    base_ = base;
    wrapped_ = false;
}

uint16_t LogStore::ring() const { return hal::flashShape().pages - hal::kFlashMissionPages; }

uint16_t LogStore::place(uint16_t index) const {
    return hal::kFlashMissionPages + roundRing(index + base_);
}

uint16_t LogStore::fromOldest(uint16_t page) const {
    return wrapped_ ? roundRing(next_ + 1 + page) : page;
}

Status LogStore::headAt(uint16_t index, PageHead& head) const {
    const Status status = hal::flashRead(place(index), 0, &head, sizeof head);
    return status == Status::ok && !isWhole(head, pageSize()) ? Status::corrupt : status;
}

Status LogStore::readHead(uint16_t page, PageHead& head) const {
    return headAt(fromOldest(page), head);
}

Status LogStore::read(uint16_t page, uint16_t at, void* to, uint8_t size) const {
    return hal::flashRead(place(fromOldest(page)), sizeof(PageHead) + at, to, size);
}

// Halves what is left by one look. A damaged page has no number: the one after it is read.
Status LogStore::narrow(uint16_t from, const Key& key, bool upward, Search& search) const {
    if (search.end - search.first <= 1) return Status::ok;
    const uint16_t middle = search.first + (search.end - search.first) / 2;
    PageHead head;
    Status status = Status::corrupt;
    uint16_t at = middle;
    for (uint8_t tries = 0; status == Status::corrupt && tries < 3 && at < search.end; ++tries)
        status = headAt(roundRing(from + at++), head);
    if (status != Status::ok && status != Status::corrupt) return status;
    const bool belongs = upward ? !before(head.key, key) : !before(key, head.key);
    if (status == Status::ok && belongs) {
        search.first = at - 1;
    } else {
        search.end = middle;
    }
    return search.end - search.first <= 1 ? Status::ok : Status::busy;
}

Status LogStore::seek(const Key& key, Search& found) const {
    return narrow(fromOldest(0), key, false, found);
}

// The ring's last page shows whether it has been full, its first where the newest turn began.
Status LogStore::findEnds() {
    PageHead head;
    const Status last = headAt(ring() - 1, head);
    if (last != Status::ok && last != Status::corrupt) return last;
    wrapped_ = last == Status::ok;
    const Status first = headAt(0, head);
    if (first == Status::corrupt) {  // nothing, or cut short when it was to be written again
        state_ = State::numbering;
        return Status::ok;
    }
    if (first != Status::ok) return first;
    key_ = head.key;
    search_ = {0, ring()};
    state_ = State::seeking;
    return Status::ok;
}

// The newest page, a piece each look: its head may be whole and what follows not.
Status LogStore::check() {
    PageHead head;
    Status status = headAt(next_, head);
    if (status == Status::ok && checked_.bytes < head.used) {
        uint8_t bytes[kCheckedAtOnce];
        const uint16_t left = head.used - checked_.bytes;
        const uint8_t size = left < kCheckedAtOnce ? static_cast<uint8_t>(left) : kCheckedAtOnce;
        status = hal::flashRead(place(next_), sizeof head + checked_.bytes, bytes, size);
        if (status != Status::ok) return status;
        checked_.bytes += size;
        checked_.crc = core::crc16(checked_.crc, bytes, size);
        return status;
    }
    if (status != Status::ok) return status;
    if (checked_.crc == head.data_crc) next_ = roundRing(next_ + 1);
    state_ = State::numbering;
    return status;
}

// The log that the newest page belongs to.
Status LogStore::number() {
    PageHead head;
    Status status = Status::corrupt;
    if (next_ > 0 || wrapped_) status = headAt(next_ > 0 ? next_ - 1 : ring() - 1, head);
    if (status != Status::ok && status != Status::corrupt) return status;
    last_ = status == Status::ok ? head.key.log : 0;
    state_ = State::ready;
    return Status::ok;
}

bool LogStore::find() {
    if (state_ == State::none || state_ >= State::ready) return false;
    if (!hal::flashKnown()) return false;
    if (hal::flashShape().pages == 0) {
        state_ = State::none;
        return false;
    }
    switch (state_) {
        case State::asking:
            if (base_ >= ring() || base_ % kPagesPerBlock != 0) base_ = 0;
            state_ = State::ends;
            return true;
        case State::ends:
            return findEnds() == Status::ok;
        case State::seeking: {
            const Status status = narrow(0, key_, true, search_);
            if (status == Status::ok) {
                next_ = search_.first;
                checked_ = {0, core::kCrcStart};
                state_ = State::checking;
            }
            return status == Status::ok || !hal::flashBusy();
        }
        case State::checking:
            return check() == Status::ok;
        default:
            return number() == Status::ok;
    }
}

Status LogStore::begin() {
    if (state_ == State::none) return Status::unsupported;
    if (state_ == State::erasing) {
        if (erased_ < next_) next_ = erased_;
        if (erased_ < ring()) wrapped_ = false;
        state_ = State::numbering;
    }
    if (state_ == State::numbering) {
        const Status status = number();
        if (status != Status::ok) return status;
    }
    if (state_ != State::ready) return Status::busy;
    key_ = {following(last_), 0};
    filling_ = {0, core::kCrcStart};
    state_ = State::writing;
    return Status::ok;
}

Status LogStore::put(const void* record, uint8_t size) {
    if (state_ != State::writing) return Status::unsupported;
    if (filling_.used + size > pageSize() - sizeof(PageHead)) {
        const Status status = storePage();
        if (status != Status::ok) return status;
        // the chip's buffer is being programmed now
    }
    const uint16_t at = sizeof(PageHead) + filling_.used;
    const Status status = hal::flashFill(FlashUser::log, at, record, size);
    if (status != Status::ok) return status;
    filling_.used += size;
    filling_.crc = core::crc16(filling_.crc, record, size);
    return Status::ok;
}

Status LogStore::storePage() {
    PageHead head = {key_, filling_.used, filling_.crc, 0};
    head.head_crc = crcOf(head);
    Status status = hal::flashFill(FlashUser::log, 0, &head, sizeof head);
    if (status == Status::ok) status = hal::flashStore(FlashUser::log, place(next_));
    if (status != Status::ok) return status;
    key_.offset += filling_.used;
    filling_ = {0, core::kCrcStart};
    last_ = key_.log;
    next_ = roundRing(next_ + 1);
    if (next_ == 0) wrapped_ = true;
    return Status::ok;
}

Status LogStore::end() {
    if (state_ != State::writing) return Status::ok;
    const Status status = filling_.used > 0 ? storePage() : Status::ok;
    if (status == Status::busy) return status;
    state_ = State::ready;
    return Status::ok;
}

bool LogStore::erase() {
    if (state_ != State::ready) return state_ == State::erasing;
    erased_ = ring();
    state_ = State::erasing;
    return true;
}

bool LogStore::eraseStep() {
    if (state_ != State::erasing) return false;
    if (erased_ == 0) return !hal::flashBusy();
    const uint16_t block = erased_ - kPagesPerBlock;
    if (hal::flashErase(FlashUser::log, place(block)) == Status::ok) erased_ = block;
    return false;
}

uint16_t LogStore::nextBase() const {
    return roundRing(base_ + (next_ + kPagesPerBlock - 1) / kPagesPerBlock * kPagesPerBlock);
}

void LogStore::finishErase() {
    base_ = nextBase();
    next_ = last_ = 0;
    wrapped_ = false;
    state_ = State::ready;
}

}  // namespace logging

// SPDX-License-Identifier: GPL-3.0-or-later
// Finding the lists, staging and committing new ones. The copying is in list_migrate.cpp.
#include "storage/list_store.hpp"

#include "core/crc.hpp"
#include "hal/page_flash.hpp"

namespace storage {

using core::Status;

namespace {

constexpr uint8_t kSummedPerCall = 8;
constexpr uint8_t kSummedPerPut = 2;

}  // namespace

void ListStore::sumFromStart() {
    summed_ = 0;
    rechecks_ = false;
    crc_ = core::kCrcStart;
}

// Sums records up to `end`, a few each call; ok when all are.
Status ListStore::sum(const Extent& extent, uint8_t end, uint8_t most) {
    const uint8_t size = shapeOf(kind_).record_size;
    for (; most > 0 && summed_ < end; --most, ++summed_) {
        uint8_t record[kLargestRecord];
        const Status status = readRecord(kind_, extent, summed_, record);
        if (status != Status::ok) return status;
        crc_ = core::crc16(crc_, record, size);
    }
    return summed_ < end ? Status::busy : Status::ok;
}

Status ListStore::sumMatches(const Extent& extent) {
    const Status status = sum(extent, extent.count, kSummedPerCall);
    if (status != Status::ok) return status;
    return crc_ == extent.crc ? Status::ok : Status::corrupt;
}

// Leaves the newer head in other_, or the other one of the same list when the newer one's records
// are damaged. An older list is never looked at: what replaced it was acknowledged, or is whole.
Status ListStore::find() {
    Head heads[2];
    for (uint8_t turn = 0; turn < 2; ++turn) {
        const Status status = readHead(kind_, turn, heads[turn]);
        if (status != Status::ok) return status;
    }
    const Extent &even = heads[0].extent, &odd = heads[1].extent;
    const bool both = even.set != 0 && odd.set != 0;
    const bool newest = both ? newer(odd.sequence, even.sequence) : even.set == 0;
    const bool twins = both && even.generation == odd.generation;
    other_ = heads[last_head_ ? !newest : newest].extent;
    if (other_.set == 0) {
        other_ = {};
        last_head_ = true;
        return heads[0].blank && heads[1].blank ? Status::ok : Status::corrupt;
    }
    setLone(!twins);
    if (last_head_ || (!both && !heads[!newest].blank)) mended_ |= bit();
    if (!twins) last_head_ = true;
    sumFromStart();
    phase_ = Phase::checking;
    return Status::busy;
}

Status ListStore::open(ListKind& which) {
    if (phase_ >= Phase::idle) return Status::ok;
    which = kind_;
    const Status status = phase_ == Phase::finding ? find() : sumMatches(other_);
    if (status == Status::busy) return status;
    if (status != Status::ok) {
        if (!last_head_ && !inFlash()) {
            last_head_ = true;
            phase_ = Phase::finding;
            return Status::busy;
        }
        // its number is kept: the next head has to be newer
        other_.place = Place::eeprom;
        other_.set = other_.count = 0;
        setLone(false);
        mended_ = static_cast<uint8_t>(mended_ & ~bit());
    }
    present() = other_;
    other_ = {};
    last_head_ = false;
    const bool more = kind_ != ListKind::rally;
    phase_ = more ? Phase::finding : Phase::idle;
    if (more) kind_ = static_cast<ListKind>(static_cast<uint8_t>(kind_) + 1);
    return status == Status::ok && more ? Status::busy : status;
}

bool ListStore::flashWorks() const {
    return hal::flashShape().pages >= hal::kFlashMissionPages && !flash_bad_;
}

// Where a new list is staged: never where the present one is.
Status ListStore::place(Extent& staged, const Extent& now, uint8_t slots) const {
    if (staged.count > slots) return Status::full;
    staged.place = Place::eeprom;
    if (staged.count == 0) return Status::ok;  // a head is all there is to write
    if (flashWorks()) {
        staged.place = now.place == Place::flash_a ? Place::flash_b : Place::flash_a;
        return Status::ok;
    }
    if (staged.count > slots - now.count) return Status::full;
    const uint16_t first = static_cast<uint16_t>(now.first + now.count);
    staged.first = static_cast<uint8_t>(first < slots ? first : first - slots);
    return Status::ok;
}

Status ListStore::begin(ListKind kind, uint8_t count, uint8_t set) {
    abort();
    if (phase_ >= Phase::copying && phase_ <= Phase::copied) phase_ = Phase::idle;
    if (phase_ != Phase::idle) return Status::busy;
    if (set == 0) return Status::bad_argument;
    Extent staged = of(kind);
    staged.count = count;
    staged.set = set;
    staged.crc = core::kCrcStart;
    ++staged.generation;
    const Status status = place(staged, of(kind), shapeOf(kind).slots);
    if (status != Status::ok) return status;
    kind_ = kind;
    other_ = staged;
    put_ = stored_ = 0;
    sumFromStart();
    phase_ = Phase::filling;
    return Status::ok;
}

// Hands a full page to the chip, or the last one of a list that is complete.
Status ListStore::storePages() {
    const uint8_t size = shapeOf(kind_).page_records;
    const uint8_t last = phase_ == Phase::filling ? 0 : static_cast<uint8_t>(size - 1);
    if (stored_ >= static_cast<uint8_t>((put_ + last) / size)) return Status::ok;
    const Status status = storePage(kind_, other_, stored_);
    hal::flashWant(hal::FlashUser::mission, status == Status::busy);
    if (status == Status::ok) ++stored_;
    return status;
}

Status ListStore::put(const uint8_t* record) {
    if (phase_ != Phase::filling || put_ >= other_.count) return Status::bad_argument;
    if (inFlash()) {
        const Status status = storePages();
        if (status != Status::ok) return status;
    }
    const Status status = writeRecord(kind_, other_, put_, record);
    if (status != Status::ok) return status;
    const ListShape list = shapeOf(kind_);
    other_.crc = core::crc16(other_.crc, record, list.record_size);
    ++put_;
    if (!inFlash()) return Status::ok;
    // a busy chip is asked again with the next record; an error comes again too
    (void)storePages();
    (void)sum(other_, static_cast<uint8_t>(stored_ * list.page_records), kSummedPerPut);
    return Status::ok;
}

Status ListStore::copy() {
    uint8_t record[kLargestRecord];
    const Status status = read(kind_, put_, record);
    return status == Status::ok ? put(record) : status;
}

void ListStore::abort() {
    if (phase_ < Phase::filling || phase_ >= Phase::heading) return;
    phase_ = Phase::idle;
    hal::flashWant(hal::FlashUser::mission, false);
}

Status ListStore::failed(Status status) {
    if (status == Status::busy) return status;
    if (inFlash()) flash_bad_ = true;
    abort();
    return status;
}

// ok: the head of `target` is in the EEPROM, read back.
Status ListStore::head(const Extent& target, Phase writing) {
    if (phase_ == writing) return hal::eepromDrained() ? checkHead(kind_, target) : Status::busy;
    if (writeHead(kind_, target) == Status::ok) phase_ = writing;
    return Status::busy;
}

// ok: what is staged is where it was put.
Status ListStore::makeDurable() {
    if (phase_ == Phase::storing) {
        const Status status = inFlash()              ? storePages()
                              : hal::eepromDrained() ? Status::ok
                                                     : Status::busy;
        if (status != Status::ok) return status;
        phase_ = Phase::verifying;
    }
    return sumMatches(other_);
}

// From its first head on the new list is the one that the next start finds; it is acknowledged
// when the second one names it too.
Status ListStore::commit() {
    if (phase_ == Phase::filling && put_ == other_.count) phase_ = Phase::storing;
    if (phase_ < Phase::storing) return Status::bad_argument;
    if (phase_ < Phase::heading) {
        const Status status = makeDurable();
        if (status != Status::ok) return failed(status);
        other_.sequence = static_cast<uint16_t>(present().sequence + 1);
    }
    if (phase_ <= Phase::heading) {
        const Status status = head(other_, Phase::heading);
        if (status == Status::busy) return status;
        setLone(present().set != 0 || status == Status::ok);
        phase_ = status == Status::ok ? Phase::headed : Phase::idle;
        if (status != Status::ok) return status;
        ++other_.sequence;
    }
    const Status status = head(other_, Phase::heading_twice);
    if (status == Status::busy) return status;
    if (status == Status::ok)
        setLone(false);
    else
        --other_.sequence;  // migrateToEeprom() tries again, and reports it
    const Extent previous = present();
    present() = other_;
    other_ = previous;
    phase_ = Phase::idle;
    return Status::ok;
}

}  // namespace storage

// SPDX-License-Identifier: GPL-3.0-or-later
// Brings what was committed in the DataFlash home to the EEPROM, in the background. Until its last
// head is written the list in the DataFlash counts, and after a reset all is done again.
#include "hal/eeprom.hpp"
#include "storage/list_store.hpp"

namespace storage {

using core::Status;

namespace {

constexpr uint8_t kCopiedPerCall = 4;

Extent inEeprom(Extent extent) {
    extent.place = Place::eeprom;
    ++extent.sequence;
    return extent;
}

}  // namespace

bool ListStore::findUnmigrated() {
    for (uint8_t i = 0; i < kListKinds; ++i) {
        if (present_[i].place == Place::eeprom) continue;
        kind_ = static_cast<ListKind>(i);
        return true;
    }
    return false;
}

// Begins when the EEPROM has nothing else to do, and leaves room behind it for others. Bytes that
// are the same already take no time, so records go on while there is room.
Status ListStore::copyRecords() {
    if (!hal::eepromDrained()) return Status::busy;
    const Extent target = inEeprom(present());
    for (uint8_t n = 0; n < kCopiedPerCall && put_ < target.count; ++n, ++put_) {
        uint8_t record[kLargestRecord];
        Status status = readRecord(kind_, present(), put_, record);
        if (status == Status::ok) status = writeRecord(kind_, target, put_, record);
        if (status != Status::ok) return Status::busy;
    }
    if (put_ == target.count) {
        sumFromStart();
        phase_ = Phase::summing_copy;
    }
    return Status::busy;
}

Status ListStore::migrateToEeprom() {
    if (phase_ == Phase::idle) {
        if (eeprom_bad_ || !findUnmigrated()) return Status::ok;
        put_ = 0;
        phase_ = Phase::copying;
    }
    if (phase_ == Phase::copying) return copyRecords();
    if (phase_ > Phase::migrating || phase_ < Phase::idle) return Status::busy;
    const Extent target = inEeprom(present());
    if (phase_ == Phase::summing_copy) {
        if (!hal::eepromDrained()) return Status::busy;
        const Status status = sumMatches(target);
        if (status == Status::busy) return status;
        eeprom_bad_ = status != Status::ok;
        if (eeprom_bad_) {
            phase_ = Phase::idle;
            return status;
        }
    }
    if (head(target, Phase::migrating) != Status::ok) return Status::busy;
    present() = target;
    phase_ = Phase::idle;
    return Status::busy;
}

}  // namespace storage

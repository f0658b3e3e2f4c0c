// SPDX-License-Identifier: GPL-3.0-or-later
// Brings what was committed in the DataFlash home to the EEPROM, in the background. Until its last
// head is written the list in the DataFlash counts, and after a reset all is done again. A list
// that only one head names, because the other one was damaged or its writing cut, gets the other.
#include "hal/eeprom.hpp"
#include "storage/list_store.hpp"

namespace storage {

using core::Status;

namespace {

constexpr uint8_t kCopiedPerCall = 4;
constexpr uint8_t kRecheckedPerCall = 2;

Extent inEeprom(Extent extent) {
    extent.place = Place::eeprom;
    ++extent.sequence;
    return extent;
}

}  // namespace

bool ListStore::findUnmigrated() {
    for (uint8_t i = 0; i < kListKinds; ++i) {
        if (present_[i].place == Place::eeprom && (lone_ >> i & 1) == 0) continue;
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
        phase_ = present().place == Place::eeprom ? Phase::copied : Phase::copying;
    }
    if (phase_ == Phase::copying) return copyRecords();
    if (phase_ > Phase::migrating || phase_ < Phase::idle) return Status::busy;
    const Extent target = inEeprom(present());
    Status status = Status::ok;
    if (phase_ == Phase::summing_copy) {
        status = hal::eepromDrained() ? sumMatches(target) : Status::busy;
        if (status == Status::ok) phase_ = Phase::copied;
    }
    if (status == Status::ok) status = head(target, Phase::migrating);
    if (status == Status::busy) return status;
    phase_ = Phase::idle;
    setLone(false);
    if (status == Status::ok) {
        present() = target;
        return Status::busy;
    }
    eeprom_bad_ = present().place != Place::eeprom;
    mended_ = static_cast<uint8_t>(mended_ & ~bit());
    return status;
}

bool ListStore::takeMended(ListKind& which) {
    for (uint8_t i = 0; i < kListKinds; ++i) {
        const uint8_t bit = static_cast<uint8_t>(1 << i);
        if ((mended_ & bit) == 0) continue;
        mended_ = static_cast<uint8_t>(mended_ & ~bit);
        which = static_cast<ListKind>(i);
        return true;
    }
    return false;
}

Status ListStore::recheck() {
    if (phase_ != Phase::idle || !hal::eepromDrained()) return Status::busy;
    if (!rechecks_) {
        kind_ = ListKind::mission;
        sumFromStart();
        rechecks_ = true;
    }
    Extent& mission = present();
    const Status status = sum(mission, mission.count, kRecheckedPerCall);
    if (status != Status::ok) return Status::busy;
    rechecks_ = false;
    if (mission.count == 0 || crc_ == mission.crc) return Status::ok;
    mission.set = mission.count = 0;
    return Status::corrupt;
}

}  // namespace storage

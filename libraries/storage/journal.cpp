// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/journal.hpp"

#include "core/crc.hpp"
#include "hal/eeprom.hpp"
#include "storage/bytes.hpp"
#include "storage/eeprom_map.hpp"

namespace storage {
namespace {

using core::Status;

// An entry: 9 bits of slot and 7 of sequence, the value, the CRC of these six bytes.
constexpr uint16_t kSlotMask = 0x01FF;
constexpr uint8_t kSequenceMask = 0x7F;
constexpr uint8_t kCheckedSize = kJournalEntrySize - 2;
static_assert(kParameterSlots <= kSlotMask, "a slot number takes nine bits");

uint16_t entryAddress(uint8_t entry) {
    return static_cast<uint16_t>(kJournal.begin + entry * kJournalEntrySize);
}

bool whole(const uint8_t (&entry)[kJournalEntrySize]) {
    return get16(entry + kCheckedSize) == core::crc16(core::kCrcStart, entry, kCheckedSize) &&
           (get16(entry) & kSlotMask) < kParameterSlots;
}

// Numbers run on modulo 128 and eight entries are alive: the nearer way round is the age.
bool newer(uint8_t a, uint8_t b) {
    const uint8_t ahead = static_cast<uint8_t>(a - b) & kSequenceMask;
    return ahead != 0 && ahead < 64;
}

}  // namespace

Status Journal::recover() {
    if (pending_) return applyPending() ? Status::ok : Status::busy;
    bool found = false;
    for (uint8_t i = 0; i < kJournalEntries; ++i) {
        uint8_t entry[kJournalEntrySize];
        const Status status = hal::eepromRead(entryAddress(i), entry, sizeof entry);
        if (status != Status::ok) return status;
        const uint8_t sequence = entry[1] >> 1;
        if (!whole(entry) || (found && !newer(sequence, sequence_))) continue;
        found = true;
        newest_ = i;
        sequence_ = sequence;
        slot_ = get16(entry) & kSlotMask;
        value_ = get32(entry + 2);
    }
    pending_ = found;
    return applyPending() ? Status::ok : Status::busy;
}

Status Journal::write(uint16_t slot, uint32_t value) {
    if (slot >= kParameterSlots) return Status::bad_argument;
    if (!applyPending()) return Status::busy;
    const uint8_t place = (newest_ + 1) % kJournalEntries;
    const uint8_t sequence = (sequence_ + 1) & kSequenceMask;
    uint8_t entry[kJournalEntrySize];
    put16(entry, static_cast<uint16_t>(slot | (static_cast<uint16_t>(sequence) << 9)));
    put32(entry + 2, value);
    put16(entry + kCheckedSize, core::crc16(core::kCrcStart, entry, kCheckedSize));
    const Status status = hal::eepromWrite(entryAddress(place), entry, sizeof entry);
    if (status != Status::ok) return status;
    newest_ = place;
    sequence_ = sequence;
    slot_ = slot;
    value_ = value;
    pending_ = true;
    applyPending();
    return Status::ok;
}

bool Journal::applyPending() {
    if (!pending_) return true;
    uint8_t bytes[kParameterSize];
    put32(bytes, value_);
    pending_ = hal::eepromWrite(parameterAddress(slot_), bytes, sizeof bytes) != Status::ok;
    return !pending_;
}

Status readSlot(uint16_t slot, uint32_t& value) {
    if (slot >= kParameterSlots) return Status::bad_argument;
    uint8_t bytes[kParameterSize];
    const Status status = hal::eepromRead(parameterAddress(slot), bytes, sizeof bytes);
    if (status == Status::ok) value = get32(bytes);
    return status;
}

Status clearSlot(uint16_t slot) {
    if (slot >= kParameterSlots) return Status::bad_argument;
    constexpr uint8_t kBlank[kParameterSize] = {0xFF, 0xFF, 0xFF, 0xFF};
    return hal::eepromWrite(parameterAddress(slot), kBlank, sizeof kBlank);
}

}  // namespace storage

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

Status readSlot(uint16_t slot, uint32_t& value) {
    uint8_t bytes[kParameterSize];
    const Status status = hal::eepromRead(parameterAddress(slot), bytes, sizeof bytes);
    if (status == Status::ok) value = get32(bytes);
    return status;
}

}  // namespace

// In last_; without a slot there is none.
Status Journal::findNewest() {
    for (uint8_t i = 0; i < kJournalEntries; ++i) {
        uint8_t entry[kJournalEntrySize];
        const Status status = hal::eepromRead(entryAddress(i), entry, sizeof entry);
        if (status != Status::ok) return status;
        const uint8_t sequence = entry[1] >> 1;
        if (!whole(entry) || (last_.slot != kNoSlot && !newer(sequence, sequence_))) continue;
        newest_ = i;
        sequence_ = sequence;
        last_.slot = get16(entry) & kSlotMask;
        last_.value = get32(entry + 2);
    }
    return Status::ok;
}

// So many more; ok: they are all in sum_.
Status Journal::sum(uint16_t slots) {
    if (summed_ == 0) sum_ = {0, 0};
    for (; slots > 0; --slots) {
        uint32_t value;
        const Status status = read(summed_, value);
        if (status != Status::ok) return status;
        sum_.toggle(summed_, value);
        if (++summed_ == 0) return Status::ok;
    }
    return Status::busy;
}

// With one bit changed the slots fit `wanted`: it goes back to what it was.
bool Journal::mend(const ParameterCheck& wanted) {
    uint8_t slot;
    uint32_t bit, value;
    if (!sum_.locate(wanted, slot, bit) || readSlot(slot, value) != Status::ok) return false;
    ParameterCheck mended = sum_;
    mended.toggle(slot, value);
    mended.toggle(slot, value ^ bit);
    if (!(mended == wanted)) return false;
    worn_.slot = slot;  // its cell may not hold it
    worn_.value = value ^ bit;
    last_ = worn_;
    check_ = wanted;
    return true;
}

// Makes of check_ what it is with the newest entry in its slot.
Status Journal::redo() {
    check_ = sum_;
    if (last_.slot == kNoSlot) return Status::ok;
    uint32_t value;
    const Status status = readSlot(last_.slot, value);
    if (status != Status::ok) return status;
    check_.toggle(static_cast<uint8_t>(last_.slot), value);
    check_.toggle(static_cast<uint8_t>(last_.slot), last_.value);
    return Status::ok;
}

// The first check does not fit what is stored.
void Journal::compareRedone(const ParameterCheck& first, const ParameterCheck& second) {
    step_ = Step::first_check;
    if (first == check_) return;  // cut while the slot was written
    found_ = Found::mended;
    if (second == sum_ || second == check_ || mend(first) || mend(second)) return;
    found_ = Found::damaged;
    step_ = Step::done;
    check_ = first;
    last_.slot = kNoSlot;
}

// By what is stored, in sum_, the newest entry, in last_, and the checks.
Status Journal::compare() {
    uint8_t bytes[2 * kCheckSize];
    Status status = hal::eepromRead(kChecks.begin, bytes, sizeof bytes);
    if (status == Status::ok) status = redo();
    if (status != Status::ok) return status;
    const ParameterCheck first = getCheck(bytes), second = getCheck(bytes + kCheckSize);
    checks_ = true;
    if (first == kNoCheck && second == kNoCheck) {  // of a version that had none
        if (last_.slot != kNoSlot) step_ = Step::first_check;
    } else if (first == sum_) {
        last_.slot = kNoSlot;
        check_ = sum_;
        if (second == sum_) return Status::ok;
        step_ = Step::second_check;
        found_ = Found::mended;
    } else {
        compareRedone(first, second);
    }
    return Status::ok;
}

Status Journal::recover() {
    if (step_ == Step::done) {
        if (!hal::eepromDrained()) return Status::busy;
        *this = Journal();
        Status status = findNewest();
        if (status == Status::ok) status = sum(kParameterSlots);
        if (status == Status::ok) status = compare();
        if (status != Status::ok) return status;
    }
    return applyPending() ? Status::ok : Status::busy;
}

Status Journal::trust() {
    constexpr uint16_t kPerCall = 12;
    if (!applyPending()) return Status::busy;
    const Status status = sum(kPerCall);
    if (status != Status::ok) return status;
    check_ = sum_;
    checks_ = true;
    found_ = Found::sound;
    last_.slot = kNoSlot;
    step_ = Step::first_check;
    applyPending();
    return Status::ok;
}

Status Journal::read(uint16_t slot, uint32_t& value) const {
    if (slot >= kParameterSlots) return Status::bad_argument;
    if (slot != worn_.slot) return readSlot(slot, value);
    value = worn_.value;
    return Status::ok;
}

Status Journal::write(uint16_t slot, uint32_t value) {
    if (slot >= kParameterSlots) return Status::bad_argument;
    if (!applyPending() || unverified_) return Status::busy;
    uint32_t before = last_.value;
    Status status = slot == last_.slot ? Status::ok : read(slot, before);
    if (status != Status::ok) return status;
    const uint8_t place = (newest_ + 1) % kJournalEntries;
    const uint8_t sequence = (sequence_ + 1) & kSequenceMask;
    uint8_t entry[kJournalEntrySize];
    put16(entry, static_cast<uint16_t>(slot | (static_cast<uint16_t>(sequence) << 9)));
    put32(entry + 2, value);
    put16(entry + kCheckedSize, core::crc16(core::kCrcStart, entry, kCheckedSize));
    status = hal::eepromWrite(entryAddress(place), entry, sizeof entry);
    if (status != Status::ok) return status;
    newest_ = place;
    sequence_ = sequence;
    last_.slot = slot;
    last_.value = value;
    if (slot == worn_.slot) worn_.value = value;
    check_.toggle(static_cast<uint8_t>(slot), before);
    check_.toggle(static_cast<uint8_t>(slot), value);
    summed_ = 0;
    tries_ = 0;
    step_ = checks_ ? Step::first_check : Step::value;
    applyPending();
    return Status::ok;
}

Journal::Step Journal::nextStep() const {
    if (step_ == Step::first_check && last_.slot != kNoSlot) return Step::value;
    return step_ == Step::second_check || !checks_ ? Step::done : Step::second_check;
}

bool Journal::queueStep() {
    uint8_t bytes[kParameterSize];
    uint16_t at = kChecks.begin;
    if (step_ == Step::value) {
        put32(bytes, last_.value);
        at = parameterAddress(last_.slot);
        unverified_ = true;
    } else {
        putCheck(check_, bytes);
        if (step_ == Step::second_check) at = static_cast<uint16_t>(at + kCheckSize);
    }
    return hal::eepromWrite(at, bytes, sizeof bytes) == Status::ok;
}

bool Journal::applyPending() {
    for (; step_ != Step::done; step_ = nextStep())
        if (!queueStep()) return false;
    verify();
    return step_ == Step::done;
}

// Where a cell has not kept the last value, the check must go on from what it should be. Of two
// such slots the check cannot be known any more: it is made to fit nothing.
void Journal::verify() {
    uint32_t value;
    if (!unverified_ || !hal::eepromDrained() || readSlot(last_.slot, value) != Status::ok) return;
    unverified_ = false;
    if (value == last_.value || worn_.slot == last_.slot) return;
    if (tries_++ < kTries) {  // the supply may have been low: once more
        step_ = checks_ ? Step::first_check : Step::value;
        return;
    }
    if (worn_.slot != kNoSlot) check_.crc = static_cast<uint16_t>(~check_.crc);
    worn_ = last_;
    worn_now_ = true;
}

bool Journal::takeWorn() {
    const bool worn = worn_now_;
    worn_now_ = false;
    return worn;
}

Status clearSlot(uint16_t slot) {
    if (slot >= kParameterSlots) return Status::bad_argument;
    constexpr uint8_t kBlank[kParameterSize] = {0xFF, 0xFF, 0xFF, 0xFF};
    return hal::eepromWrite(parameterAddress(slot), kBlank, sizeof kBlank);
}

}  // namespace storage

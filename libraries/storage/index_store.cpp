// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/index_store.hpp"

#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"

namespace storage {
namespace {

using core::Status;

// An entry: index, generation, number. Entries are written in turn, and their count modulo four
// rounds over all places, the sequence, says which is the newest. The number is, by 21, the round
// and the check with the place and 7 as remainder. It is written last, so a cut leaves the old
// number or 0xFF, and the entry does not count.
//
// No changed bit makes another entry of it: the check is the remainder of index and generation by
// 3, and the number's remainder by 7 is the place's; a bit is a power of two, which neither 3 nor 7
// divides. The first boards had numbers from 0 to 251 without a check, the place as remainder by
// 21, and are read too.
constexpr uint8_t kRounds = 4, kCheckedBy = 3, kShift = 7;
constexpr uint8_t kSequences = kRounds * kIndexEntries;
constexpr uint8_t kNumbers = kCheckedBy * kSequences;
constexpr uint8_t kNone = 0xFF;
static_assert(kIndexEntries % kShift == 0 && kShift % 2 != 0, "a bit changes the remainder");
static_assert(kNumbers < 0xFF, "a blank is no number");

uint8_t next(uint8_t sequence) { return sequence + 1 == kSequences ? 0 : sequence + 1; }

// Of 21 that are alive and the one that is newer.
bool newer(uint8_t a, uint8_t b) {
    const uint8_t ahead = static_cast<uint8_t>(a < b ? a + kSequences - b : a - b);
    return ahead != 0 && ahead < kSequences / 2;
}

uint8_t checkOf(uint8_t index, uint8_t generation) {
    return static_cast<uint8_t>((index + generation) % kCheckedBy);
}

uint8_t shifted(uint8_t place) { return static_cast<uint8_t>((place + kShift) % kIndexEntries); }

// Of an entry that does not count kNone; so of a blank one whose number has a changed bit.
uint8_t sequenceOf(const uint8_t (&entry)[kIndexEntrySize], uint8_t place) {
    const uint8_t number = entry[2];
    if (number >= kNumbers || (entry[0] & entry[1]) == 0xFF) return kNone;
    const uint8_t high = number / kIndexEntries, low = number % kIndexEntries;
    uint8_t round = high / kCheckedBy;
    if (low == place)
        round = high % kRounds;
    else if (low != shifted(place) || high % kCheckedBy != checkOf(entry[0], entry[1]))
        return kNone;
    return static_cast<uint8_t>(round * kIndexEntries + place);
}

bool isBlank(const uint8_t (&entry)[kIndexEntrySize]) {
    return (entry[0] & entry[1] & entry[2]) == 0xFF;
}

uint16_t entryAddress(uint8_t place) {
    return static_cast<uint16_t>(kIndex.begin + place * kIndexEntrySize);
}

}  // namespace

Status IndexStore::open(uint8_t generation, uint8_t& index, bool& damaged) {
    uint8_t entries[kIndexEntries][kIndexEntrySize];
    const Status status = hal::eepromRead(kIndex.begin, entries, sizeof entries);
    if (status != Status::ok) return status;
    index = 0;
    sequence_ = kNone;
    for (uint8_t place = 0; place < kIndexEntries; ++place) {
        const uint8_t* const entry = entries[place];
        const uint8_t sequence = sequenceOf(entries[place], place);
        if (sequence == kNone || (sequence_ != kNone && !newer(sequence, sequence_))) continue;
        sequence_ = sequence;
        index = entry[1] == generation ? entry[0] : 0;
    }
    if (sequence_ == kNone) sequence_ = kSequences - 1;
    const uint8_t place = next(sequence_) % kIndexEntries;
    damaged = sequenceOf(entries[place], place) == kNone && !isBlank(entries[place]);
    return Status::ok;
}

Status IndexStore::write(uint8_t generation, uint8_t index) {
    const uint8_t sequence = next(sequence_);
    const uint8_t place = sequence % kIndexEntries;
    const uint8_t high =
        static_cast<uint8_t>(sequence / kIndexEntries * kCheckedBy + checkOf(index, generation));
    const uint8_t number = static_cast<uint8_t>(high * kIndexEntries + shifted(place));
    const uint8_t entry[kIndexEntrySize] = {index, generation, number};
    const Status status = hal::eepromWrite(entryAddress(place), entry, sizeof entry);
    if (status == Status::ok) sequence_ = sequence;
    return status;
}

}  // namespace storage

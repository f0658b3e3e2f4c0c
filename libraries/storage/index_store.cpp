// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/index_store.hpp"

#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"

namespace storage {
namespace {

using core::Status;

// An entry: index, generation, number. The number is written last, so a cut leaves the old number
// or 0xFF, and the entry does not count. Numbers run 0..kNumbers - 1, then begin again.
constexpr uint8_t kNumbers = 252;
static_assert(kNumbers % kIndexEntries == 0, "a place always has the same numbers");

uint8_t next(uint8_t number) { return number + 1 == kNumbers ? 0 : number + 1; }

uint16_t entryAddress(uint8_t place) {
    return static_cast<uint16_t>(kIndex.begin + place * kIndexEntrySize);
}

}  // namespace

Status IndexStore::open(uint8_t generation, uint8_t& index) {
    uint8_t entries[kIndexEntries][kIndexEntrySize];
    const Status status = hal::eepromRead(kIndex.begin, entries, sizeof entries);
    if (status != Status::ok) return status;
    index = 0;
    newest_ = kIndexEntries - 1;
    sequence_ = kNumbers - 1;
    for (uint8_t i = 0; i < kIndexEntries; ++i) {
        const uint8_t number = entries[i][2];
        if (number >= kNumbers || number % kIndexEntries != i) continue;
        const uint8_t* after = entries[(i + 1) % kIndexEntries];
        if (after[2] == next(number)) continue;
        newest_ = i;
        sequence_ = number;
        index = entries[i][1] == generation ? entries[i][0] : 0;
        // a run that ends here and did not begin by a cut is the newest
        const uint8_t* before = entries[(i + kIndexEntries - 1) % kIndexEntries];
        if (next(before[2]) == number) break;
    }
    return Status::ok;
}

Status IndexStore::write(uint8_t generation, uint8_t index) {
    const uint8_t place = (newest_ + 1) % kIndexEntries;
    const uint8_t number = next(sequence_);
    const uint8_t entry[kIndexEntrySize] = {index, generation, number};
    const Status status = hal::eepromWrite(entryAddress(place), entry, sizeof entry);
    if (status != Status::ok) return status;
    newest_ = place;
    sequence_ = number;
    return Status::ok;
}

}  // namespace storage

// SPDX-License-Identifier: GPL-3.0-or-later
// The lists, and of the mission the records that will probably be wanted next: the engine must
// not wait while the EEPROM or the DataFlash is busy.
#pragma once
#include "storage/list_store.hpp"

namespace storage {

class MissionStore : public ListStore {
public:
    uint8_t count() const { return ListStore::count(ListKind::mission); }
    uint8_t set() const { return ListStore::set(ListKind::mission); }
    uint8_t generation() const { return ListStore::generation(ListKind::mission); }
    bool staging() const { return ListStore::staging(ListKind::mission); }
    MUST_USE core::Status begin(uint8_t count, uint8_t set) {
        return ListStore::begin(ListKind::mission, count, set);
    }
    MUST_USE core::Status commit();

    MUST_USE core::Status read(uint8_t index, uint8_t* to);
    void readAhead(uint8_t index);

    using ListStore::begin;
    using ListStore::count;
    using ListStore::generation;
    using ListStore::read;
    using ListStore::set;
    using ListStore::staging;

private:
    struct Ahead {
        uint8_t index_1;  // 1 + the record's; 0: none
        uint8_t record[kRecordSize];
    };
    static constexpr uint8_t kAheads = 2;
    Ahead ahead_[kAheads] = {};
};

}  // namespace storage

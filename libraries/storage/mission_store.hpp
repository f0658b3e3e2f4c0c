// SPDX-License-Identifier: GPL-3.0-or-later
// The mission in EEPROM. The region is a ring of records: a new mission is staged in the slots the
// present one leaves free, checked, and made the present one by a single small write, its head.
// There are two heads, written in turn; the newer one whose records match its CRC counts, so a
// power cut at any moment leaves the old or the new mission, whole. Knows nothing of commands.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "storage/eeprom_map.hpp"

namespace storage {

class MissionStore {
public:
    // At start, until it is not busy: finds and checks the present mission, a part each call.
    // corrupt: something was stored and nothing of it is whole; the mission is then empty.
    MUST_USE core::Status open();

    uint8_t count() const { return present_.count; }
    uint8_t set() const { return present_.set; }
    uint16_t generation() const { return present_.sequence; }  // another one after every commit

    // Record `index` of the present mission. busy: in a later frame. bad_argument: no such record.
    MUST_USE core::Status read(uint8_t index, uint8_t* to);
    // Fetches the records that will probably be read next, when the EEPROM has time.
    void readAhead(uint8_t index);

    // A new mission. full: no room beside the present one. busy: the last one is not yet done.
    MUST_USE core::Status begin(uint8_t count, uint8_t set);
    MUST_USE core::Status put(const uint8_t* record);  // in order; busy: again later
    MUST_USE core::Status copy();                      // puts the present mission's record
    uint8_t staged() const { return staged_.put; }
    uint8_t stagedCount() const { return staged_.count; }
    uint8_t stagedSet() const { return staged_.set; }
    bool staging() const { return phase_ == Phase::filling; }
    MUST_USE core::Status readStaged(uint8_t index, uint8_t* to);
    // Until it is not busy. ok: the new mission is the mission and would survive a power cut.
    // corrupt: what was read back is not what was put; the old mission stays.
    MUST_USE core::Status commit();
    void abort();  // forgets what is staged; without effect once the head is being written

    // The mission before the last commit, until the next begin().
    uint8_t previousCount() const { return previous_.count; }
    uint8_t previousSet() const { return previous_.set; }
    MUST_USE core::Status readPrevious(uint8_t index, uint8_t* to);

private:
    enum class Phase : uint8_t { closed, checking, idle, filling, draining, verifying, heading };
    struct Extent {
        uint8_t first;
        uint8_t count;
        uint8_t set;
        uint16_t sequence;
        uint16_t crc;
    };
    struct Staged : Extent {
        uint8_t put;
    };
    struct Ahead {
        uint8_t index;
        uint8_t record[kRecordSize];
    };
    static constexpr uint8_t kAheads = 2;

    static core::Status readSlot(const Extent& extent, uint8_t index, uint8_t* to);
    static core::Status readHead(uint8_t place, Extent& extent, bool& blank);
    core::Status findHeads();
    core::Status check(const Extent& extent, bool& matches);
    core::Status fallBack();
    core::Status writeHead();
    void settleOn(const Extent& extent);

    Extent present_ = {};
    Extent previous_ = {};
    Staged staged_ = {};
    Ahead ahead_[kAheads] = {};
    uint16_t crc_ = 0;  // of the records checked so far
    uint8_t checked_ = 0;
    uint8_t place_ = 0;  // of the present head
    Phase phase_ = Phase::closed;
    bool other_waits_ = false;  // an older head is left to try
};

}  // namespace storage

// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the writing of one parameter value all or nothing: the value goes into a journal entry
// first, then to its slot. At start the newest whole entry is done again, which changes nothing
// when it had been done. The entries are used in turn, so the newest is never overwritten.
#pragma once
#include <stdint.h>

#include "core/status.hpp"

namespace storage {

class Journal {
public:
    // Once at start, before any value is read from a slot. busy: ask again in a later frame.
    MUST_USE core::Status recover();

    // Queues the four bytes of `value` for `slot`. busy: no room yet, nothing was changed.
    // bad_argument: no such slot.
    MUST_USE core::Status write(uint16_t slot, uint32_t value);

    // Finishes what the last write could not yet queue. True when nothing is left over.
    bool applyPending();

private:
    uint8_t newest_ = 0;    // place of the newest entry
    uint8_t sequence_ = 0;  // its number, 7 bits
    bool pending_ = false;  // the journal has it, its slot not yet
    uint16_t slot_ = 0;
    uint32_t value_ = 0;
};

// The four bytes in a slot; all ones where nothing was ever written.
MUST_USE core::Status readSlot(uint16_t slot, uint32_t& value);
MUST_USE core::Status clearSlot(uint16_t slot);

}  // namespace storage

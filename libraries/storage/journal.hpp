// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the writing of one parameter value all or nothing, and holds a check over all of them. The
// value goes into a journal entry first, then into the first check, its slot and the second check.
// At start one of the checks fits the slots as they are, or as the newest whole entry makes them,
// wherever a cut came. Where none does, a single bit that changed by itself is found by the check
// and undone; more are reported. The entries are used in turn, so the newest is never overwritten.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "storage/parameter_check.hpp"

namespace storage {

class Journal {
public:
    // Once at start, before any value is read from a slot. busy: ask again in a later frame.
    MUST_USE core::Status recover();

    // What recover() found. mended: a bit that had changed by itself, in a slot or in a check, or
    // a cut while a check was written. damaged: more than that, and the values are not to be
    // trusted; so at every start, until trust().
    enum class Found : uint8_t { sound, mended, damaged };
    Found found() const { return found_; }
    // The slots are right as they are: makes the checks anew, a part each call. busy: again later.
    MUST_USE core::Status trust();

    // The four bytes in a slot; all ones where nothing was ever written. A cell that is worn reads
    // as it should. bad_argument: no such slot.
    MUST_USE core::Status read(uint16_t slot, uint32_t& value) const;

    // Queues the four bytes of `value` for `slot`. busy: the last value is still being written and
    // read back, some 70 ms; nothing was changed.
    // bad_argument: no such slot.
    MUST_USE core::Status write(uint16_t slot, uint32_t value);

    // Finishes what the last write could not yet queue. True when nothing is left over.
    bool applyPending();

    // True once for each write that the EEPROM has not kept.
    bool takeWorn();

private:
    enum class Step : uint8_t { done, first_check, value, second_check };
    static constexpr uint16_t kNoSlot = kParameterSlots;
    static constexpr uint8_t kTries = 1;  // of a value that was not kept; the driver has tried long
    struct Word {                         // of a slot
        uint16_t slot = kNoSlot;
        uint32_t value = 0;
    };

    core::Status findNewest();
    core::Status sum(uint16_t slots);
    core::Status compare();
    core::Status redo();
    void compareRedone(const ParameterCheck& first, const ParameterCheck& second);
    bool mend(const ParameterCheck& wanted);
    bool queueStep();
    Step nextStep() const;
    void verify();

    uint8_t newest_ = 0;       // place of the newest entry
    uint8_t sequence_ = 0;     // its number, 7 bits
    Step step_ = Step::done;   // to be queued next
    bool checks_ = false;      // recover() has been through
    bool unverified_ = false;  // `last_` has not been read back
    uint8_t tries_ = kTries;   // of writing it once more; at the start there are none
    bool worn_now_ = false;
    Found found_ = Found::sound;
    uint8_t summed_ = 0;             // slots
    ParameterCheck sum_ = {0, 0};    // of them
    ParameterCheck check_ = {0, 0};  // what is stored, or is to be
    Word last_;                      // written
    Word worn_;                      // what should be where a cell does not hold it
};

// Leaves nothing stored in a slot, past the journal and its checks: trust() has to follow.
MUST_USE core::Status clearSlot(uint16_t slot);

}  // namespace storage

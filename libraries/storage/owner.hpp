// SPDX-License-Identifier: GPL-3.0-or-later
// Whose EEPROM this is. What other firmware has written is recognised and left alone until its
// owner asks for it to be erased.
#pragma once
#include <stdint.h>

#include "core/status.hpp"

namespace storage {

enum class Owner : uint8_t {
    blank,
    ours,           // this layout
    other_version,  // this firmware, another layout version
    foreign,
};

MUST_USE core::Status findOwner(Owner& owner);  // busy: in a later frame
// Of ours: a mark that is missing or damaged is written again by the other one. damaged: it was not
// only missing, as in EEPROMs from before there were two. busy: in a later frame.
MUST_USE core::Status mendMarks(bool& damaged);
MUST_USE core::Status claim();  // writes our marks; of use on a blank EEPROM only

// As hal::eepromWrite, but into another firmware's EEPROM nothing is written; that is ok too.
MUST_USE core::Status writeIfOurs(uint16_t address, const void* from, uint8_t size);

// Erases everything, a part each call, and claims it; `at` starts at 0. A power cut on the way
// leaves another firmware's EEPROM, never half of ours.
MUST_USE core::Status erase(uint16_t& at);

}  // namespace storage

// SPDX-License-Identifier: GPL-3.0-or-later
// Where the parameters of a table live while the power is off: each value, as the four bytes of a
// float, at its slot, written through the journal so that a cut leaves the old or the new value.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "parameters/table.hpp"
#include "storage/journal.hpp"

namespace parameters {

constexpr uint8_t kMaxRows = 240;  // a bit of RAM each; raise it by 8 when a table grows past it
static_assert(kMaxRows % 8 == 0, "the bits fill whole bytes");

// At boot: redoes what a cut interrupted, then gives every field its stored value, or the row's
// initial one where nothing is stored or what is stored is out of range. busy: call again.
MUST_USE core::Status load(const Table& table);

// What load() has found of them all, and how to accept them as they are: storage/journal.hpp.
using Found = storage::Journal::Found;
Found found();
MUST_USE core::Status trust();
bool takeWorn();
void erased();  // the whole EEPROM is

// Stores a value for the row; the field is the caller's. busy: no room yet, nothing was changed.
MUST_USE core::Status save(const Table& table, uint8_t index, float value);

// Leaves nothing stored for the row, so that the next load finds its initial value; the field
// stays. Past the journal: what a cut leaves is forgotten by asking again. trust() has to follow.
MUST_USE core::Status forget(const Table& table, uint8_t index);

// Stores the row's present value when there is room: saveWaiting carries it out.
void saveLater(uint8_t index);
void saveWaiting(const Table& table);

}  // namespace parameters

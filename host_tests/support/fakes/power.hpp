// SPDX-License-Identifier: GPL-3.0-or-later
// The power of the tests' memories: it fails in the middle of a write that the test has chosen.
// The program under test notices nothing and goes on with what it wrote.
#pragma once
#include <stdint.h>

namespace fakes {

// After `writes` more writes to EEPROM cells or DataFlash pages the power fails: the one then in
// flight is damaged and no later one arrives.
void cutPowerAfter(uint32_t writes);
bool powerWasCut();
uint64_t powerCut_us();  // when; UINT64_MAX: it has not been
void restorePower();

// What the damaged one leaves: with 0 as usual, a cell blank and a page full of noise; else a cell
// with noise, and a page with the first of the new bytes and behind them the old ones or noise.
void tearWrites(uint32_t seed);

// For the memories: what becomes of the write that begins now.
enum class Fate { done, damaged, lost };
Fate beginWrite();
bool tearsWrites();
uint32_t tornNoise();

}  // namespace fakes

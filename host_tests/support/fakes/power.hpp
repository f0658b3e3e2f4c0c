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

// For the memories: what becomes of the write that begins now.
enum class Fate { done, damaged, lost };
Fate beginWrite();

}  // namespace fakes

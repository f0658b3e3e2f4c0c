// SPDX-License-Identifier: GPL-3.0-or-later
// The 4 KiB EEPROM behind a queue. A byte takes 3.4 ms to write and a read must not touch the
// chip meanwhile, so nothing here waits: who gets `busy` asks again in a later frame.
#pragma once
#include <stdint.h>

#include "core/status.hpp"

namespace hal {

constexpr uint16_t kEepromSize = 4096;

// Reads `size` bytes; bytes still in the queue are seen as if written. `busy`: a byte is being
// written; the queue then rests after it until this reader has come back and been served (or
// 130 ms have passed), so asking again in a tenth of a second always succeeds. bad_argument: past
// the end.
MUST_USE core::Status eepromRead(uint16_t address, void* to, uint8_t size);

// Queues `size` bytes in address order; bytes that already hold their value are not written.
// Writes reach the chip in the order in which they were queued. `busy`: too little room for all
// of them, nothing was queued. At most kEepromQueue bytes a call.
// A byte that does not read back is written again, as the supply may have been low: at once, and
// then every 33 ms, between which others are read. After all its writes, 0.8 s, a cell is taken to
// be worn, and the next byte is written.
constexpr uint8_t kEepromQueue = 32;
constexpr uint8_t kEepromWrites = 25;
MUST_USE core::Status eepromWrite(uint16_t address, const void* from, uint8_t size);

bool eepromDrained();  // true when everything queued is in the chip

}  // namespace hal

// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ring of the logs begins in the DataFlash: a page, a multiple of 8, in four bytes of the
// EEPROM that hold it though one of their bits changes.
#pragma once
#include <stdint.h>

#include "core/status.hpp"

namespace storage {

// Where nothing was ever stored kNoLogBase. busy: in a later frame.
constexpr uint16_t kNoLogBase = 0xFFF8;
MUST_USE core::Status readLogBase(uint16_t& page);
// Into another firmware's EEPROM nothing is written, which is ok too.
MUST_USE core::Status writeLogBase(uint16_t page);

}  // namespace storage

// SPDX-License-Identifier: GPL-3.0-or-later
// One I2C transfer at a time, carried out by interrupts. Each user has a place for its own, so a
// result that waits to be fetched keeps nobody else from the bus.
#pragma once
#include <stdint.h>

#include "core/status.hpp"

namespace hal {

constexpr uint8_t kI2cBytes = 8;  // the longest transfer each way

enum class I2cUser : uint8_t { compass, barometer };  // a board may have the first ones only

// Starts: writes `out_size` bytes to the 7-bit address, then, after a repeated start, reads
// `in_size` bytes (either may be 0). False: a transfer is under way.
bool i2cStart(I2cUser user, uint8_t address, const uint8_t* out, uint8_t out_size, uint8_t in_size);

// `busy` while it runs; then once `ok` with the bytes read in `in`, or `timeout` when nobody
// answered or the bus hung. A hung bus (no end after 5 ms) is freed by clocking SCL here.
MUST_USE core::Status i2cResult(I2cUser user, uint8_t* in, uint8_t in_size);

}  // namespace hal

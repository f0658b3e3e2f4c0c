// SPDX-License-Identifier: GPL-3.0-or-later
// The tests' I2C bus: a device is a function from what was written to what is read.
#pragma once
#include <stdint.h>

#include <functional>
#include <vector>

#include "core/status.hpp"

namespace fakes {

struct I2cTransfer {
    uint8_t address;
    std::vector<uint8_t> out;
    uint8_t in_size;
};

struct I2c {
    // Returns the bytes read (as many as asked, missing ones are 0xFF); null: nobody answers.
    std::function<std::vector<uint8_t>(const I2cTransfer&)> device;
    core::Status status = core::Status::ok;  // of the next results, when a device is there
    uint8_t busy_polls = 0;                  // i2cResult answers busy this often
    std::vector<I2cTransfer> transfers;
};

I2c& i2c();
void resetI2c();

}  // namespace fakes

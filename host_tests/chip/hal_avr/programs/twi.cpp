// SPDX-License-Identifier: GPL-3.0-or-later
// A transfer of each kind, one after the other; then whatever the bus allows, for ever.
#include "hal/i2c.hpp"

#include "report.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

static void transfer(uint8_t address, const uint8_t* out, uint8_t out_size, uint8_t in_size) {
    uint8_t in[hal::kI2cBytes] = {};
    const uint32_t start_us = hal::now_us();
    report(1, hal::i2cStart(hal::I2cUser::compass, address, out, out_size, in_size));
    core::Status status;
    do {
        status = hal::i2cResult(hal::I2cUser::compass, in, in_size);
    } while (status == core::Status::busy);
    report(2, static_cast<uint16_t>(status));
    report(3, static_cast<uint16_t>(hal::now_us() - start_us));
    if (status == core::Status::ok) {
        for (uint8_t i = 0; i < in_size; ++i) report(4, in[i]);
    }
}

int main() {
    board::start();
    const uint8_t configure[] = {0x00, 0x78, 0x20, 0x00};
    const uint8_t data[] = {3};
    transfer(0x1E, configure, 4, 0);
    transfer(0x1E, data, 1, 6);
    transfer(0x1E, data, 0, 1);
    report(5, hal::i2cStart(hal::I2cUser::compass, 0x1E, data, 1, 9));
    report(6, hal::i2cStart(hal::I2cUser::compass, 0x1E, data, 1, 6));
    report(6, hal::i2cStart(hal::I2cUser::compass, 0x1E, data, 1, 6));
    wait_ms(2);
    uint8_t in[6];
    report(7, static_cast<uint16_t>(hal::i2cResult(hal::I2cUser::compass, in, 6)));
    report(7, static_cast<uint16_t>(hal::i2cResult(hal::I2cUser::compass, in, 6)));
    transfer(0x55, data, 1, 6);  // nobody there
    for (;;) {
        wait_ms(10);
        transfer(0x1E, data, 1, 6);
    }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "fakes/i2c.hpp"

#include "hal/i2c.hpp"

namespace {
fakes::I2c bus;
bool running = false;
uint8_t polls_left = 0;
}  // namespace

namespace fakes {

I2c& i2c() { return bus; }

void resetI2c() {
    bus = I2c();
    running = false;
}

}  // namespace fakes

namespace hal {

bool i2cStart(I2cUser, uint8_t address, const uint8_t* out, uint8_t out_size, uint8_t in_size) {
    if (running || out_size > kI2cBytes || in_size > kI2cBytes) return false;
    bus.transfers.push_back({address, std::vector<uint8_t>(out, out + out_size), in_size});
    running = true;
    polls_left = bus.busy_polls;
    return true;
}

core::Status i2cResult(I2cUser, uint8_t* in, uint8_t in_size) {
    if (!running) return core::Status::timeout;
    if (polls_left > 0) {
        --polls_left;
        return core::Status::busy;
    }
    running = false;
    if (!bus.device) return core::Status::timeout;
    if (bus.status != core::Status::ok) return bus.status;
    const std::vector<uint8_t> bytes = bus.device(bus.transfers.back());
    for (uint8_t i = 0; i < in_size; ++i) in[i] = i < bytes.size() ? bytes[i] : 0xFF;
    return core::Status::ok;
}

}  // namespace hal

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/native/i2c_bus.hpp"

#include <algorithm>

#include "simulator/devices/hmc5883l.hpp"

namespace simulator {

constexpr uint8_t kCompassAddress = 0x1E;  // HMC5883L datasheet: 7-bit address
constexpr double kBit_us = 2.5;            // 400 kHz
constexpr uint64_t kGivenUp_us = 5000;     // by hal/i2c.hpp, of a bus that hangs

bool I2cBus::start(uint8_t address, const uint8_t* out, uint8_t out_size, uint8_t in_size) {
    if (done_us_ != UINT64_MAX) return false;
    address_ = address;
    out_.assign(out, out + out_size);
    in_.assign(in_size, 0xFF);
    // an address byte for each way, nine bits a byte, start and stop
    const int bytes =
        address == kCompassAddress ? out_size + in_size + (out_size > 0) + (in_size > 0) : 1;
    done_us_ = now_us_ + static_cast<uint64_t>((9 * bytes + 3) * kBit_us) + 1;
    if (line_.stuck()) done_us_ = now_us_ + kGivenUp_us;
    status_ = core::Status::busy;
    return true;
}

void I2cBus::run() {
    if (now_us_ < done_us_) return;
    done_us_ = UINT64_MAX;
    status_ = core::Status::timeout;
    if (disturbed() || address_ != kCompassAddress || !writeAll()) return;
    status_ = core::Status::ok;
    readAll();
}

// A bus error ends the transfer.
bool I2cBus::disturbed() {
    bool error = line_.stuck();
    for (size_t i = 0; i < out_.size() + in_.size(); ++i) error = line_.hits() || error;
    return error;
}

bool I2cBus::writeAll() {
    if (out_.empty()) return true;
    bool taken = compass_.start(false, now_us_);
    for (const uint8_t byte : out_) taken = taken && compass_.write(byte, now_us_);
    if (in_.empty() || !taken) compass_.stop(now_us_);
    return taken;
}

void I2cBus::readAll() {
    if (in_.empty()) return;
    if (!compass_.start(true, now_us_)) {
        status_ = core::Status::timeout;
    } else {
        for (uint8_t& byte : in_)
            byte = line_.through(compass_.read(&byte != &in_.back(), now_us_));
    }
    compass_.stop(now_us_);
}

core::Status I2cBus::result(uint8_t* in, uint8_t in_size) {
    const core::Status status = status_;
    if (status == core::Status::ok) {
        std::copy_n(in_.begin(), std::min<size_t>(in_size, in_.size()), in);
        status_ = core::Status::timeout;
    }
    return status;
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// The I2C bus with the compass on it: a transfer is carried out when its bus time is over.
#pragma once
#include <cstdint>
#include <vector>

#include "core/status.hpp"
#include "simulator/devices/line_fault.hpp"

namespace simulator {

class Hmc5883l;

class I2cBus {
public:
    I2cBus(const uint64_t& now_us, Hmc5883l& compass) : now_us_(now_us), compass_(compass) {}

    bool start(uint8_t address, const uint8_t* out, uint8_t out_size, uint8_t in_size);
    core::Status result(uint8_t* in, uint8_t in_size);

    void fail(FaultKind kind) { line_.fail(kind); }
    void restart() { done_us_ = UINT64_MAX, status_ = core::Status::timeout; }

    uint64_t due_us() const { return done_us_; }
    void run();

private:
    bool disturbed();
    bool writeAll();
    void readAll();

    const uint64_t& now_us_;
    Hmc5883l& compass_;
    uint8_t address_ = 0;
    std::vector<uint8_t> out_, in_;
    uint64_t done_us_ = UINT64_MAX;
    LineFault line_{1};
    core::Status status_ = core::Status::timeout;
};

}  // namespace simulator

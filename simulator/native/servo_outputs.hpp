// SPDX-License-Identifier: GPL-3.0-or-later
// The timers behind libraries/hal/servo_output.hpp: widths are taken over at the start of a
// period, and the World gets a pulse's width when the pulse has ended.
#pragma once
#include <array>
#include <cstdint>

#include "hal/servo_output.hpp"

namespace simulator {

class World;

class ServoOutputs {
public:
    ServoOutputs(const uint64_t& now_us, World& world) : now_us_(now_us), world_(world) {}

    void start(uint16_t rate_hz);
    void write(uint8_t output, uint16_t pulse_halfus);
    uint16_t read(uint8_t output) const;

    void restart() { due_us_ = UINT64_MAX, wanted_halfus_ = running_halfus_ = {}; }

    uint64_t due_us() const { return due_us_; }
    void run();

private:
    const uint64_t& now_us_;
    World& world_;
    std::array<uint16_t, hal::kServos> wanted_halfus_{}, running_halfus_{};
    uint64_t period_us_ = 20'000;
    uint64_t due_us_ = UINT64_MAX;
    bool pulses_run_ = false;  // next comes their end, not the start of a period
};

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/native/servo_outputs.hpp"

#include <algorithm>

#include "simulator/world.hpp"

namespace simulator {

constexpr uint64_t kLongestPulse_us = 2200;

void ServoOutputs::start(uint16_t rate_hz) {
    wanted_halfus_.fill(0);
    running_halfus_.fill(0);
    period_us_ = 1'000'000 / rate_hz;
    due_us_ = now_us_ + period_us_;
    pulses_run_ = false;
}

void ServoOutputs::write(uint8_t output, uint16_t pulse_halfus) {
    if (output < hal::kServos) wanted_halfus_[output] = pulse_halfus;
}

uint16_t ServoOutputs::read(uint8_t output) const {
    return output < hal::kServos ? wanted_halfus_[output] : 0;
}

void ServoOutputs::run() {
    if (now_us_ < due_us_) return;
    if (pulses_run_) {
        for (int i = 0; i < hal::kServos; ++i) {
            if (running_halfus_[i] > 0) world_.servoPulse(i + 1, running_halfus_[i] * 0.5, now_us_);
        }
        due_us_ += period_us_ - kLongestPulse_us;
    } else {
        running_halfus_ = wanted_halfus_;
        due_us_ += kLongestPulse_us;
    }
    pulses_run_ = !pulses_run_;
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// The converter behind libraries/hal/analog.hpp: one scan reads the airspeed several times and
// the other inputs once, and is added to the sums when its conversion time is over.
#pragma once
#include <array>
#include <cstdint>

#include "hal/analog.hpp"

namespace simulator {

class World;

class AnalogInputs {
public:
    AnalogInputs(const uint64_t& now_us, World& world) : now_us_(now_us), world_(world) {}

    void scan();
    hal::AnalogSum take(hal::Analog input);

    void restart() { done_us_ = UINT64_MAX, sums_ = {}; }

    uint64_t due_us() const { return done_us_; }
    void run();

private:
    uint16_t reading(int pin);
    uint16_t counts(double input_v) const;
    void add(hal::Analog input, uint16_t reading);

    const uint64_t& now_us_;
    World& world_;
    std::array<hal::AnalogSum, hal::kAnalogs> sums_{};
    uint64_t done_us_ = UINT64_MAX;
};

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/native/analog_inputs.hpp"

#include <algorithm>
#include <cmath>

#include "simulator/world.hpp"

namespace simulator {

constexpr int kAirspeedPin = 0, kVoltagePin = 13, kCurrentPin = 12;  // A0, power module A13, A12
constexpr int kAirspeedReadings = 8;
constexpr uint64_t kConversion_us = 104;  // 13 ADC clocks of 125 kHz, datasheet 26.4

void AnalogInputs::scan() {
    if (done_us_ == UINT64_MAX) done_us_ = now_us_ + (kAirspeedReadings + 3) * kConversion_us;
}

void AnalogInputs::run() {
    if (now_us_ < done_us_) return;
    done_us_ = UINT64_MAX;
    for (int i = 0; i < kAirspeedReadings; ++i) add(hal::Analog::airspeed, reading(kAirspeedPin));
    add(hal::Analog::battery_voltage, reading(kVoltagePin));
    add(hal::Analog::battery_current, reading(kCurrentPin));
    add(hal::Analog::board_voltage, counts(world_.bandGap_v()));
}

uint16_t AnalogInputs::reading(int pin) { return counts(world_.analog_v(pin, now_us_)); }

uint16_t AnalogInputs::counts(double input_v) const {
    const double counts = std::floor(input_v / world_.supply_v(now_us_) * 1024);
    return static_cast<uint16_t>(std::clamp(counts, 0.0, 1023.0));
}

void AnalogInputs::add(hal::Analog input, uint16_t reading) {
    hal::AnalogSum& sum = sums_[static_cast<size_t>(input)];
    if (sum.count >= 64) return;  // 64 readings of 1023 fill the sum
    sum.sum = static_cast<uint16_t>(sum.sum + reading);
    ++sum.count;
}

hal::AnalogSum AnalogInputs::take(hal::Analog input) {
    hal::AnalogSum& sum = sums_[static_cast<size_t>(input)];
    const hal::AnalogSum taken = sum;
    sum = {0, 0};
    return taken;
}

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// The board's analogue pins: MPXV7002DP airspeed on A0, power module on A12 (17 A/V) and A13
// (1:10.1), supply 5.00 V. Every reading is noisy; the ADC rounds, not this.
#pragma once
#include <cstdint>

#include "simulator/devices/errors.hpp"
#include "simulator/devices/faults.hpp"
#include "simulator/devices/random.hpp"

namespace simulator {

struct Truth;

class AnalogSensors {
public:
    static constexpr int kAirspeedPin = 0, kCurrentPin = 12, kVoltagePin = 13;
    static constexpr double kSupply_v = 5.0;

    explicit AnalogSensors(uint64_t seed = 1, const SensorErrors& errors = {});

    // Jumping, its tube is off: it reads still air.
    void fail(FaultKind kind, double for_s = 0) { fault_.fail(kind, for_s); }

    double volts(int pin, const Truth& truth);  // pins A0..A15; unused ones are at 0

private:
    double airspeed_v(const Truth& truth);

    const SensorErrors errors_;
    Random random_;
    double ratio_;  // of the pressure, about 1
    FaultyValue fault_;
    double zero_v_;  // the sensor's own offset
};

}  // namespace simulator

// SPDX-License-Identifier: GPL-3.0-or-later
// The gyros (IDG-500, ISZ-500) and the accelerometer (ADXL335) of the first board's shield, as the
// voltages at its converter: inputs 0..2 yaw, roll and pitch rate, 3 the gyros' temperature, 4..6
// the accelerometer's axes. Their bandwidth, 50 Hz and more, is above all that an airplane does.
#pragma once
#include <array>
#include <cstdint>

#include "simulator/devices/errors.hpp"
#include "simulator/devices/faults.hpp"
#include "simulator/devices/random.hpp"

namespace simulator {

struct Truth;

class AnalogImu {
public:
    explicit AnalogImu(uint64_t seed = 1, const SensorErrors& errors = {});

    void fail(FaultKind kind, double for_s = 0);
    double volts(int input, const Truth& truth);  // noisy at every call

private:
    std::array<FaultyValue, 8> faults_;
    double good_v(int input, const Truth& truth);
    double rate_v(int input, double rate_rads, double throttle);
    double force_v(int input, double force_mss, double throttle);

    const SensorErrors errors_;
    Random random_;
    std::array<double, 7> bias_{};   // deg/s and g
    std::array<double, 7> scale_{};  // of the accelerometers
};

}  // namespace simulator

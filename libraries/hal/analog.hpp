// SPDX-License-Identifier: GPL-3.0-or-later
// Analogue inputs by the part they play, converted by interrupt when asked.
#pragma once
#include <stdint.h>

namespace hal {

enum class Analog : uint8_t { airspeed, battery_voltage, battery_current, board_voltage };
constexpr uint8_t kAnalogs = 4;

struct AnalogSum {
    uint16_t sum;  // of 10-bit readings
    uint8_t count;
};

// Starts one scan of all inputs (airspeed several times) unless one is still running.
void analogScan();

// Takes what was summed since the last call and starts a new sum; count 0: nothing new.
// board_voltage reads the 1.1 V band gap against the supply: Vcc_mV = 1126400 / reading.
AnalogSum analogTake(Analog input);

}  // namespace hal

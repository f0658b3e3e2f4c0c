// SPDX-License-Identifier: GPL-3.0-or-later
// Eight servo outputs, refreshed by the timers alone.
#pragma once
#include <stdint.h>

namespace hal {

constexpr uint8_t kServos = 8;

void servoStart(uint16_t rate_hz);  // 50..400; all outputs silent afterwards

// The pulse in half microseconds, taken over at the next period without a glitch; 0 silences.
void servoWrite(uint8_t output, uint16_t pulse_halfus);
uint16_t servoRead(uint8_t output);  // what was last written

}  // namespace hal
